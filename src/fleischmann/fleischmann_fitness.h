#pragma once

#include <memory>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "fleischmann/fleischmann_body_model.h"
#include "fleischmann/model/fleischmann_body_shape.h"
#include "markerless_mocap/camera/camera.h"
#include "markerless_mocap/fleischmann/fleischmann_image_options.h"

namespace markerless_mocap {

/// What one camera has at an instant.
struct FleischmannView {
  cv::Mat silhouette;  ///< CV_8UC1 of the camera's size, non-zero = person; empty: nothing came
  cv::Mat image;       ///< CV_8UC1 or CV_8UC3 BGR of the same size; empty: no edges in this view
};

/// Which edges of the body are looked at.
struct EdgeSelection {
  ConeSet cones = kAllButHead;  ///< both sides of these; 0: edges do not count
  bool torso_top = true;        ///< the upper edge of the torso too, when it is among them
};

/// How well a pose agrees with the images: means over the views, 0 to 1 each.
struct FitnessTerms {
  double silhouette = 0.0;  ///< f_s
  double edge = 0.0;        ///< f_e
  double total() const { return silhouette + edge; }
};

/// What the silhouettes say of some of the cones: pixels, sums over the views.
struct ConeVisibility {
  int64_t drawn = 0;   ///< of these cones
  int64_t alone = 0;   ///< those that no other cone covers
  int64_t inside = 0;  ///< of `alone`, in the silhouette
};

/// Draws the ten cones into all views and compares them with what was observed (Fleischmann 2012,
/// 5.2). Each cone is the quadrilateral between the two lines of its visible contour. fitness() may
/// be called from many threads at once.
class FleischmannFitness {
 public:
  /// Throws std::invalid_argument on options out of range.
  FleischmannFitness(const CameraRig& rig, const FleischmannBodyModel& profile,
                     const FleischmannBodyShape& body, const FleischmannImageOptions& options);
  ~FleischmannFitness();

  /// Takes the images of an instant, one view for each camera. Throws std::invalid_argument if
  /// their number, sizes or types are wrong. \return views that show a person; only they count
  int observe(const std::vector<FleischmannView>& views);

  /// f_s is the mean over the views of half the share of the drawing that is in the silhouette and
  /// half the share of the silhouette that is drawn (Eq. 5.5), f_e that of the edge map under the
  /// body's edges (Eq. 5.1). 0 in a view that the body is not in, or without views.
  /// \param candidate kFleischmannParameterCount values
  FitnessTerms fitness(const double* candidate, const EdgeSelection& edges) const;

  /// Cones that no view shows apart from the others have nothing that speaks for their pose.
  ConeVisibility evidence(const double* candidate, ConeSet cones) const;

  /// The drawing in a view: CV_8UC1 of the reduced image's size, 255 = body.
  cv::Mat drawing(const double* candidate, int view) const;
  /// The edge map of a view, CV_8UC1; all 0 without an image.
  const cv::Mat& edges(int view) const;
  const FleischmannBodyModel& profile() const { return profile_; }

 private:
  struct View;
  struct Scratch;
  void place(const double* candidate, Scratch& scratch) const;
  Scratch& scratch() const;

  FleischmannBodyModel profile_;
  FleischmannImageOptions options_;
  struct Cones;
  std::unique_ptr<const Cones> cones_;
  std::vector<View> views_;
};

}  // namespace markerless_mocap
