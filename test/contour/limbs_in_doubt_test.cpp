#include "contour/track/limbs_in_doubt.h"

#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>

#include "contour/drawn_body.h"
#include "markerless_mocap/products/silhouette_mask.h"

namespace markerless_mocap {
namespace {

class LimbsInDoubtTest : public testing::Test {
 protected:
  /// \param masks shown \param overlap of the pose with what it was fitted to
  std::optional<ContourFit> found(const std::vector<cv::Mat>& masks, const ContourPose& pose,
                                  double overlap = 0.95) const {
    ContourFit fit;
    fit.status = ContourFitStatus::kFitted;
    fit.pose = pose;
    fit.overlap = overlap;
    return findLimbsInDoubt(tracker, observer.observe(masks), rig, body, fit);
  }
  /// Largest distance of an ankle from its place in stride(), metres.
  double ankleError(const ContourPose& pose) const {
    const Eigen::Matrix3Xd off = body.points(pose) - body.points(stride());
    return std::max(off.col(11).norm(), off.col(14).norm());  // ankles of contourPointNames()
  }
  ContourPose folded() const {
    ContourPose pose = stride();
    pose.angles[RevoluteJoint::kLeftKnee] = pose.angles[RevoluteJoint::kRightKnee] = -2.2;
    return pose;
  }

  CameraRig rig = drawnRig(4);
  ContourBody body{ShapeStatistics::handMade().meanShape(1.75)};
  ContourMultiHypothesisTracker tracker{rig, ContourOptions()};
  ContourObserver observer{rig, ContourOptions()};
  std::vector<cv::Mat> shown = drawnMasks(rig, body, stride());
};

TEST_F(LimbsInDoubtTest, FoldedLegsComeBackToThoseThatMasksShow) {
  ASSERT_GT(ankleError(folded()), 0.3);
  const auto fit = found(shown, folded());
  ASSERT_TRUE(fit);
  EXPECT_LT(ankleError(fit->pose), 0.03);
}

TEST_F(LimbsInDoubtTest, ABoxAtTheLegsMovesNone) {
  for (cv::Mat& mask : shown) {
    const cv::Rect person = cv::boundingRect(mask);
    mask(cv::Rect(person.x + person.width / 2, person.br().y - 50, 60, 50)) = kPersonPixel;
  }
  EXPECT_FALSE(found(shown, stride()));
}

TEST_F(LimbsInDoubtTest, NothingIsSearchedWhereMasksOverlapAsUsual) {
  EXPECT_FALSE(found(shown, folded(), 0.8));
}

}  // namespace
}  // namespace markerless_mocap
