#pragma once

#include <memory>
#include <opencv2/core/mat.hpp>

#include "markerless_mocap/silhouette/silhouette_options.h"
#include "silhouette/background/background.h"
#include "silhouette/bits/bit_mask.h"

namespace markerless_mocap {

/// A clean mask, and how well the background fits the image.
struct Extraction {
  BitMask mask;                 ///< foreground and unknown
  BitMask unknown = BitMask();  ///< without rows: nothing is unknown
  double changed_fraction = 0;
  double light_gain = 1;
  size_t uncovered = 0;  ///< pixels that became background as what had stood there has left
  /// Somebody whom the background was learned behind, as they kept still, stands there no more.
  bool has_left_place = false;
};

/// Background subtraction of one camera's images, which all have the same size and type.
class Subtractor {
 public:
  virtual ~Subtractor() = default;
  virtual void learn(const cv::Mat& image) = 0;
  /// Call this after the last image to learn from.
  virtual void finishLearning() = 0;
  virtual Extraction extract(const cv::Mat& image) = 0;
  /// Takes over the settings; what was learned stays.
  virtual void change(const SilhouetteOptions& options) = 0;
  /// nullptr if the model has no background that can be saved.
  virtual const Background* background() const { return nullptr; }
};

/// \param background empty: the background is learned
std::unique_ptr<Subtractor> makeSubtractor(const SilhouetteOptions& options,
                                           const Background& background);
std::unique_ptr<Subtractor> makeOpenCvSubtractor(const SilhouetteOptions& options);
/// Needs no learning. Throws as PersonNet.
std::unique_ptr<Subtractor> makeNetworkSubtractor(const SilhouetteOptions& options);
/// Number of modes per pixel of a model; 0 for OpenCV's models and for a network.
int modesOf(const SilhouetteOptions& options);

}  // namespace markerless_mocap
