#pragma once

#include <opencv2/core/mat.hpp>
#include <opencv2/imgproc.hpp>
#include <random>

#include "region/region_segmenter.h"

namespace markerless_mocap {

/// A figure of two parts before a wall: a red trunk with a skin-coloured arm that points to the
/// right. Wall and figure are noisy.
struct RegionScene {
  static constexpr int kTrunk = 0, kArm = 1, kParts = 2;

  cv::Mat image;   ///< CV_8UC3
  cv::Mat person;  ///< CV_8UC1, 0 | 255: the truth

  explicit RegionScene(float arm_angle = 0, cv::Vec3b wall = {150, 140, 90}, double noise = 8) {
    const ProjectedBody body = bodyAt({0, 0}, arm_angle);
    image = cv::Mat(kHeight, kWidth, CV_8UC3, cv::Scalar(wall));
    person = cv::Mat::zeros(kHeight, kWidth, CV_8UC1);
    for (const ProjectedCone& cone : body.cones) {
      const cv::Mat part = drawn(cone);
      image.setTo(cone.part == kTrunk ? cv::Scalar(40, 40, 190) : cv::Scalar(120, 150, 220), part);
      person |= part;
    }
    cv::Mat speckle(image.size(), CV_16SC3), sum;
    cv::RNG(7).fill(speckle, cv::RNG::NORMAL, 0, noise);
    cv::add(image, speckle, sum, cv::noArray(), CV_16SC3);
    sum.convertTo(image, CV_8UC3);
  }

  /// The figure, shifted, with the arm turned by an angle.
  static ProjectedBody bodyAt(const Eigen::Vector2f& shift, float arm_angle, float sigma = 4) {
    const Eigen::Vector2f low(70, 100), high(70, 50), shoulder(75, 55);
    const Eigen::Vector2f hand =
        shoulder + 45 * Eigen::Vector2f(std::cos(arm_angle), std::sin(arm_angle));
    ProjectedBody body;
    body.cones = {{low + shift, high + shift, 16, 14, 3, 3, kTrunk},
                  {shoulder + shift, hand + shift, 6, 4, 3, 3, kArm}};
    body.sigma = sigma;
    return body;
  }

  double overlapWith(const cv::Mat& mask) const {
    return double(cv::countNonZero(mask & person)) / cv::countNonZero(mask | person);
  }

 private:
  static constexpr int kWidth = 160, kHeight = 140;

  static cv::Mat drawn(const ProjectedCone& cone) {
    cv::Mat mask = cv::Mat::zeros(kHeight, kWidth, CV_8UC1);
    for (int i = 0; i <= 60; ++i) {
      const float s = float(i) / 60;
      const Eigen::Vector2f at = cone.a + s * (cone.b - cone.a);
      const float radius = cone.radius_a + s * (cone.radius_b - cone.radius_a);
      cv::circle(mask, {int(std::lround(16 * at.x())), int(std::lround(16 * at.y()))},
                 int(std::lround(16 * radius)), 255, cv::FILLED, cv::LINE_8, 4);
    }
    return mask;
  }
};

}  // namespace markerless_mocap
