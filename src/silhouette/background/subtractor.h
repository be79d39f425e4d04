#pragma once

#include <memory>
#include <opencv2/core/mat.hpp>

#include "markerless_mocap/silhouette/silhouette_options.h"
#include "silhouette/background/background.h"
#include "silhouette/bits/bit_mask.h"

namespace markerless_mocap {

/// A clean mask, and how well the background fits its image.
struct Extraction {
  BitMask mask;
  double changed_fraction = 0;
  double light_gain = 1;
};

/// A background model at work on one camera's images, which are all alike.
class Subtractor {
 public:
  virtual ~Subtractor() = default;
  virtual void learn(const cv::Mat& image) = 0;
  /// After the last image to learn from.
  virtual void finishLearning() = 0;
  virtual Extraction extract(const cv::Mat& image) = 0;
  /// nullptr if the model cannot be taken out.
  virtual const Background* background() const { return nullptr; }
};

/// \param background empty: it is learned
std::unique_ptr<Subtractor> makeSubtractor(const SilhouetteOptions& options,
                                           const Background& background);
std::unique_ptr<Subtractor> makeOpenCvSubtractor(const SilhouetteOptions& options);
/// Usual colours per pixel that a model keeps; 0 if it is OpenCV's.
int modesOf(const SilhouetteOptions& options);

}  // namespace markerless_mocap
