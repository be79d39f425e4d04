#include "silhouette/bits/bit_mask.h"

#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>

#include "silhouette/bits/bit_morphology.h"
#include "silhouette/bits/mask_runs.h"

namespace markerless_mocap {
namespace {

/// Blobs and specks; widths that fill the last word, begin a new one and stay within one.
cv::Mat randomMask(int width, int seed) {
  cv::RNG random(seed);
  cv::Mat noise(97, width, CV_8UC1);
  random.fill(noise, cv::RNG::UNIFORM, 0, 256);
  cv::GaussianBlur(noise, noise, {0, 0}, 1 + seed % 3);
  cv::Mat specks(noise.size(), CV_8UC1);
  random.fill(specks, cv::RNG::UNIFORM, 0, 256);
  return (noise > 127) ^ (specks > 250);
}

cv::Mat disk(int radius) {
  return cv::getStructuringElement(cv::MORPH_ELLIPSE, {2 * radius + 1, 2 * radius + 1});
}

bool same(const BitMask& bits, const cv::Mat& mask) {
  return cv::countNonZero(bits.toMat() != mask) == 0;
}

class BitMaskOfWidth : public testing::TestWithParam<int> {
 protected:
  cv::Mat mask_ = randomMask(GetParam(), GetParam());
  BitMask bits_ = BitMask::fromMat(mask_);
};
INSTANTIATE_TEST_SUITE_P(Widths, BitMaskOfWidth, testing::Values(1, 20, 63, 64, 65, 128, 321));

TEST_P(BitMaskOfWidth, ComesBackAsItWas) {
  EXPECT_TRUE(same(bits_, mask_));
  EXPECT_EQ(int(bits_.count()), cv::countNonZero(mask_));
}

TEST_P(BitMaskOfWidth, SetsAreJoinedCutAndTakenAway) {
  const cv::Mat other = randomMask(GetParam(), GetParam() + 1);
  const BitMask other_bits = BitMask::fromMat(other);
  BitMask either = bits_, both = bits_, without = bits_;
  either |= other_bits;
  both &= other_bits;
  without.remove(other_bits);
  EXPECT_TRUE(same(either, mask_ | other));
  EXPECT_TRUE(same(both, mask_ & other));
  EXPECT_TRUE(same(without, mask_ & ~other));
  either = without = bits_;
  either |= BitMask();
  both &= BitMask();
  without.remove(BitMask());
  EXPECT_TRUE(same(either, mask_));
  EXPECT_EQ(both.count(), 0u);
  EXPECT_TRUE(same(without, mask_));
}

TEST_P(BitMaskOfWidth, MorphologyIsOpenCvs) {
  for (const int radius : {1, 2, 3, 7, 20}) {
    cv::Mat expected;
    cv::dilate(mask_, expected, disk(radius));
    EXPECT_TRUE(same(dilated(bits_, radius), expected)) << "dilated by " << radius;
    cv::erode(mask_, expected, disk(radius));
    EXPECT_TRUE(same(eroded(bits_, radius), expected)) << "eroded by " << radius;
  }
  cv::Mat expected;
  cv::dilate(mask_, expected, cv::Mat::ones(5, 81, CV_8UC1));
  BitMask near = bits_;
  std::vector<uint64_t> row;
  for (int y = 0; y < near.rows(); ++y) {
    nearRow(bits_, y, 40, 2, &row);
    std::copy(row.begin() + 1, row.end() - 1, near.row(y));
  }
  EXPECT_TRUE(same(near, expected));
}

TEST_P(BitMaskOfWidth, BlobsAndHolesAreOpenCvsComponents) {
  constexpr int kArea = 12;
  cv::Mat labels, stats, centroids, expected = mask_.clone();
  cv::connectedComponentsWithStats(mask_, labels, stats, centroids, 8);
  for (int y = 0; y < mask_.rows; ++y)
    for (int x = 0; x < mask_.cols; ++x)
      if (stats.at<int>(labels.at<int>(y, x), cv::CC_STAT_AREA) < kArea)
        expected.at<uint8_t>(y, x) = 0;
  BitMask bits = bits_;
  removeBlobs(kArea, &bits);
  EXPECT_TRUE(same(bits, expected));

  expected = mask_.clone();
  cv::connectedComponentsWithStats(~mask_, labels, stats, centroids, 4);
  const cv::Rect inside(1, 1, mask_.cols - 2, mask_.rows - 2);
  for (int y = 0; y < mask_.rows; ++y)
    for (int x = 0; x < mask_.cols; ++x) {
      const int* of = stats.ptr<int>(labels.at<int>(y, x));
      const cv::Rect box(of[0], of[1], of[2], of[3]);
      if ((box & inside) == box && of[cv::CC_STAT_AREA] <= kArea) expected.at<uint8_t>(y, x) = 255;
    }
  bits = bits_;
  fillHoles(kArea, &bits);
  EXPECT_TRUE(same(bits, expected));
}

TEST(BitMask, FillsSpansAcrossWords) {
  BitMask bits(cv::Size(200, 1));
  bits.fill(0, 10, 150, true);
  EXPECT_EQ(bits.count(), 141u);
  EXPECT_TRUE(bits.at(10, 0) && bits.at(150, 0));
  EXPECT_FALSE(bits.at(9, 0) || bits.at(151, 0));
  bits.fill(0, 63, 64, false);
  EXPECT_EQ(bits.count(), 139u);
}

}  // namespace
}  // namespace markerless_mocap
