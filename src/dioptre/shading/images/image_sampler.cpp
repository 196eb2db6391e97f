// SPDX-License-Identifier: Apache-2.0
#include "dioptre/shading/images/image_sampler.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace dioptre {
namespace {

double fraction(double v) { return v - std::floor(v); }

/// The angle about the y axis in turns, in [0, 1), from +x to +z.
double turn(Vec3 p) { return fraction(std::atan2(p.z, p.x) / (2 * std::numbers::pi)); }

/// The weight of a pixel at distance d in cubic convolution (R. Keys, "Cubic Convolution
/// Interpolation for Digital Image Processing", 1981, a = -1/2).
double keys_weight(double d) {
  d = std::fabs(d);
  if (d <= 1) return (1.5 * d - 2.5) * d * d + 1;
  return d < 2 ? ((-0.5 * d + 2.5) * d - 4) * d + 2 : 0;
}

}  // namespace

ImageSampler::ImageSampler(const ImageSource& source) : source_(source) {
  const ImageData& data = *source_.data;
  opaque_ = !source_.once && source_.filter_all == 0 && source_.transmit_all == 0 &&
            (data.channels == 1 || data.channels == 3) && !data.pixels.empty();
}

std::optional<Vec2> ImageSampler::place(Vec3 p) const {
  const ImageData& data = *source_.data;
  if (data.width == 0 || data.height == 0 || !is_finite(p)) return std::nullopt;
  Vec2 uv{p.x, p.y};
  switch (source_.mapping) {
    case ImageSource::Mapping::kPlanar:
      break;
    case ImageSource::Mapping::kSpherical: {
      const double size = length(p);
      const double sine = size > 0 ? std::clamp(p.y / size, -1.0, 1.0) : 0;
      return Vec2{turn(p), std::min(0.5 + std::asin(sine) / std::numbers::pi, 1 - 1e-12)};
    }
    case ImageSource::Mapping::kCylindrical:
      uv = {turn(p), p.y};
      break;
    case ImageSource::Mapping::kToroidal: {
      const double across = std::hypot(p.x, p.z) - 1;
      uv = {turn(p), fraction(0.5 + std::atan2(p.y, across) / (2 * std::numbers::pi))};
      break;
    }
  }
  if (source_.once && (uv.x < 0 || uv.x > 1 || uv.y < 0 || uv.y > 1)) return std::nullopt;
  if (source_.once) return Vec2{std::min(uv.x, 1 - 1e-12), std::min(uv.y, 1 - 1e-12)};
  return Vec2{fraction(uv.x), fraction(uv.y)};
}

ImageSampler::Texel ImageSampler::texel(std::int64_t column, std::int64_t row) const {
  const ImageData& data = *source_.data;
  const auto width = static_cast<std::int64_t>(data.width);
  const auto height = static_cast<std::int64_t>(data.height);
  if (source_.once) {
    column = std::clamp<std::int64_t>(column, 0, width - 1);
    row = std::clamp<std::int64_t>(row, 0, height - 1);
  } else {
    column = ((column % width) + width) % width;
    row = ((row % height) + height) % height;
  }
  // Rows of the data go down.
  const auto at = static_cast<std::size_t>((height - 1 - row) * width + column) * data.channels;
  if (at + data.channels > data.pixels.size()) return {};
  const float* pixel = &data.pixels[at];
  switch (data.channels) {
    case 1:
      return {{pixel[0], pixel[0], pixel[0], 1, 0}};
    case 2:
      return {{pixel[0], pixel[0], pixel[0], pixel[1], 0}};
    case 3:
      return {{pixel[0], pixel[1], pixel[2], 1, 0}};
    case 4:
      return {{pixel[0], pixel[1], pixel[2], pixel[3], 0}};
    default:
      return {{pixel[0], pixel[1], pixel[2], pixel[3], pixel[4]}};
  }
}

/// The weighted mean of the pixels at offsets from..to of a pixel in both directions.
template <class Weight>
ImageSampler::Texel ImageSampler::weighted(std::int64_t column, std::int64_t row, int from, int to,
                                           Weight weight) const {
  double sum[5] = {}, total = 0;
  for (int j = from; j <= to; ++j) {
    for (int i = from; i <= to; ++i) {
      const double w = weight(i, j);
      const Texel t = texel(column + i, row + j);
      for (int k = 0; k < 5; ++k) sum[k] += w * t.channel[k];
      total += w;
    }
  }
  Texel mean;
  for (int k = 0; k < 5; ++k) mean.channel[k] = static_cast<float>(sum[k] / total);
  return mean;
}

ImageSampler::Texel ImageSampler::sample(Vec2 uv) const {
  const double x = uv.x * source_.data->width, y = uv.y * source_.data->height;
  if (source_.interpolation == ImageSource::Interpolation::kNone) {
    return texel(static_cast<std::int64_t>(std::floor(x)),
                 static_cast<std::int64_t>(std::floor(y)));
  }
  const double left = std::floor(x - 0.5), below = std::floor(y - 0.5);
  const double a = x - 0.5 - left, b = y - 0.5 - below;
  const auto column = static_cast<std::int64_t>(left), row = static_cast<std::int64_t>(below);
  switch (source_.interpolation) {
    case ImageSource::Interpolation::kBicubic:
      return weighted(column, row, -1, 2,
                      [&](int i, int j) { return keys_weight(a - i) * keys_weight(b - j); });
    case ImageSource::Interpolation::kNormalizedDistance:
      return weighted(column, row, 0, 1, [&](int i, int j) {
        return 1 / std::max((a - i) * (a - i) + (b - j) * (b - j), 1e-20);
      });
    default:
      return weighted(column, row, 0, 1,
                      [&](int i, int j) { return (i ? a : 1 - a) * (j ? b : 1 - b); });
  }
}

std::optional<PigmentColor> ImageSampler::color(Vec3 p) const {
  const auto uv = place(p);
  if (!uv) return std::nullopt;
  const Texel t = sample(*uv);
  return PigmentColor{{t.channel[0], t.channel[1], t.channel[2]},
                      static_cast<float>(source_.filter_all) + t.channel[4],
                      static_cast<float>(source_.transmit_all) + 1 - t.channel[3]};
}

double ImageSampler::height_of(const Texel& t) const {
  if (source_.use_alpha) return 1 - t.channel[3];
  return static_cast<double>(gray({t.channel[0], t.channel[1], t.channel[2]}));
}

double ImageSampler::height(Vec3 p) const {
  const auto uv = place(p);
  return uv ? height_of(sample(*uv)) : 0;
}

std::optional<Vec2> ImageSampler::lean(Vec3 p) const {
  const auto uv = place(p);
  if (!uv) return std::nullopt;
  const double column = 1.0 / source_.data->width, row = 1.0 / source_.data->height;
  const double here = height_of(sample(*uv));
  // The neighbours lie on the other side of the image even if it is laid only once (measured).
  const double below = fraction(uv->y - row);
  const double left = height_of(sample({fraction(uv->x - column), below}));
  const double right = height_of(sample({fraction(uv->x + column), below}));
  return Vec2{(left - right) / 2, (left + right) / 2 - here};
}

std::uint32_t ImageSampler::index(Vec3 p) const {
  const auto uv = place(p);
  if (!uv) return 0;
  const double x = uv->x * source_.data->width, y = uv->y * source_.data->height;
  const Texel t = texel(static_cast<std::int64_t>(x), static_cast<std::int64_t>(y));
  return static_cast<std::uint32_t>(std::clamp(t.channel[0] * 255.0f, 0.0f, 255.0f) + 0.5f);
}

}  // namespace dioptre
