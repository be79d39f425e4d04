#include <opencv2/video/background_segm.hpp>

#include "silhouette/background/subtractor.h"
#include "silhouette/boundary/clean_mask.h"

namespace markerless_mocap {
namespace {

/// OpenCV's background subtractors with this room's clean-up, for comparison.
class OpenCvSubtractor final : public Subtractor {
 public:
  explicit OpenCvSubtractor(const SilhouetteOptions& options) {
    if (options.model == "mog2")
      subtractor_ = mog2_ = cv::createBackgroundSubtractorMOG2();
    else
      subtractor_ = knn_ = cv::createBackgroundSubtractorKNN();
    change(options);
  }

  void change(const SilhouetteOptions& options) override {
    options_ = options;
    const double variance = options.threshold_sigmas * options.threshold_sigmas;
    if (mog2_) {
      mog2_->setVarThreshold(variance);
      mog2_->setDetectShadows(options.remove_shadows);
      mog2_->setShadowThreshold(options.min_shadow_brightness);
    } else {
      knn_->setDist2Threshold(variance * options.min_sigma * options.min_sigma);
      knn_->setDetectShadows(options.remove_shadows);
      knn_->setShadowThreshold(options.min_shadow_brightness);
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
  cv::Ptr<cv::BackgroundSubtractorMOG2> mog2_;
  cv::Ptr<cv::BackgroundSubtractorKNN> knn_;
  cv::Ptr<cv::BackgroundSubtractor> subtractor_;  ///< one of the two
  cv::Mat classes_;
};

}  // namespace

std::unique_ptr<Subtractor> makeOpenCvSubtractor(const SilhouetteOptions& options) {
  return std::make_unique<OpenCvSubtractor>(options);
}

}  // namespace markerless_mocap
