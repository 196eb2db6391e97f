// SPDX-License-Identifier: Apache-2.0
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfOutputFile.h>
#include <half.h>

#include <array>
#include <cstring>

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

/// One pixel in file order; colours multiplied by alpha.
std::array<float, 4> exr_pixel(const Image& image, std::size_t at) {
  const float alpha = image.alpha.empty() ? 1.0f : image.alpha[at];
  const Color c = image.pixels[at] * alpha;
  return {c.r, c.g, c.b, alpha};
}

template <class Value>
std::string exr_bytes(const Image& image, Imf::PixelType type) {
  const std::size_t channels = image.alpha.empty() ? 3 : 4;
  std::vector<Value> values;
  values.reserve(image.pixels.size() * channels);
  for (std::size_t at = 0; at < image.pixels.size(); ++at) {
    const auto pixel = exr_pixel(image, at);
    for (std::size_t k = 0; k < channels; ++k) values.push_back(Value(pixel[k]));
  }
  Imf::Header header(static_cast<int>(image.width), static_cast<int>(image.height));
  header.compression() = Imf::ZIP_COMPRESSION;
  Imf::FrameBuffer frame;
  constexpr const char* kNames[] = {"R", "G", "B", "A"};
  for (std::size_t k = 0; k < channels; ++k) {
    header.channels().insert(kNames[k], Imf::Channel(type));
    frame.insert(kNames[k],
                 Imf::Slice(type, reinterpret_cast<char*>(values.data() + k),
                            channels * sizeof(Value), channels * sizeof(Value) * image.width));
  }
  MemoryStream stream;
  {
    Imf::OutputFile file(stream, header, 0);
    file.setFrameBuffer(frame);
    file.writePixels(static_cast<int>(image.height));
  }
  return stream.bytes();
}

}  // namespace

Result<std::string> encode_exr(const Image& linear, bool half) {
  try {
    return half ? exr_bytes<::half>(linear, Imf::HALF) : exr_bytes<float>(linear, Imf::FLOAT);
  } catch (const std::exception& error) {
    return fail(error.what());
  }
}

}  // namespace dioptre::codecs
