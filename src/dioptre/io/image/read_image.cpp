// SPDX-License-Identifier: Apache-2.0
#include "dioptre/io/image/read_image.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cctype>
#include <cerrno>
#include <cmath>
#include <cstring>

#include "dioptre/io/image/decoders.h"

namespace dioptre {
namespace {

constexpr std::uint64_t kMaxFileBytes = std::uint64_t{1} << 32;

tl::unexpected<Error> cannot_read(const std::string& path, const std::string& why) {
  return fail("cannot read the image " + path + ": " + why);
}

/// The whole of a regular file; pipes and devices could go on for ever and are refused.
Result<std::string> read_bytes(const std::string& path) {
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (file < 0) return fail(std::strerror(errno));
  struct stat about {};
  std::string bytes;
  std::string problem;
  if (::fstat(file, &about) != 0 || !S_ISREG(about.st_mode)) {
    problem = "not a regular file";
  } else if (static_cast<std::uint64_t>(about.st_size) > kMaxFileBytes) {
    problem = "the file is larger than 4 GiB";
  } else {
    bytes.resize(static_cast<std::size_t>(about.st_size));
    std::size_t at = 0;
    while (at < bytes.size()) {
      const ssize_t got = ::read(file, bytes.data() + at, bytes.size() - at);
      if (got < 0 && errno == EINTR) continue;
      if (got < 0) problem = std::strerror(errno);
      if (got <= 0) break;
      at += static_cast<std::size_t>(got);
    }
    bytes.resize(at);
  }
  ::close(file);
  if (!problem.empty()) return fail(problem);
  return bytes;
}

bool has_tga_name(const std::string& path) {
  if (path.size() < 4) return false;
  std::string end = path.substr(path.size() - 4);
  for (char& c : end) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return end == ".tga";
}

using Decoder = Result<DecodedImage> (*)(std::string_view, std::uint64_t);

struct Format {
  std::string_view start;
  Decoder decode;
};
constexpr Format kFormats[] = {
    {"\x89PNG", decode_png},
    {"\xff\xd8\xff", decode_jpeg},
    {std::string_view("II*\0", 4), decode_tiff},
    {std::string_view("MM\0*", 4), decode_tiff},
    {"\x76\x2f\x31\x01", decode_exr},
    {"#?", decode_hdr},
    {"GIF8", decode_simple},
    {"BM", decode_simple},
    {"P2", decode_pnm},
    {"P3", decode_pnm},
    {"P5", decode_pnm},
    {"P6", decode_pnm},
};

Decoder find_decoder(std::string_view bytes, const std::string& path) {
  for (const Format& format : kFormats) {
    if (bytes.starts_with(format.start)) return format.decode;
  }
  return has_tga_name(path) ? decode_simple : nullptr;
}

/// What the colour values of a file without a gamma of its own mean.
DecodedImage::Curve resolve(const DecodedImage& image, double language_version) {
  if (image.curve != DecodedImage::Curve::kUnknown) return image.curve;
  return language_version < 3.7 ? DecodedImage::Curve::kLinear : DecodedImage::Curve::kSrgb;
}

float decode_value(float value, DecodedImage::Curve curve, double gamma) {
  if (!(value > 0)) return 0;
  if (curve == DecodedImage::Curve::kPower) {
    return static_cast<float>(std::pow(double{value}, gamma));
  }
  return static_cast<float>(value <= 0.04045 ? value / 12.92
                                             : std::pow((value + 0.055) / 1.055, 2.4));
}

/// Turns the colour channels into linear light; alpha stays.
void linearize(ImageData& data, DecodedImage::Curve curve, double gamma) {
  if (curve == DecodedImage::Curve::kLinear) return;
  const std::uint32_t colors = data.channels < 3 ? 1 : 3;
  for (std::size_t at = 0; at < data.pixels.size(); at += data.channels) {
    for (std::uint32_t k = 0; k < colors; ++k) {
      data.pixels[at + k] = decode_value(data.pixels[at + k], curve, gamma);
    }
  }
}

}  // namespace

Result<ImageData> read_image(const std::string& path, const ReadImageOptions& options) {
  if (options.gamma && !(*options.gamma > 0 && std::isfinite(*options.gamma))) {
    return cannot_read(path, "the gamma must be a positive number");
  }
  Result<std::string> bytes = read_bytes(path);
  if (!bytes) return cannot_read(path, bytes.error().message);
  if (bytes->empty()) return cannot_read(path, "the file is empty");
  Decoder decode = find_decoder(*bytes, path);
  if (decode == nullptr) return cannot_read(path, "not an image of a known format");
  if (options.palette_scale != 0 && decode == decode_png) decode = decode_png_indices;
  Result<DecodedImage> image = decode(*bytes, options.max_pixels);
  if (!image) return cannot_read(path, image.error().message);
  if (image->curve == DecodedImage::Curve::kIndices) {
    for (float& number : image->data.pixels) number *= options.palette_scale;
    return std::move(image->data);
  }
  if (options.gamma) {
    linearize(image->data, DecodedImage::Curve::kPower, *options.gamma);
  } else {
    linearize(image->data, resolve(*image, options.language_version), image->gamma);
  }
  return std::move(image->data);
}

}  // namespace dioptre
