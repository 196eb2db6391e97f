// SPDX-License-Identifier: Apache-2.0
#include "dioptre/io/image/read_image.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
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

/// Whether the values of an image are known as light, by a gamma or by what its file says, and not
/// taken as they are.
bool is_light(const DecodedImage& image, const ReadImageOptions& options) {
  using Curve = DecodedImage::Curve;
  if (options.gamma) return true;
  if (image.curve == Curve::kUnknown) return options.language_version >= 3.7;
  return image.curve != Curve::kAsStored;
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
  if (curve == DecodedImage::Curve::kLinear || curve == DecodedImage::Curve::kAsStored) return;
  const std::uint32_t colors = data.channels < 3 ? 1 : 3;
  for (std::size_t at = 0; at < data.pixels.size(); at += data.channels) {
    for (std::uint32_t k = 0; k < colors; ++k) {
      data.pixels[at + k] = decode_value(data.pixels[at + k], curve, gamma);
    }
  }
}

/// The decoder that gives the numbers of a palette's entries, where there is one.
Decoder for_indices(Decoder decode) {
  if (decode == decode_png) return decode_png_indices;
  return decode == decode_simple ? decode_simple_indices : decode;
}

/// Rounds light down to whole 255ths. The grey of a colour without hue is a hair under its parts.
void keep_light_in_bytes(ImageData& data) {
  for (float& light : data.pixels) {
    const float grey = light * 0.297f + light * 0.589f + light * 0.114f;
    light = std::floor(grey * 255) / 255;
  }
}

/// Turns linear light into the values of a scene of that gamma; alpha stays.
void to_working_values(ImageData& data, double gamma) {
  if (gamma == 1) return;
  linearize(data, DecodedImage::Curve::kPower, 1 / gamma);
}

/// What is known of the entries of a palette by their numbers.
using OfEntries = std::array<std::optional<float>, 256>;

OfEntries of_entries(const std::vector<EntryShare>& shares) {
  OfEntries known;
  for (const EntryShare& e : shares) known[e.entry] = e.share;
  return known;
}

/// The pixels with an alpha channel that says what the entries of the palette let through, and a
/// fifth if some of it is filtered.
ImageData with_transparency(const ImageData& colors, const ImageData& numbers,
                            const ReadImageOptions& options) {
  const OfEntries transmits = of_entries(options.entry_transmits);
  const OfEntries filters = of_entries(options.entry_filters);
  const std::uint32_t shades = colors.channels < 3 ? 1 : 3;
  const bool with_alpha = colors.channels > shades && !options.opaque_palette;
  const bool filtered = !options.entry_filters.empty();
  const bool transparent = with_alpha || filtered || !options.entry_transmits.empty();
  ImageData out{colors.width, colors.height, filtered ? 5 : shades + (transparent ? 1 : 0), {}};
  out.pixels.reserve(numbers.pixels.size() * out.channels);
  for (std::size_t k = 0; k < numbers.pixels.size(); ++k) {
    const float* from = &colors.pixels[k * colors.channels];
    const auto entry = static_cast<std::uint8_t>(numbers.pixels[k]);
    for (std::uint32_t i = 0; i < (filtered ? 3 : shades); ++i) {
      out.pixels.push_back(from[std::min(i, shades - 1)]);
    }
    const float alpha = with_alpha ? from[shades] : 1;
    if (transparent) out.pixels.push_back(transmits[entry] ? 1 - *transmits[entry] : alpha);
    if (filtered) out.pixels.push_back(filters[entry].value_or(0));
  }
  return out;
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
  if (options.palette_scale != 0) decode = for_indices(decode);
  Result<DecodedImage> image = decode(*bytes, options.max_pixels);
  if (!image) return cannot_read(path, image.error().message);
  if (image->curve == DecodedImage::Curve::kIndices) {
    for (float& number : image->data.pixels) number *= options.palette_scale;
    return std::move(image->data);
  }
  const auto curve =
      options.gamma ? DecodedImage::Curve::kPower : resolve(*image, options.language_version);
  linearize(image->data, curve, options.gamma.value_or(image->gamma));
  if (is_light(*image, options)) to_working_values(image->data, options.working_gamma);
  if (image->grey_bytes && options.grey_light_bytes) keep_light_in_bytes(image->data);
  const bool by_entry = !options.entry_transmits.empty() || !options.entry_filters.empty();
  if (!by_entry && !options.opaque_palette) return std::move(image->data);
  const Result<DecodedImage> numbers = for_indices(decode)(*bytes, options.max_pixels);
  const bool has_palette =
      numbers && numbers->curve == DecodedImage::Curve::kIndices &&
      numbers->data.pixels.size() * image->data.channels == image->data.pixels.size();
  if (has_palette) return with_transparency(image->data, numbers->data, options);
  if (!by_entry) return std::move(image->data);
  return cannot_read(path, "it has no palette whose colours could let light through");
}

}  // namespace dioptre
