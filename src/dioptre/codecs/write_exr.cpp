// SPDX-License-Identifier: Apache-2.0
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfOutputFile.h>
#include <half.h>

#include <array>
#include <cstring>
#include <type_traits>
#include <vector>

#include "dioptre/codecs/codecs.h"

namespace dioptre::codecs {
namespace {

/// An OpenEXR stream into memory.
class MemoryStream : public Imf::OStream {
 public:
  MemoryStream() : Imf::OStream("memory") {}
  void write(const char data[], int size) override {
    if (bytes_.size() < at_ + size) bytes_.resize(at_ + size);
    std::memcpy(bytes_.data() + at_, data, static_cast<std::size_t>(size));
    at_ += static_cast<std::size_t>(size);
  }
  std::uint64_t tellp() override { return at_; }
  void seekp(std::uint64_t at) override { at_ = at; }
  const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
  std::size_t at_ = 0;
};

float alpha_of(const Image& image, std::size_t at) {
  return image.alpha.empty() ? 1.0f : image.alpha[at];
}

/// One pixel in file order; colours multiplied by alpha.
std::array<float, 4> exr_pixel(const Image& image, std::size_t at) {
  const float alpha = alpha_of(image, at);
  const Color c = image.pixels[at] * alpha;
  return {c.r, c.g, c.b, alpha};
}

/// A file that is being made ready: its channels and where their values are.
class ExrFile {
 public:
  ExrFile(std::uint32_t width, std::uint32_t height)
      : header_(static_cast<int>(width), static_cast<int>(height)), width_(width), height_(height) {
    header_.compression() = Imf::ZIP_COMPRESSION;
  }

  /// Adds channels whose values stand together for each pixel; `values` must outlive the file.
  template <class Value>
  void add(const std::vector<std::string>& names, const std::vector<Value>& values) {
    const auto type = std::is_same_v<Value, float> ? Imf::FLOAT : Imf::HALF;
    const std::size_t step = names.size() * sizeof(Value);
    for (std::size_t k = 0; k < names.size(); ++k) {
      header_.channels().insert(names[k], Imf::Channel(type));
      // The library only reads from what it is to write.
      char* const first = reinterpret_cast<char*>(const_cast<Value*>(values.data() + k));
      frame_.insert(names[k], Imf::Slice(type, first, step, step * width_));
    }
  }

  std::string bytes() const {
    MemoryStream stream;
    {
      Imf::OutputFile file(stream, header_, 0);
      file.setFrameBuffer(frame_);
      file.writePixels(static_cast<int>(height_));
    }
    return stream.bytes();
  }

 private:
  Imf::Header header_;
  Imf::FrameBuffer frame_;
  std::size_t width_, height_;
};

/// Light multiplied by alpha.
std::vector<float> times_alpha(const ImageLayer& layer, const Image& image) {
  std::vector<float> values = layer.values;
  for (std::size_t i = 0; i < values.size(); ++i) values[i] *= alpha_of(image, i / 3);
  return values;
}

template <class Value>
std::string exr_bytes(const Image& image, std::span<const ImageLayer> layers) {
  const std::size_t channels = image.alpha.empty() ? 3 : 4;
  std::vector<Value> values;
  values.reserve(image.pixels.size() * channels);
  for (std::size_t at = 0; at < image.pixels.size(); ++at) {
    const auto pixel = exr_pixel(image, at);
    for (std::size_t k = 0; k < channels; ++k) values.push_back(Value(pixel[k]));
  }
  ExrFile file(image.width, image.height);
  std::vector<std::string> names{"R", "G", "B"};
  if (channels == 4) names.push_back("A");
  file.add(names, values);
  std::vector<std::vector<float>> kept;
  kept.reserve(layers.size());
  for (const ImageLayer& layer : layers) {
    names.clear();
    for (const char channel : layer.channels) names.push_back(layer.name + "." + channel);
    const bool dimmed = layer.channels == "RGB" && !image.alpha.empty();
    file.add(names, dimmed ? kept.emplace_back(times_alpha(layer, image)) : layer.values);
  }
  return file.bytes();
}

}  // namespace

Result<std::string> encode_exr(const Image& linear, std::span<const ImageLayer> layers, bool half) {
  try {
    return half ? exr_bytes<::half>(linear, layers) : exr_bytes<float>(linear, layers);
  } catch (const std::exception& error) {
    return fail(error.what());
  }
}

}  // namespace dioptre::codecs
