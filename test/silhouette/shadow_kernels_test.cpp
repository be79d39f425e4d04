#include "silhouette/shadow/shadow_kernels.h"

#include <gtest/gtest.h>

#include <opencv2/core.hpp>

#include "silhouette/bits/bit_mask.h"

namespace markerless_mocap {
namespace {

constexpr int kCols = ShadowColumns::kCols;

/// Two rows of pixels of which most are a shadow on their background, with noise.
class ShadowKernels : public testing::TestWithParam<int> {
 protected:
  ShadowKernels() : random_(uint64_t(GetParam() + 1)) {
    for (int row = 0; row < 2; ++row)
      for (int x = 0; x < kCols; ++x) {
        const double shadow = random_.uniform(0.4, 1.2);
        for (int c = 0; c < 3; ++c) {
          mean_[row][c][x] = uint8_t(random_.uniform(0, 256));
          bgr_[row][3 * x + c] = now_[row][c][x] =
              cv::saturate_cast<uint8_t>(mean_[row][c][x] * shadow + random_.uniform(-9, 10));
        }
        asked_[row] |= uint64_t(random_.uniform(0, 4) > 0) << x;
      }
    if (GetParam() == 0) asked_[0] = 0;
    if (GetParam() == 1) asked_[0] = 0xffff0000u;
  }

  ModeRow mode(int row) const {
    return {{mean_[row][0], mean_[row][1], mean_[row][2]}, nullptr, 1};
  }

  cv::RNG random_;
  uint8_t bgr_[2][3 * kCols], now_[2][3][kCols], mean_[2][3][kCols];
  uint64_t asked_[2] = {};
  const PixelShadowThresholds limits_{0.55f, 0.0004f, 70};
};
INSTANTIATE_TEST_SUITE_P(Rows, ShadowKernels, testing::Range(0, 20));

TEST_P(ShadowKernels, FindWhatTheSeparateLoopsFind) {
  ShadowColumns columns, expected_columns;
  int found = 0;
  for (int row = 0; row < 2; ++row) {
    uint64_t shadow = 0;
    uint8_t ratio[kCols], expected[kCols], asked[kCols];
    if (!shadowRatiosOfBgr(bgr_[row], mode(row), 0, 0.97f, limits_, asked_[row], ratio, &shadow,
                           &columns))
      GTEST_SKIP() << "the processor has no AVX2";
    const uint8_t* now[] = {now_[row][0], now_[row][1], now_[row][2]};
    unpackBits(&asked_[row], kCols, asked);
    shadowRatios(now, mode(row), 0, 3, 0.97f, limits_, asked, expected, &expected_columns);
    for (int x = 0; x < kCols; ++x) {
      EXPECT_EQ(shadow >> x & 1, expected[x] > 0) << x;
      EXPECT_EQ(shadow >> x & 1 ? ratio[x] : 0, expected[x]) << x;
      found += int(shadow >> x & 1);
    }
  }
  EXPECT_GT(found, 5);
  for (int x = 0; x < kCols; ++x) {
    EXPECT_EQ(columns.count[x], expected_columns.count[x]);
    EXPECT_EQ(columns.ratio[x], expected_columns.ratio[x]);
    EXPECT_EQ(columns.squares[x], expected_columns.squares[x]);
    for (int c = 0; c < 3; ++c) {
      EXPECT_EQ(columns.now[c][x], expected_columns.now[c][x]);
      EXPECT_EQ(columns.expected[c][x], expected_columns.expected[c][x]);
    }
  }
}

}  // namespace
}  // namespace markerless_mocap
