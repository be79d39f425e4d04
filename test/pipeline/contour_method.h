#pragma once

#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>

#include "markerless_mocap/pipeline/make_body_tracker.h"
#include "pipeline/drawn_walk.h"

namespace markerless_mocap {

constexpr int64_t kFrame_ns = 33333333;
constexpr int kMeasuringPoses = 6;

inline TrackerOptions contourOptions() {
  TrackerOptions options;
  options.person.stature = 1.75;
  options.person.shape_poses = kMeasuringPoses;
  options.contour.rays = 400;
  return options;
}

/// The default method on the drawn walk.
class ContourMethodTest : public testing::Test {
 protected:
  ContourMethodTest() { resources.urdf_template = humanTemplate(); }

  void make() { tracker = makeBodyTracker(rig, resources, options); }
  void makeMeasured() {
    resources.known_shape = truth();
    make();
  }
  BodyPose show(const std::vector<cv::Mat>& masks, const PoseTree& tree) {
    ReadyProducts products({hull, parts, tree});
    return tracker->update({stamp_ns += kFrame_ns, masks, {}, products});
  }
  BodyPose show(int frame) { return show(masksAt(frame), treeOf(person, at(frame), false)); }
  BodyPose showMasks(int frame) { return show(masksAt(frame), PoseTree{}); }
  BodyPose showNothing() {
    const cv::Mat nobody = cv::Mat::zeros(240, 320, CV_8UC1);
    return show(std::vector<cv::Mat>(rig.size(), nobody), PoseTree{});
  }
  double error(const BodyPose& pose, int frame) const {
    return errorOf(*tracker->body()->model, pose, frame);
  }
  std::vector<cv::Mat> masksWithoutHands(int frame) const {
    std::vector<cv::Mat> masks = masksAt(frame);
    const Eigen::Matrix3Xd points = person.points(at(frame));
    for (size_t i = 0; i < masks.size(); ++i) {
      masks[i] = masks[i].clone();
      for (const int wrist : {5, 8})
        if (const auto pixel = rig[i].projectInside(points.col(wrist)))
          cv::circle(masks[i], cv::Point(int(pixel->x()), int(pixel->y())), 9, 0, cv::FILLED);
    }
    return masks;
  }
  std::vector<cv::Mat> enlarged(int frame) const {
    std::vector<cv::Mat> masks = masksAt(frame);
    for (cv::Mat& mask : masks) mask = mask.clone(), cv::dilate(mask, mask, cv::Mat());
    return masks;
  }
  std::vector<cv::Mat> covered(int frame, const std::vector<size_t>& cameras) const {
    std::vector<cv::Mat> masks = masksAt(frame);
    for (const size_t camera : cameras) {
      masks[camera] = masks[camera].clone();
      cv::circle(masks[camera], {masks[camera].cols / 2, masks[camera].rows / 2}, 80, 255,
                 cv::FILLED);
    }
    return masks;
  }
  static double offBy(const ShapeParameters& shape) {
    return (shape - truth()).head<BodyLength::kCount>().norm();
  }
  static std::string beingMeasured(int poses) {
    return "the body is being measured, " + std::to_string(poses) + " of " +
           std::to_string(kMeasuringPoses) + " different poses have been seen";
  }

  CameraRig rig = drawnRig(5);
  ContourBody person{truth()};
  PersonResources resources;
  TrackerOptions options = contourOptions();
  VisualHull hull;  // empty, and so are the parts: the tree and the masks must do
  BodyParts parts;
  std::unique_ptr<BodyTracker> tracker;
  int64_t stamp_ns = 0;
};

}  // namespace markerless_mocap
