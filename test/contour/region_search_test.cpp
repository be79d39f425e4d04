#include "contour/regions/region_search.h"

#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>

#include "contour/drawn_body.h"
#include "contour/regions/hull_cells.h"

namespace markerless_mocap {
namespace {

constexpr int kLeftWrist = 5;  // in contourPointNames()

/// A person in blue before a noisy wall; around the person the background is unknown.
class RegionSearchTest : public testing::Test {
 protected:
  RegionSearchTest() : person(drawnMasks(rig, body, pose)) {
    cv::RNG random(5);
    for (const cv::Mat& mask : person) {
      cv::Mat noise(mask.size(), CV_8UC3), around;
      random.fill(noise, cv::RNG::UNIFORM, 0, 40);
      images.push_back(noise + cv::Scalar(60, 130, 120));
      cv::Mat blue = noise + cv::Scalar(170, 50, 30);
      blue.copyTo(images.back(), mask);
      cv::dilate(mask, around, cv::Mat::ones(41, 41, CV_8UC1));
      masks.push_back(cv::Mat::zeros(mask.size(), CV_8UC1));
      masks.back().setTo(128, around);
    }
    hull = carved();
  }

  VisualHull carved() const {
    VisualHull out;
    out.lattice.origin = Eigen::Vector3d(-0.8, -0.8, 0.0);
    out.lattice.pitch = 0.05;
    out.lattice.size = {32, 32, 38};
    for (uint32_t i = 0; i < out.lattice.count(); ++i) {
      const bool inside = [&] {
        for (size_t c = 0; c < rig.size(); ++c) {
          const auto pixel = rig[c].projectInside(out.lattice.center(i));
          if (!pixel || !person[c].at<uchar>(int(pixel->y() + 0.5), int(pixel->x() + 0.5)))
            return false;
        }
        return true;
      }();
      if (!inside) continue;
      out.voxels.emplace_back();
      out.voxels.back().index = i;
    }
    return out;
  }

  double overlapOf(const std::vector<cv::Mat>& found) const {
    double sum = 0;
    for (size_t i = 0; i < found.size(); ++i)
      sum += double(cv::countNonZero(found[i] & person[i])) /
             cv::countNonZero(found[i] | person[i]) / double(found.size());
    return sum;
  }

  CameraRig rig = drawnRig(4);
  ContourBody body{ShapeStatistics::handMade().meanShape(1.75)};
  ContourPose pose = stride();
  std::vector<cv::Mat> person, images, masks;
  VisualHull hull;
  RegionObserver observer{rig, ContourOptions()};
};

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
  const RegionObservation seen = observer.observeLargest({images, masks}, hull);
  for (size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(cv::norm(seen.masks[i], hullPixels(hull, rig[i]) & (masks[i] > 0), cv::NORM_INF), 0);
    EXPECT_GT(cv::countNonZero(seen.masks[i] & person[i]), 0.93 * cv::countNonZero(person[i]));
  }
  EXPECT_EQ(cv::norm(seen.masks[3], person[3], cv::NORM_INF), 0);
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
  const auto better = searchLimbsByColor(observer, tracker, frame, hull, body, first);
  ASSERT_TRUE(better);
  EXPECT_LT(wristError(better->fit.pose), 0.06);
}

}  // namespace
}  // namespace markerless_mocap
