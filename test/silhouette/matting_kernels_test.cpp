#include "silhouette/boundary/matting_kernels.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <opencv2/core.hpp>

namespace markerless_mocap {
namespace {

constexpr int kStep = 40, kSide = kMattingBlock;

/// A block in the midst of random bytes.
class MattingKernels : public testing::TestWithParam<int> {
 protected:
  MattingKernels() {
    cv::RNG random(uint64_t(GetParam() + 1));
    for (uint8_t& value : now_) value = uint8_t(random.uniform(0, 256));
    for (auto& plane : usual_)
      for (uint8_t& value : plane) value = uint8_t(random.uniform(0, 256));
    chosen_ = BlockBits(random.uniform(0, 65536));
    if (GetParam() == 0) chosen_ = 0xffff;
    if (GetParam() == 1) chosen_ = 0;
  }

  void SetUp() override {
    if (!hasMattingKernels()) GTEST_SKIP() << "the processor has no AVX2";
  }

  ColorBlock block() const {
    return {&now_[5], kStep, {&usual_[0][3], &usual_[1][3], &usual_[2][3]}, kStep};
  }
  bool isChosen(int x, int y) const { return chosen_ >> (kSide * y + x) & 1; }

  /// Pixel by pixel; `old` where alpha cannot be estimated.
  int alpha(int x, int y, const MattingColors& colors, int old) const {
    float apart = 0, contrast = 0;
    for (int c = 0; c < 3; ++c) {
      const float lit = float(block().expected[c][kStep * y + x]) * colors.light;
      apart += std::pow(float(block().now[kStep * y + 3 * x + c]) - lit, 2.0f);
      contrast += std::pow(colors.person[c] - lit, 2.0f);
    }
    if (contrast < colors.min_contrast) return old;
    const float square = (apart - colors.squared_noise) / contrast;
    return int(255 * std::sqrt(std::min(1.0f, std::max(0.0f, square))));
  }

  std::array<uint8_t, 4 * kStep> now_;
  std::array<std::array<uint8_t, 4 * kStep>, 3> usual_;
  BlockBits chosen_;
};
INSTANTIATE_TEST_SUITE_P(Blocks, MattingKernels, testing::Range(0, 20));

TEST_P(MattingKernels, AddTheChosenPixelsColors) {
  uint16_t sums[] = {1, 2, 3};
  addColors(block(), chosen_, sums);
  for (int c = 0; c < 3; ++c) {
    int expected = c + 1;
    for (int y = 0; y < kSide; ++y)
      for (int x = 0; x < kSide; ++x)
        if (isChosen(x, y)) expected += block().now[kStep * y + 3 * x + c];
    EXPECT_EQ(sums[c], expected);
  }
}

TEST_P(MattingKernels, TellTheSharesThatAreAskedFor) {
  const MattingColors colors{{60, 110, 200}, 0.9f, 48, 9000};
  std::array<uint8_t, 4 * kStep> alphas;
  alphas.fill(77);
  estimateAlpha(block(), colors, chosen_, kStep, alphas.data());
  for (int i = 0; i < 4 * kStep; ++i) {
    const int x = i % kStep, y = i / kStep;
    const bool is_asked = x < kSide && isChosen(x, y);
    EXPECT_NEAR(alphas[i], is_asked ? alpha(x, y, colors, 77) : 77, is_asked ? 1 : 0) << x << y;
  }
}

}  // namespace
}  // namespace markerless_mocap
