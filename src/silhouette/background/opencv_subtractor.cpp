#include <opencv2/video/background_segm.hpp>

#include "silhouette/background/subtractor.h"
#include "silhouette/boundary/clean_mask.h"

namespace markerless_mocap {
namespace {

/// OpenCV's background subtractors with this room's clean-up, for comparison.
class OpenCvSubtractor : public Subtractor {
 public:
  explicit OpenCvSubtractor(const SilhouetteOptions& options) : options_(options) {
    const double variance = options.threshold_sigmas * options.threshold_sigmas;
    if (options.model == "mog2") {
      auto mog2 = cv::createBackgroundSubtractorMOG2(500, variance, options.remove_shadows);
      mog2->setShadowThreshold(options.min_shadow_brightness);
      subtractor_ = mog2;
    } else {
      const double distance = variance * options.min_sigma * options.min_sigma;
      auto knn = cv::createBackgroundSubtractorKNN(500, distance, options.remove_shadows);
      knn->setShadowThreshold(options.min_shadow_brightness);
      subtractor_ = knn;
    }
  }

  void learn(const cv::Mat& image) override { subtractor_->apply(image, classes_); }
  void finishLearning() override {}

  Extraction extract(const cv::Mat& image) override {
    constexpr double kForeground = 255;  // OpenCV marks shadows as 127
    subtractor_->apply(image, classes_, options_.update_rate);
    Extraction found;
    found.changed_fraction = double(cv::countNonZero(classes_)) / double(image.total());
    found.mask = cleanBits(BitMask::fromMat(classes_ == kForeground), options_);
    return found;
  }

 private:
  SilhouetteOptions options_;
  cv::Ptr<cv::BackgroundSubtractor> subtractor_;
  cv::Mat classes_;
};

}  // namespace

std::unique_ptr<Subtractor> makeOpenCvSubtractor(const SilhouetteOptions& options) {
  return std::make_unique<OpenCvSubtractor>(options);
}

}  // namespace markerless_mocap
