#include "silhouette/bits/changed_bits.h"

#include <gtest/gtest.h>

#include <opencv2/core.hpp>

#include "silhouette/background/background.h"
#include "silhouette/background/row_kernels.h"
#include "silhouette/bits/bit_mask.h"

namespace markerless_mocap {
namespace {

constexpr uint16_t kLimit = Background::kLimit * Background::kLimit;

/// Two colours per pixel, near and far from those of an image, at widths within and across words.
class ChangedBits : public testing::TestWithParam<int> {
 protected:
  ChangedBits() : now_(3 * stride_), bgr_(1, width_, CV_8UC3) {
    cv::RNG random(width_);
    random.fill(bgr_, cv::RNG::UNIFORM, 0, 256);
    for (int mode = 0; mode < 2; ++mode) {
      mean_[mode].assign(3 * stride_, 0);
      weight_[mode].assign(stride_, 0);
      for (int x = 0; x < width_; ++x) {
        weight_[mode][x] = uint8_t(random.uniform(0, 255));
        for (int c = 0; c < 3; ++c) {
          const int grey = bgr_.at<cv::Vec3b>(0, x)[c] + random.uniform(-30, 31);
          mean_[mode][c * stride_ + x] = uint8_t(std::clamp(grey, 0, 255));
        }
      }
      rows_[mode] = {{&mean_[mode][0], &mean_[mode][stride_], &mean_[mode][2 * stride_]},
                     weight_[mode].data(),
                     int16_t(mode == 0 ? 11 : 129)};
    }
  }

  /// Loop by loop.
  std::vector<uint64_t> expected(int modes, int16_t gain) {
    deinterleaveBgr(bgr_.ptr(), width_, int(stride_), now_.data());
    const uint8_t* now[] = {&now_[0], &now_[stride_], &now_[2 * stride_]};
    std::vector<uint16_t> least(stride_, 65535), squared(stride_);
    for (int mode = 0; mode < modes; ++mode) {
      squaredDistances(now, rows_[mode], 3, gain, int(stride_), squared.data());
      keepSmaller(squared.data(), int(stride_), least.data());
    }
    std::vector<uint8_t> flags(stride_);
    std::vector<uint64_t> bits(stride_ / 64);
    packAbove(least.data(), kLimit, int(stride_), flags.data(), bits.data());
    return bits;
  }

  int width_ = GetParam();
  size_t stride_ = size_t(width_ + 63) / 64 * 64;
  std::vector<uint8_t> now_;
  cv::Mat bgr_;
  std::vector<uint8_t> mean_[2], weight_[2];
  ModeRow rows_[2];
  std::vector<uint64_t> all_ = std::vector<uint64_t>(stride_ / 64, 1);
};
INSTANTIATE_TEST_SUITE_P(Widths, ChangedBits, testing::Values(1, 16, 63, 64, 100, 320, 333));

TEST_P(ChangedBits, AreThoseOfTheSeparateLoops) {
  std::vector<uint64_t> bits(stride_ / 64);
  for (const int modes : {1, 2})
    for (const double gain : {0.5, 1.0, 1.99}) {
      const auto fixed = int16_t(gain * kGainOne);
      if (!changedBits(bgr_.ptr(), width_, rows_, modes, fixed, kLimit, {}, all_.data(),
                       bits.data()))
        GTEST_SKIP() << "the processor has no AVX2";
      EXPECT_EQ(bits, expected(modes, fixed)) << modes << " modes, gain " << gain;
    }
}

TEST_P(ChangedBits, AreZeroWhereTheyAreNotWanted) {
  std::vector<uint64_t> wanted = all_, bits(stride_ / 64, ~uint64_t(0));
  wanted.back() = 0;
  if (!changedBits(bgr_.ptr(), width_, rows_, 1, kGainOne, kLimit, {}, wanted.data(), bits.data()))
    GTEST_SKIP() << "the processor has no AVX2";
  std::vector<uint64_t> rest = expected(1, kGainOne);
  rest.back() = 0;
  EXPECT_EQ(bits, rest);
}

}  // namespace
}  // namespace markerless_mocap
