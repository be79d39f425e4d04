#pragma once

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "markerless_mocap/silhouette/silhouette_extractor.h"

namespace markerless_mocap {

const cv::Size kSize(160, 120);
const cv::Rect kPerson(60, 30, 30, 70);

/// A textured empty scene; `channels` 1 or 3.
inline cv::Mat makeScene(int channels, const cv::Size& size = kSize) {
  cv::Mat scene(size, CV_8UC(channels));
  cv::RNG random(7);
  random.fill(scene, cv::RNG::UNIFORM, 90, 160);
  cv::blur(scene, scene, {5, 5});
  return scene;
}

inline cv::Mat withNoise(const cv::Mat& scene, int seed) {
  cv::Mat noise(scene.size(), CV_16SC(scene.channels())), out;
  cv::RNG random(seed);
  random.fill(noise, cv::RNG::NORMAL, 0, 2);
  cv::add(scene, noise, out, cv::noArray(), scene.type());
  return out;
}

inline SilhouetteExtractor learned(const cv::Mat& scene, const SilhouetteOptions& options = {}) {
  SilhouetteExtractor extractor(options);
  for (int i = 0; i < options.background_frames; ++i) extractor.update(withNoise(scene, i));
  return extractor;
}

inline cv::Mat withPerson(const cv::Mat& scene, const cv::Rect& person = kPerson) {
  cv::Mat image = scene.clone();
  image(person).setTo(scene.channels() == 3 ? cv::Scalar(200, 30, 30) : cv::Scalar(230));
  return image;
}

inline cv::Mat exactMask(const cv::Rect& person = kPerson, const cv::Size& size = kSize) {
  cv::Mat mask = cv::Mat::zeros(size, CV_8UC1);
  mask(person).setTo(255);
  return mask;
}

inline double iou(const cv::Mat& a, const cv::Mat& b) {
  return double(cv::countNonZero(a & b)) / cv::countNonZero(a | b);
}

}  // namespace markerless_mocap
