#include "silhouette/boundary/hole_filling.h"

#include <gtest/gtest.h>

#include <opencv2/core.hpp>

namespace markerless_mocap {
namespace {

constexpr int kMaxHole = 10;
const cv::Size kSize(200, 120);
const cv::Rect kPerson(40, 20, 100, 80);

/// A plain wall, a person before it, and a mask in which a part of the person is not set.
class Missed : public testing::TestWithParam<int> {
 protected:
  Missed() : background_(kSize, GetParam(), 1), image_(kSize, CV_8UC(GetParam())) {
    image_.setTo(cv::Scalar::all(kWall));
    for (int y = 0; y < kSize.height; ++y)
      for (int c = 0; c < GetParam(); ++c)
        std::fill_n(background_.mean(0, y, c), kSize.width, kWall * Background::kMeanScale);
    background_.setThreshold(3, 4);
  }

  /// How much of `part` is set afterwards, if the person is so much brighter than the wall.
  double filledFraction(const cv::Rect& part, int brighter, int max_hole_px = kMaxHole) {
    cv::Mat mask = cv::Mat::zeros(kSize, CV_8UC1);
    image_(kPerson).setTo(cv::Scalar::all(kWall + brighter));
    mask(kPerson).setTo(255);
    mask(part).setTo(0);
    BitMask bits = BitMask::fromMat(mask);
    fillFalseHoles(image_, background_, 1, max_hole_px, &bits);
    const cv::Mat filled = bits.toMat();
    EXPECT_EQ(cv::countNonZero(filled) - cv::countNonZero(mask), cv::countNonZero(filled(part)))
        << "nothing else is set";
    return double(cv::countNonZero(filled(part))) / part.area();
  }

  static constexpr int kWall = 120;
  Background background_;
  cv::Mat image_;
};
INSTANTIATE_TEST_SUITE_P(GreyAndColor, Missed, testing::Values(1, 3));

TEST_P(Missed, HoleIsFilledWhereThePersonLooksLikeTheWall) {
  const cv::Rect hole(70, 40, 20, 15);
  EXPECT_EQ(filledFraction(hole, 20), 1);
  EXPECT_EQ(filledFraction(hole, 60), 0) << "one looks through it";
}

TEST_P(Missed, LargeHoleIsAGap) {
  EXPECT_LT(filledFraction({60, 40, 30, 20}, 20), 0.05) << "but for its corners";
}

TEST_P(Missed, TinyHoleIsFilledAnyhow) {
  EXPECT_EQ(filledFraction({70, 40, 5, 2}, 60), 1);
}

TEST_P(Missed, NotchIsFilledWhereThePersonLooksLikeTheWall) {
  const cv::Rect notch(kPerson.x, 50, 30, 4);
  EXPECT_GT(filledFraction(notch, 20), 0.9);
  EXPECT_EQ(filledFraction(notch, 60), 0);
}

TEST_P(Missed, NothingIsFilledUnlessAskedFor) {
  EXPECT_EQ(filledFraction({70, 40, 2, 2}, 20, 0), 0);
}

}  // namespace
}  // namespace markerless_mocap
