#include "contour/regions/region_search.h"

#include <gtest/gtest.h>

#include "contour/regions/hull_below.h"
#include "contour/regions/hull_cells.h"
#include "contour/unknown_room.h"

namespace markerless_mocap {
namespace {

constexpr int kLeftWrist = 5;  // in contourPointNames()

class RegionSearchTest : public testing::Test, protected UnknownRoom {
 protected:
  /// Gives what is lower the colours of the wall. \param height metres
  void hideBelow(double height, size_t view) {
    const Eigen::Vector3d at(pose.position.x(), pose.position.y(), height);
    const int row = int(rig[view].project(at)->y());
    cv::Mat low = images[view].rowRange(row, images[view].rows);
    cv::RNG random(9);
    random.fill(low, cv::RNG::UNIFORM, 0, 40);
    low += cv::Scalar(60, 130, 120);
  }

  RegionObserver observer{rig, ContourOptions()};
};

ContourPose withFoldedLegs(ContourPose pose) {
  for (const int knee : {RevoluteJoint::kLeftKnee, RevoluteJoint::kRightKnee})
    pose.angles[size_t(knee)] = -2.5;
  for (const int hip : {SphericalJoint::kLeftHip, SphericalJoint::kRightHip})
    pose.rotations[size_t(hip)] = Eigen::Matrix3d::Identity();
  return pose;
}

TEST_F(RegionSearchTest, ColoursAreNeededWhereTheBackgroundIsUnknown) {
  EXPECT_TRUE(RegionFrame(images, masks).needsColors());
  EXPECT_FALSE(RegionFrame(images, person).needsColors()) << "the background is known";
  EXPECT_FALSE(RegionFrame({}, masks).needsColors()) << "there are no images";
  masks = person;
  masks[1].setTo(128, masks[1] == 0);
  const RegionFrame one(images, masks);
  ASSERT_TRUE(one.needsColors());
  EXPECT_TRUE(one.views[0].colors.empty());
  EXPECT_EQ(one.views[1].colors.size(), one.views[1].known.size());
}

TEST_F(RegionSearchTest, ColoursShowThePersonNearThePredictedBody) {
  const RegionObservation found =
      observer.observeNear({images, masks}, body, disturbed(pose, 0.05, 0.03, 1), 0.04);
  EXPECT_GT(overlapOf(found.masks), 0.9);
  EXPECT_EQ(found.agreement, 1.0) << "nothing is known";
}

TEST_F(RegionSearchTest, ALimbIsContradictedByWhatIsKnownOfAllOfItNotByItsBorder) {
  for (size_t i = 0; i < masks.size(); ++i) {
    cv::Mat inner;
    cv::erode(person[i], inner, cv::Mat::ones(3, 3, CV_8UC1));
    masks[i].setTo(0, inner == 0);
  }
  const RegionObservation border = observer.observeNear({images, masks}, body, pose, 0.04);
  for (size_t i = 0; i < masks.size(); ++i) {
    const cv::Rect all = cv::boundingRect(person[i]);
    masks[i].rowRange(all.y + all.height / 2, masks[i].rows).setTo(0);
  }
  const RegionObservation no_legs = observer.observeNear({images, masks}, body, pose, 0.04);
  for (const ContourLimb::Id leg : {ContourLimb::kLeftLeg, ContourLimb::kRightLeg}) {
    EXPECT_GT(border.limb_agreement[leg], 0.6);
    EXPECT_LT(no_legs.limb_agreement[leg], 0.3);
  }
}

// As of a camera that was turned: it shows something else where the others show the person.
TEST_F(RegionSearchTest, AViewThatMostOthersContradictTellsNothing) {
  const cv::Mat elsewhere = cv::Mat::zeros(person[0].size(), CV_8UC1);
  const auto unknown_beside = [&](size_t view) {
    masks[view] = elsewhere.clone();
    const cv::Rect all = cv::boundingRect(person[view]);
    masks[view].colRange(all.x - 8, all.x).setTo(128);
  };
  for (size_t i = 1; i < masks.size(); ++i) masks[i] = person[i];
  unknown_beside(0);
  const RegionObservation one = observer.observeNear({images, masks}, body, pose, 0.04);
  EXPECT_EQ(cv::countNonZero(one.masks[0] != 128), 0);
  EXPECT_EQ(one.agreement, 1.0);
  EXPECT_EQ(one.limb_agreement[ContourLimb::kLeftLeg], 1.0);
  unknown_beside(1);
  const RegionObservation two = observer.observeNear({images, masks}, body, pose, 0.04);
  EXPECT_GT(cv::countNonZero(two.masks[0] != 128), 0) << "these are not most others";
  EXPECT_LT(two.agreement, 0.1);
}

TEST_F(RegionSearchTest, AViewIsTakenAsItIsWhereTheBackgroundIsKnownNearTheBody) {
  masks = person;
  const cv::Rect all = cv::boundingRect(person[0]);
  ASSERT_GT(all.x, 30);
  masks[0].colRange(0, 8).setTo(128);
  cv::Mat near = masks[1].rowRange(all.y, all.y + 30);
  near.setTo(128, near == 0);
  const RegionFrame frame(images, masks);
  ASSERT_FALSE(frame.views[0].colors.empty());
  const RegionObservation found = observer.observeNear(frame, body, pose, 0.04);
  EXPECT_EQ(cv::norm(found.masks[0], masks[0], cv::NORM_INF), 0) << "unknown is far away";
  EXPECT_GT(cv::norm(found.masks[1], masks[1], cv::NORM_INF), 0);
  EXPECT_EQ(cv::countNonZero(found.masks[1] == 128), 0) << "colours decide";
}

TEST_F(RegionSearchTest, HullPixelsAreAroundTheProjectedVoxels) {
  const cv::Mat pixels = hullPixels(hull, rig[0]);
  ASSERT_EQ(pixels.size(), person[0].size());
  for (const HullVoxel& voxel : hull.voxels) {
    const auto at = rig[0].projectInside(hull.lattice.center(voxel.index));
    ASSERT_TRUE(at);
    EXPECT_TRUE(pixels.at<uchar>(int(at->y()), int(at->x())));
  }
  cv::Mat far;
  cv::dilate(person[0], far, cv::Mat::ones(31, 31, CV_8UC1));
  EXPECT_EQ(cv::countNonZero(pixels & ~far), 0);
}

TEST_F(RegionSearchTest, TheLargestSilhouettesAreWhereMaskAndHullAllowThePerson) {
  masks[3] = person[3];  // known in one view
  const cv::Mat before = masks[0].clone();
  const RegionObservation seen = observer.observeLargest({images, masks}, hull);
  for (size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(cv::norm(seen.masks[i], hullPixels(hull, rig[i]) & (masks[i] > 0), cv::NORM_INF), 0);
    EXPECT_GT(cv::countNonZero(seen.masks[i] & person[i]), 0.93 * cv::countNonZero(person[i]));
  }
  EXPECT_EQ(cv::norm(seen.masks[3], person[3], cv::NORM_INF), 0);
  EXPECT_EQ(cv::norm(masks[0], before, cv::NORM_INF), 0) << "the frame set stays as it is";
}

TEST_F(RegionSearchTest, AForearmThatIsFoldedIntoTheBodyIsFoundAgain) {
  const ContourMultiHypothesisTracker tracker(rig, ContourOptions());
  ContourPose folded = pose;
  folded.angles[RevoluteJoint::kLeftElbow] = 2.5;
  folded.rotations[SphericalJoint::kLeftShoulder] = expSO3({0.1, -0.1, 0});
  const RegionFrame frame(images, masks);
  observer.learn(frame, body, folded);
  RegionFit first{observer.observeNear(frame, body, folded, 0.04), {}};
  first.fit = tracker.bestFit(first.found.seen, body, {folded});
  const auto wristError = [&](const ContourPose& found) {
    return (body.points(found) - body.points(pose)).col(kLeftWrist).norm();
  };
  first.fit.pose = folded;  // the fit may have moved the arm
  ASSERT_GT(wristError(folded), 0.3);
  const auto better = searchLimbsByColor({observer, tracker, frame, hull, body}, first);
  ASSERT_TRUE(better);
  EXPECT_LT(wristError(better->fit.pose), 0.06);
}

TEST_F(RegionSearchTest, TheHullGoesOnBelowABodyWhoseLegsAreFolded) {
  EXPECT_LT(hullBelow(hull, body, pose), 0.1);
  EXPECT_NEAR(hullBelow(hull, body, withFoldedLegs(pose)), 0.45, 0.1);
  EXPECT_EQ(hullBelow(VisualHull(), body, withFoldedLegs(pose)), 0);
  ContourPose elsewhere = withFoldedLegs(pose);
  elsewhere.position.x() += 2.0;
  EXPECT_EQ(hullBelow(hull, body, elsewhere), 0) << "the hull is not near";
}

TEST_F(RegionSearchTest, LegsThatColoursDoNotShowReachDownToWhereTheHullEnds) {
  for (size_t i = 0; i < images.size(); ++i) hideBelow(0.45, i);
  const ContourMultiHypothesisTracker tracker(rig, ContourOptions());
  const RegionFrame frame(images, masks);
  const std::vector<RegionFit> found =
      searchByColor({observer, tracker, frame, hull, body}, {withFoldedLegs(pose), pose});
  ASSERT_EQ(found.size(), 2u);
  EXPECT_LT(found[0].hull_below, 0.2);
  EXPECT_GT(found[1].hull_below, 0.3);
  const auto byColors = [](const RegionFit& one) { return qualityOf(one.fit) + one.found.overlap; };
  EXPECT_GT(byColors(found[1]), byColors(found[0])) << "colours do not tell";
}

}  // namespace
}  // namespace markerless_mocap
