#include "contour/fit/contour_observation.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <opencv2/imgproc.hpp>
#include <stdexcept>

#include "contour/drawn_body.h"
#include "contour/fit/outline.h"
#include "markerless_mocap/products/silhouette_mask.h"

namespace markerless_mocap {
namespace {

cv::Mat blank() {
  return cv::Mat::zeros(240, 320, CV_8UC1);
}

TEST(Outline, FindsEveryStepOfABoxAndNoneAtTheImagesEdge) {
  cv::Mat mask = blank();
  const cv::Rect box(50, 60, 20, 30);
  mask(box) = 255;
  std::vector<Crack> cracks;
  findCracks(mask, box, cracks);
  EXPECT_EQ(cracks.size(), size_t(2 * (20 + 30)));
  for (const Crack& crack : cracks) {
    const bool upright = crack.x2 % 2 != 0;
    EXPECT_TRUE(upright ? crack.x2 == 99 || crack.x2 == 139 : crack.y2 == 119 || crack.y2 == 179);
  }
  cv::Mat cut = blank();
  const cv::Rect low(50, 200, 20, 40);  // down to the last row
  cut(low) = 255;
  cracks.clear();
  findCracks(cut, low, cracks);
  for (const Crack& crack : cracks) EXPECT_LT(crack.y2, 2 * 239);
}

TEST(Outline, NormalsPointOutOfADisk) {
  cv::Mat mask = blank();
  cv::circle(mask, {160, 120}, 40, 255, cv::FILLED);
  std::vector<Crack> cracks;
  findCracks(mask, {120, 80, 81, 81}, cracks);
  ASSERT_GT(cracks.size(), 200u);
  for (const Crack& crack : cracks) {
    const Eigen::Vector2d out = (crack.pixel() - Eigen::Vector2d(160, 120)).normalized();
    EXPECT_GT(outwardNormal(mask, crack, 4).normalized().dot(out), 0.97);
  }
}

TEST(Outline, ShownBoxHoldsAllThatIsNotBackground) {
  EXPECT_EQ(shownBox(cv::Mat()), cv::Rect());
  EXPECT_EQ(shownBox(blank()), cv::Rect());
  cv::RNG random(5);
  for (int trial = 0; trial < 200; ++trial) {
    cv::Mat all = cv::Mat::zeros(60, 90, CV_8UC1);
    for (int pixel = random.uniform(1, 5); pixel > 0; --pixel)
      all.at<uchar>(random.uniform(0, 60), random.uniform(0, 90)) = pixel % 2 ? 255 : 128;
    const cv::Mat part = all(cv::Rect(7, 3, random.uniform(1, 80), random.uniform(1, 50)));
    cv::Rect expected;
    for (int y = 0; y < part.rows; ++y)
      for (int x = 0; x < part.cols; ++x)
        if (part.at<uchar>(y, x)) expected |= cv::Rect(x, y, 1, 1);
    EXPECT_EQ(shownBox(part), expected);
  }
}

/// By the definition: weights that fall to 0 at the border of the disk.
Eigen::Vector2d normalByDefinition(const cv::Mat& mask, const Crack& crack, int radius) {
  Eigen::Vector2d inward = Eigen::Vector2d::Zero();
  for (int y = -20; y < mask.rows + 20; ++y)
    for (int x = -20; x < mask.cols + 20; ++x) {
      const Eigen::Vector2d off = Eigen::Vector2d(x, y) - crack.pixel();
      const double weight = (radius + 0.5) * (radius + 0.5) - off.squaredNorm();
      if (weight > 0 &&
          mask.at<uchar>(std::clamp(y, 0, mask.rows - 1), std::clamp(x, 0, mask.cols - 1)))
        inward += weight * off;
    }
  return -inward;
}

TEST(Outline, NormalsAreThoseOfTheDefinitionAlsoAtTheImagesEdge) {
  cv::Mat mask(24, 31, CV_8UC1);
  cv::RNG random(3);
  random.fill(mask, cv::RNG::UNIFORM, 0, 3);
  mask *= 128;  // 0, 128 and 255
  std::vector<Crack> cracks;
  findCracks(mask, {0, 0, mask.cols, mask.rows}, cracks);
  ASSERT_GT(cracks.size(), 100u);
  for (const int radius : {2, 4, kMaxNormalRadius})
    for (const Crack& crack : cracks) {
      const Eigen::Vector2d expected = normalByDefinition(mask, crack, radius);
      const Eigen::Vector2d found = outwardNormal(mask, crack, radius);
      EXPECT_LT((found.stableNormalized() - expected.stableNormalized()).norm(), 1e-12);
    }
}

TEST(ContourObserver, RaysTouchABallFromOutside) {
  const CameraRig rig = drawnRig(3, -0.1);
  const Eigen::Vector3d middle(0.1, 0.2, 1.0);
  constexpr double kRadius = 0.3;
  std::vector<cv::Mat> masks;
  for (const Camera& camera : rig) {
    masks.push_back(blank());
    for (int y = 0; y < 240; ++y)
      for (int x = 0; x < 320; ++x) {
        const Eigen::Vector3d way = middle - camera.position();
        const Eigen::Vector3d ray = camera.rayDirection(Eigen::Vector2d(x, y));
        if ((way - ray * ray.dot(way)).norm() < kRadius) masks.back().at<uchar>(y, x) = 255;
      }
  }
  ContourOptions options;
  options.rays = 600;
  const ContourObservation seen = ContourObserver(rig, options).observe(masks);
  EXPECT_EQ(seen.usableViews(), 3);
  EXPECT_GT(seen.rays.size(), 300u);
  for (const ContourRay& ray : seen.rays) {
    const double n = ray.normal.cast<double>().dot(middle) - ray.normal_of_ray;
    const double s = ray.side.cast<double>().dot(middle) - ray.side_of_ray;
    EXPECT_NEAR(std::hypot(n, s), kRadius, 0.01);  // a pixel is 13 mm
    EXPECT_LT(n, -0.93 * kRadius);                 // the ball is on the inner side
  }
}

TEST(ContourObserver, DistancesGrowAwayFromTheBorder) {
  const CameraRig rig = drawnRig(2);
  cv::Mat mask = blank();
  mask(cv::Rect(100, 80, 60, 100)) = 255;
  const ContourObservation seen = ContourObserver(rig, {}).observe({mask, mask});
  const ContourView& view = seen.views[0];
  EXPECT_EQ(view.step, 1);
  const auto at = [&](int x, int y) {
    return view.distance.at<float>(y - view.corner.y, x - view.corner.x);
  };
  EXPECT_NEAR(at(100, 130), -0.5, 1e-3);
  EXPECT_NEAR(at(99, 130), 0.5, 1e-3);
  EXPECT_NEAR(at(109, 130), -9.5, 0.1);
  EXPECT_NEAR(at(92, 130), 7.5, 0.1);
}

TEST(ContourObserver, SaysWhichViewsAreOfNoUse) {
  const CameraRig rig = drawnRig(4);
  cv::Mat person = blank();
  person(cv::Rect(100, 80, 60, 100)) = 255;
  const ContourObservation seen =
      ContourObserver(rig, {}).observe({person, blank(), blank() + 255, cv::Mat()});
  EXPECT_EQ(seen.views[0].status, ViewStatus::kUsable);
  EXPECT_EQ(seen.views[1].status, ViewStatus::kEmpty);
  EXPECT_EQ(seen.views[2].status, ViewStatus::kFull);
  EXPECT_EQ(seen.views[3].status, ViewStatus::kMissing);
  for (const ContourRay& ray : seen.rays) EXPECT_EQ(ray.camera, 0);
  EXPECT_TRUE(ContourObserver(rig, {}).observe(std::vector<cv::Mat>(4)).rays.empty());
}

TEST(ContourObserver, RefusesMasksOfOtherCameras) {
  const ContourObserver observer(drawnRig(2), {});
  EXPECT_THROW(observer.observe({blank()}), std::invalid_argument);
  EXPECT_THROW(observer.observe({blank(), cv::Mat::zeros(10, 10, CV_8UC1)}), std::invalid_argument);
  EXPECT_THROW(ContourObserver({}, {}), std::invalid_argument);
  ContourOptions options;
  options.robust_scale_final = 0.5;
  EXPECT_THROW(ContourObserver(drawnRig(2), options), std::invalid_argument);
}

TEST(ContourObserver, IsTheSameOnAnyNumberOfThreads) {
  const CameraRig rig = drawnRig(4);
  const ContourBody body(ShapeStatistics::handMade().meanShape(1.7));
  const auto masks = drawnMasks(rig, body, stride());
  const ContourObserver observer(rig, {});
  const auto on = [&](size_t threads) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    return observer.observe(masks);
  };
  const ContourObservation one = on(1), two = on(2);
  ASSERT_EQ(one.rays.size(), two.rays.size());
  for (size_t i = 0; i < one.rays.size(); ++i) {
    EXPECT_EQ(one.rays[i].normal, two.rays[i].normal);
    EXPECT_EQ(one.rays[i].pixel, two.rays[i].pixel);
  }
}

TEST(ContourObserver, WhatWasPreparedIsUsedForTheSameMaskOnly) {
  const CameraRig rig = drawnRig(4);
  const ContourBody body(ShapeStatistics::handMade().meanShape(1.7));
  std::vector<cv::Mat> masks = drawnMasks(rig, body, stride());
  const ContourObserver observer(rig, {});
  const ContourObservation plain = observer.observe(masks);
  observer.prepare(0, masks[0]);
  observer.prepare(1, masks[0]);                // another camera's
  observer.prepare(2, cv::Mat(2, 2, CV_8UC1));  // not of the camera's size
  observer.prepare(9, masks[0]);                // no such camera
  masks[3].at<uchar>(0, 0) = kUnknownPixel;
  observer.prepare(3, masks[3]);
  const ContourObservation one = observer.observe(masks), two = observer.observe(masks);
  EXPECT_EQ(one.views[0].distance.data, two.views[0].distance.data);
  for (const size_t camera : {1, 2, 3})
    EXPECT_NE(one.views[camera].distance.data, two.views[camera].distance.data);
  for (const size_t camera : {0, 1, 2})
    EXPECT_EQ(cv::norm(plain.views[camera].distance, one.views[camera].distance, cv::NORM_INF), 0);
  ASSERT_EQ(plain.rays.size(), one.rays.size());
  for (size_t i = 0; i < one.rays.size(); ++i) EXPECT_EQ(plain.rays[i].pixel, one.rays[i].pixel);
  masks[0] = masks[0].clone();
  EXPECT_NE(observer.observe(masks).views[0].distance.data, one.views[0].distance.data);
}

}  // namespace
}  // namespace markerless_mocap
