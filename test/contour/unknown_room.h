#pragma once

#include <opencv2/imgproc.hpp>
#include <vector>

#include "contour/drawn_body.h"
#include "markerless_mocap/products/visual_hull.h"

namespace markerless_mocap {

/// A person in blue before a noisy wall; around the person the background is unknown.
struct UnknownRoom {
  UnknownRoom() : person(drawnMasks(rig, body, pose)) {
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
};

}  // namespace markerless_mocap
