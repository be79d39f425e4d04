#include "markerless_mocap/silhouette/silhouette_extractor.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <stdexcept>

#include "silhouette/light_gain.h"
#include "silhouette/pixel_test.h"

namespace markerless_mocap {
namespace {

std::string described(const cv::Size& size, int type) {
  const char* kind = type == CV_8UC1 ? " grey" : type == CV_8UC3 ? " BGR" : " of another type";
  return std::to_string(size.width) + " x " + std::to_string(size.height) + kind;
}

}  // namespace

SilhouetteExtractor::SilhouetteExtractor(const SilhouetteOptions& options) : options_(options) {
  options_.validate();
}

SilhouetteResult SilhouetteExtractor::update(const cv::Mat& image) {
  checkImage(image);
  if (frames_learned_ < options_.background_frames) {
    learn(image);
    if (frames_learned_ == options_.background_frames) finishLearning();
    return {};
  }
  return {SilhouetteState::kReady, extract(image)};
}

void SilhouetteExtractor::reset() {
  frames_learned_ = 0;
  type_ = -1;
  sum_ = sum_of_squares_ = mean_ = inverse_sigma_ = cv::Mat();
}

void SilhouetteExtractor::checkImage(const cv::Mat& image) const {
  if (image.empty()) throw std::invalid_argument("silhouette: the image is empty");
  if (image.type() != CV_8UC1 && image.type() != CV_8UC3)
    throw std::invalid_argument("silhouette: the image must be 8 bit grey or BGR");
  if (type_ >= 0 && (image.size() != size_ || image.type() != type_))
    throw std::invalid_argument("silhouette: the image is " +
                                described(image.size(), image.type()) + ", those before were " +
                                described(size_, type_));
}

void SilhouetteExtractor::learn(const cv::Mat& image) {
  cv::Mat light;
  image.convertTo(light, CV_MAKETYPE(CV_32F, image.channels()));
  if (frames_learned_ == 0) {
    size_ = image.size();
    type_ = image.type();
    sum_ = cv::Mat::zeros(size_, light.type());
    sum_of_squares_ = sum_.clone();
  } else if (options_.compensate_flicker) {
    light *= 1 / estimateLightGain(image, sum_ / frames_learned_);
  }
  sum_ += light;
  sum_of_squares_ += light.mul(light);
  ++frames_learned_;
}

void SilhouetteExtractor::finishLearning() {
  const double n = frames_learned_;
  mean_ = sum_ / n;
  cv::Mat variance = (sum_of_squares_ - sum_.mul(mean_)) / (n - 1);
  const cv::Mat flat = variance.reshape(1);
  // This also mends constant pixels whose variance rounding put below zero.
  cv::max(flat, options_.min_sigma * options_.min_sigma, flat);
  cv::sqrt(variance, variance);
  cv::divide(1.0, variance, inverse_sigma_);
  sum_.release();
  sum_of_squares_.release();
}

cv::Mat SilhouetteExtractor::extract(const cv::Mat& image) const {
  PixelTest test;
  test.inverse_gain =
      options_.compensate_flicker ? float(1 / estimateLightGain(image, mean_)) : 1.0f;
  test.options = &options_;
  const PixelClasses classes = classifyPixels(test, image, mean_, inverse_sigma_);
  cv::Mat mask = cleanMask(classes.mask, options_);
  // Twice: blur and chroma subsampling reach two pixels far.
  for (int i = 0; i < 2; ++i) trimRim(classes.squared_distance, &mask);
  return mask;
}

}  // namespace markerless_mocap
