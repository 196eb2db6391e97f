// SPDX-License-Identifier: Apache-2.0
#include <ImathBox.h>
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfInputFile.h>

#include <cstring>
#include <stdexcept>

#include "dioptre/codecs/codecs.h"

namespace dioptre::codecs {
namespace {

/// An OpenEXR stream over bytes in memory.
class MemoryStream : public Imf::IStream {
 public:
  explicit MemoryStream(std::string_view bytes) : Imf::IStream("memory"), bytes_(bytes) {}
  bool read(char out[], int size) override {
    const auto count = static_cast<std::uint64_t>(size);
    if (size < 0 || at_ > bytes_.size() || count > bytes_.size() - at_) {
      throw std::runtime_error("the file ends too early");
    }
    std::memcpy(out, bytes_.data() + at_, count);
    at_ += count;
    return at_ < bytes_.size();
  }
  std::uint64_t tellg() override { return at_; }
  void seekg(std::uint64_t at) override { at_ = at; }

 private:
  std::string_view bytes_;
  std::uint64_t at_ = 0;
};

Result<DecodedImage> decode(MemoryStream& stream, std::uint64_t max_pixels) {
  Imf::InputFile file(stream, 0);
  const Imath::Box2i window = file.header().dataWindow();
  const auto extent = [](int low, int high) {
    return high < low ? 0 : static_cast<std::uint64_t>(std::int64_t{high} - low + 1);
  };
  const std::uint64_t width = extent(window.min.x, window.max.x);
  const std::uint64_t height = extent(window.min.y, window.max.y);
  if (const auto size = check_image_size(width, height, max_pixels); !size) {
    return tl::unexpected(size.error());
  }
  const Imf::ChannelList& channels = file.header().channels();
  const bool color = channels.findChannel("R") != nullptr;
  if (!color && channels.findChannel("Y") == nullptr) return fail("it has no R, G, B or Y channel");
  const bool alpha = channels.findChannel("A") != nullptr;
  DecodedImage image;
  image.curve = DecodedImage::Curve::kLinear;
  ImageData& data = image.data;
  data.width = static_cast<std::uint32_t>(width);
  data.height = static_cast<std::uint32_t>(height);
  data.channels = (color ? 3 : 1) + (alpha ? 1 : 0);
  data.pixels.resize(std::size_t{width} * height * data.channels);
  const char* const names[] = {color ? "R" : "Y", "G", "B"};
  const std::size_t step = sizeof(float) * data.channels;
  Imf::FrameBuffer frame;
  const auto add = [&](const char* name, std::uint32_t at) {
    frame.insert(name,
                 Imf::Slice::Make(Imf::FLOAT, data.pixels.data() + at, window, step, step * width));
  };
  for (std::uint32_t k = 0; k < (color ? 3u : 1u); ++k) add(names[k], k);
  if (alpha) add("A", data.channels - 1);
  file.setFrameBuffer(frame);
  file.readPixels(window.min.y, window.max.y);
  return image;
}

}  // namespace

Result<DecodedImage> decode_exr(std::string_view bytes, std::uint64_t max_pixels) {
  MemoryStream stream(bytes);
  try {
    return decode(stream, max_pixels);
  } catch (const std::exception& error) {
    return fail(std::string(error.what()) + " (at byte " + std::to_string(stream.tellg()) + ")");
  }
}

}  // namespace dioptre::codecs
