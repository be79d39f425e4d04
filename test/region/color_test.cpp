#include <gtest/gtest.h>

#include <numeric>

#include "region/colors/color_bins.h"
#include "region/colors/color_histogram.h"

namespace markerless_mocap {
namespace {

uint16_t binOf(const cv::Vec3b& bgr) {
  return ColorBins::instance().of(cv::Mat(1, 1, CV_8UC3, cv::Scalar(bgr))).at<uint16_t>(0, 0);
}

TEST(ColorBins, SeparateHuesAndKeepShadesOfGreyTogetherInChroma) {
  EXPECT_NE(binOf({30, 30, 200}), binOf({30, 200, 30}));
  EXPECT_NE(binOf({30, 30, 200}), binOf({200, 30, 30}));
  constexpr int kPerLightness = ColorBins::kChroma * ColorBins::kChroma;
  EXPECT_EQ(binOf({80, 80, 80}) % kPerLightness, binOf({200, 200, 200}) % kPerLightness);
  EXPECT_NE(binOf({80, 80, 80}), binOf({200, 200, 200}));
  EXPECT_LT(binOf({255, 255, 255}), ColorBins::kCount);
}

double sumOf(const ColorHistogram& histogram) {
  return std::accumulate(histogram.data(), histogram.data() + ColorBins::kCount, 0.0);
}

TEST(ColorHistogram, IsAProbabilityThatReachesNeighbouringBins) {
  const uint16_t bin = binOf({90, 120, 170});
  std::vector<uint32_t> counts(ColorBins::kCount);
  counts[bin] = 100;
  ColorHistogram histogram;
  EXPECT_TRUE(histogram.empty());
  histogram.learn(counts, 0.1f);
  ASSERT_FALSE(histogram.empty());
  EXPECT_NEAR(sumOf(histogram), 1, 1e-4);
  EXPECT_GT(histogram.data()[bin], histogram.data()[bin + 1]);
  EXPECT_GT(histogram.data()[bin + 1], 0.01);
}

TEST(ColorHistogram, TakesTheFirstColoursOverAndMixesLaterOnes) {
  const uint16_t red = binOf({30, 30, 200}), green = binOf({30, 200, 30});
  std::vector<uint32_t> reds(ColorBins::kCount), greens(ColorBins::kCount);
  reds[red] = greens[green] = 50;
  ColorHistogram histogram;
  histogram.learn(reds, 0.25f);
  const float first = histogram.data()[red];
  histogram.learn(greens, 0.25f);
  EXPECT_NEAR(histogram.data()[red], 0.75f * first, 1e-5);
  EXPECT_NEAR(histogram.data()[green], 0.25f * first, 1e-2);
}

TEST(ColorHistogram, IgnoresAHandfulOfSamples) {
  std::vector<uint32_t> counts(ColorBins::kCount);
  counts[5] = 3;
  ColorHistogram histogram;
  histogram.learn(counts, 1.f);
  EXPECT_TRUE(histogram.empty());
}

}  // namespace
}  // namespace markerless_mocap
