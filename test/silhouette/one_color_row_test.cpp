/// A row whose pixels show one colour gives what the search for modes gives, pixel by pixel.
#include "silhouette/background/one_color_row.h"

#include <gtest/gtest.h>

#include "silhouette/background/color_modes.h"
#include "silhouette/scene.h"

namespace markerless_mocap {
namespace {

constexpr int kImages = 20, kRow = 40;
constexpr float kNoise = 4;  ///< grey levels, more than the images have

/// Images of a scene; in the first seven the left half is something else. Lights differ by image.
std::vector<cv::Mat> imagesOf(const cv::Mat& scene) {
  std::vector<cv::Mat> images;
  for (int i = 0; i < kImages; ++i) {
    images.push_back(withNoise(scene, i));
    if (i < 7) images.back()(cv::Rect(0, 0, 80, 120)) += cv::Scalar::all(60);
  }
  return images;
}

float lightOf(int image) {
  return 1 + 0.01f * float(image % 4);
}

class OneColorRowOf : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Channels, OneColorRowOf, testing::Values(1, 3));

TEST_P(OneColorRowOf, IsWhatTheModesAre) {
  const int channels = GetParam();
  const std::vector<cv::Mat> images = imagesOf(makeScene(channels));
  OneColorRow row(kSize.width, channels, colorReach(kNoise, channels));
  row.add(images[5].ptr(3), 2);
  row.clear();
  for (int i = 0; i < kImages; ++i) row.add(images[i].ptr(kRow), lightOf(i));
  row.finish();
  Background background(kSize, channels, 2);
  row.store(kRow, &background);
  for (int x = 0; x < kSize.width; ++x) {
    std::vector<float> samples(size_t(kImages) * channels);
    for (int i = 0; i < kImages; ++i) row.copySample(i, x, &samples[size_t(i) * channels]);
    EXPECT_FLOAT_EQ(samples[channels], float(images[1].ptr(kRow)[x * channels]) * lightOf(1));
    const std::vector<ColorMode> modes = findColorModes(samples, channels, kNoise, 3);
    ASSERT_EQ(row.hasOneColor(x), x >= 80) << x;
    ASSERT_EQ(modes.size() == 1, x >= 80) << x;
    if (x < 80) continue;
    EXPECT_EQ(modes[0].count, kImages);
    for (int k = 0; k < 2; ++k) {
      EXPECT_NEAR(background.sigma(k, kRow)[x], modes[0].sigma * Background::kMeanScale, 1.5);
      for (int c = 0; c < channels; ++c)
        EXPECT_NEAR(background.mean(k, kRow, c)[x], modes[0].mean[c] * Background::kMeanScale, 1.5);
    }
  }
}

}  // namespace
}  // namespace markerless_mocap
