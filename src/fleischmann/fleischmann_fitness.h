#pragma once

#include <memory>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "fleischmann/fleischmann_body_model.h"
#include "fleischmann/model/fleischmann_body_shape.h"
#include "markerless_mocap/camera/camera.h"
#include "markerless_mocap/fleischmann/fleischmann_image_options.h"

namespace markerless_mocap {

struct EdgeSum;

/// Input of one camera at one time.
struct FleischmannView {
  cv::Mat silhouette;  ///< CV_8UC1 of the size of the camera's image, 0 | 128 unknown | person;
                       ///< empty if missing
  cv::Mat image;       ///< CV_8UC1 or CV_8UC3 BGR of the same size; empty if this view has no edges
};

/// The edges of the body that are compared.
struct EdgeSelection {
  ConeSet cones = kAllButHead;  ///< both sides of these cones; 0: edges are ignored
  bool torso_top = true;        ///< also the upper edge of the torso, if the torso is in `cones`
};

/// Agreement of a pose with the images: means over the views, 0 to 1 each.
struct FitnessTerms {
  double silhouette = 0.0;  ///< f_s
  double edge = 0.0;        ///< f_e
  double total() const { return silhouette + edge; }
};

/// Visibility of some of the cones in the silhouettes: pixels, summed over the views.
struct ConeVisibility {
  int64_t drawn = 0;   ///< of these cones
  int64_t alone = 0;   ///< pixels that no other cone covers
  int64_t inside = 0;  ///< pixels of `alone` in the silhouette
};

/// Draws the ten cones into all views and compares them with the silhouettes and edges (Fleischmann
/// 2012, 5.2). Each cone is drawn as the quadrilateral between the two lines of its visible
/// contour. fitness() is thread-safe.
class FleischmannFitness {
 public:
  /// Throws std::invalid_argument if an option is out of range.
  FleischmannFitness(const CameraRig& rig, const FleischmannBodyModel& body_model,
                     const FleischmannBodyShape& body, const FleischmannImageOptions& options);
  ~FleischmannFitness();

  /// Sets the images, one view per camera. Throws std::invalid_argument if their number, sizes or
  /// types are wrong. \return the number of views that show a person; the others are ignored
  int observe(const std::vector<FleischmannView>& views);

  /// f_s is the mean over the views of the fraction of the drawing that is in the silhouette and
  /// the fraction of the silhouette that is drawn, weighted (Eq. 5.5); unknown pixels are left
  /// out of both. f_e is the mean of the edge
  /// map under the edges of the body (Eq. 5.1). Both are 0 in a view that does not contain the
  /// body, and without views.
  /// \param candidate kFleischmannParameterCount values
  FitnessTerms fitness(const double* candidate, const EdgeSelection& edges) const;

  /// Visibility of a set of cones. If no view shows them apart from the other cones, there is no
  /// evidence for their pose.
  ConeVisibility evidence(const double* candidate, ConeSet cones) const;

  /// The drawing in a view: CV_8UC1 of the size of the reduced image, 255 = body.
  cv::Mat drawing(const double* candidate, int view) const;
  /// The outlines of the cones in a view, by FleischmannConeId: four corners in pixels of the
  /// reduced image, or none where a cone has no outline.
  std::vector<std::vector<cv::Point2f>> outlines(const double* candidate, int view) const;
  /// The edge map of a view, CV_8UC1; all 0 without an image.
  const cv::Mat& edges(int view) const;
  const FleischmannBodyModel& bodyModel() const { return body_model_; }

 private:
  struct View;
  struct Scratch;
  void place(const double* candidate, Scratch& scratch) const;
  Scratch& scratch() const;
  EdgeSum edgesOf(const View& view, const Scratch& s, const EdgeSelection& choice) const;

  FleischmannBodyModel body_model_;
  FleischmannImageOptions options_;
  struct Cones;
  std::unique_ptr<const Cones> cones_;
  std::vector<View> views_;
};

}  // namespace markerless_mocap
