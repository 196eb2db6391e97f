// SPDX-License-Identifier: Apache-2.0
#include "dioptre/shading/images/image_sampler.h"

#include <gtest/gtest.h>

namespace dioptre {
namespace {

/// Grey values without a pattern.
ImageSource rough_image(bool once) {
  ImageData data;
  data.width = data.height = 8;
  data.channels = 1;
  for (int k = 0; k < 64; ++k) data.pixels.push_back(static_cast<float>(k * k * 37 % 101) / 101);
  ImageSource image;
  image.data = std::move(data);
  image.once = once;
  return image;
}

TEST(ImageSampler, BumpsOfAnImageLaidOnceAreThoseOfARepeatedOne) {
  const ImageSampler once(rough_image(true)), repeated(rough_image(false));
  for (int j = 0; j < 8; ++j) {
    for (int i = 0; i < 8; ++i) {
      const Vec3 p{(i + 0.5) / 8, (j + 0.5) / 8, 0};
      ASSERT_TRUE(once.lean(p) && repeated.lean(p));
      EXPECT_EQ(*once.lean(p), *repeated.lean(p)) << i << ' ' << j;
    }
  }
  EXPECT_FALSE(once.lean({1.5, 0.5, 0}));
}

}  // namespace
}  // namespace dioptre
