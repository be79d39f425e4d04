#pragma once

#include <opencv2/core/mat.hpp>
#include <optional>
#include <string>

#include "markerless_mocap/silhouette/silhouette_extractor.h"
#include "nodes/common/stage_status.h"
#include "ros/node_options.h"

namespace markerless_mocap {

/// The background of one camera in a file, so that a node that starts again need not learn it while
/// a person is in view. A file is believed when the first images have its size and are like it.
class KeptBackground {
 public:
  /// Reads the file, if there is one. `extractor` and `status` must outlive this object.
  KeptBackground(const std::string& camera, const SilhouetteNodeOptions& options,
                 SilhouetteExtractor* extractor, StageStatus* status);

  /// The extractor's result; none for an image that shows that the file is of another scene. Throws
  /// as SilhouetteExtractor::update().
  std::optional<SilhouetteResult> update(const cv::Mat& image, const cv::Size& whole);
  void relearn();
  /// Throws std::invalid_argument with the reason if it fails.
  void save();

 private:
  /// The result while the background from the file is checked; if the image is not like it, the
  /// reason is told, and none is returned.
  std::optional<SilhouetteResult> checked(const cv::Mat& image, const cv::Size& whole);
  void refuse(const std::string& why);
  void keep(const SilhouetteResult& result);

  std::string camera_;
  std::string file_;  ///< empty: none
  bool keeps_;        ///< whether the file is written without being asked to
  SilhouetteExtractor* extractor_;
  StageStatus* status_;
  int unchecked_ = 0;  ///< images that a background from the file is still to be checked against
  std::optional<double> saved_at_;
};

}  // namespace markerless_mocap
