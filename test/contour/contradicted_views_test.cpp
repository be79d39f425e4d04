#include "contour/track/contradicted_views.h"

#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>

#include "contour/drawn_body.h"
#include "contour/fit/body_overlap.h"

namespace markerless_mocap {
namespace {

class ContradictedViewsTest : public ::testing::Test {
 protected:
  ContradictedViewsTest() { masks = drawnMasks(rig, body, stride()); }
  void mirror(size_t camera) {
    cv::flip(masks[camera].clone(), masks[camera], 1);
    cv::copyMakeBorder(masks[camera](cv::Rect(0, 0, 260, 240)).clone(), masks[camera], 0, 0, 60, 0,
                       cv::BORDER_CONSTANT);
  }
  ContourObservation observed() const { return ContourObserver(rig, options).observe(masks); }
  ContourFit fitted(const ContourObservation& seen) const {
    return ContourFitter(rig, options)
        .fit(seen, body, stride(), ContourPrediction{stride(), 1.0 / 30}, {5, 0.12, 0.03});
  }
  /// By camera, whether the view is left out of the frame after that of the masks. The fit of this
  /// frame may have been to all views.
  std::vector<bool> leftOut() {
    ContourObservation seen = observed();
    views.leaveOut(seen);
    views.judge(rig, body, seen, fitted(seen));
    seen = observed();
    views.leaveOut(seen);
    std::vector<bool> out;
    for (size_t v = 0; v < rig.size(); ++v) {
      out.push_back(seen.views[v].status != ViewStatus::kUsable);
      for (const ContourRay& ray : seen.rays) EXPECT_FALSE(out[v] && ray.camera == int(v));
    }
    return out;
  }

  ContourOptions options;
  CameraRig rig = drawnRig(4);
  ContourBody body{ShapeStatistics::handMade().meanShape(1.75)};
  std::vector<cv::Mat> masks;
  ContradictedViews views;
};

const std::vector<bool> kNone(4, false);

TEST_F(ContradictedViewsTest, OneOfFourIsLeftOutAsLongAsItIsWrong) {
  EXPECT_EQ(leftOut(), kNone);
  const cv::Mat right = masks[2].clone();
  mirror(2);
  const std::vector<bool> one{false, false, true, false};
  EXPECT_EQ(leftOut(), one);
  EXPECT_EQ(leftOut(), one) << "all that is left fits, but not that one";
  EXPECT_FALSE(views.leaveAnyOf(one));
  EXPECT_TRUE(views.leaveAnyOf({false, true, true, false}));
  masks[2] = right;
  EXPECT_EQ(leftOut(), kNone);
}

TEST_F(ContradictedViewsTest, IsToldOnce) {
  mirror(2);
  ContourObservation seen = observed();
  EXPECT_TRUE(views.judge(rig, body, seen, fitted(seen)));
  views.leaveOut(seen);
  EXPECT_FALSE(views.judge(rig, body, seen, fitted(seen)));
}

TEST_F(ContradictedViewsTest, TwoOfFourAreNot) {
  mirror(2);
  mirror(3);
  EXPECT_EQ(leftOut(), kNone) << "nothing says which two are wrong";
}

TEST_F(ContradictedViewsTest, ThatOfAPersonWhoIsHalfHiddenIsNot) {
  masks[1](cv::Rect(0, 120, 320, 120)) = 0;
  EXPECT_EQ(leftOut(), kNone);
}

TEST_F(ContradictedViewsTest, AreForgotten) {
  mirror(2);
  leftOut();
  views.reset();
  ContourObservation seen = observed();
  views.leaveOut(seen);
  EXPECT_EQ(seen.usableViews(), 4);
}

TEST_F(ContradictedViewsTest, MostViewsFitAsUsualUnlessTwoOfFourAreWrong) {
  const ContourFit right = fitted(observed());
  EXPECT_GT(right.majority_quality, 0.97);
  EXPECT_GT(right.worst_quality, 0.97);
  mirror(2);
  const ContourFit one = fitted(observed());
  EXPECT_GT(one.majority_quality, 0.9);
  EXPECT_LT(one.worst_quality, 0.6);
  mirror(3);
  EXPECT_LT(fitted(observed()).majority_quality, 0.6);
}

TEST(ReachedByMost, MoreThanHalfAndAtLeastThree) {
  EXPECT_EQ(reachedByMost({0.3, 0.9}), 0.3);
  EXPECT_EQ(reachedByMost({0.9, 0.3, 0.8}), 0.3) << "two that agree say little";
  EXPECT_EQ(reachedByMost({0.9, 0.1, 0.8, 0.7}), 0.7);
  EXPECT_EQ(reachedByMost({0.1, 0.9, 0.2, 0.8, 0.7}), 0.7);
  EXPECT_EQ(reachedByMost({0.1, 0.2, 0.3, 0.6, 0.7, 0.8, 0.9, 1.0}), 0.6);
}

}  // namespace
}  // namespace markerless_mocap
