#pragma once

#include <set>
#include <string>

#include "markerless_mocap/options/options.h"
#include "markerless_mocap/silhouette/network_options.h"

namespace markerless_mocap {

/// Settings of one camera's silhouette stage.
struct SilhouetteOptions {
  static constexpr const char* kStage = "silhouette";
  /// background model; gaussian: one colour per pixel; mean_shift: several (Hsiao 2008); mog2, knn:
  /// OpenCV's, for comparison; network: no background, a network that segments people
  std::string model = "gaussian";
  /// what the background is learned from; first_images: the first `background_frames`; recording:
  /// all images, where nobody need leave the scene; auto: the first images if nobody is in them,
  /// else as recording. mean_shift, mog2 and knn always learn from the first images
  std::string background = "auto";
  /// number of first images that the background is learned from; they show the empty scene, or
  /// people who cross it so that every pixel shows the background most often
  int background_frames = 30;
  /// a larger image is averaged down by a whole number before all else, million pixels; lengths and
  /// areas in px below are those of the smaller image
  double max_megapixels = 1.0;
  /// a pixel that differs from the background by more than this is foreground, standard deviations
  double threshold_sigmas = 3.0;
  /// lower bound of the standard deviation of a background pixel, grey levels
  double min_sigma = 4.0;
  /// weight of each new image in the background; 0: the background stays as learned. Where a person
  /// is, gaussian and mean_shift follow only the light, mog2 and knn learn the person too
  double update_rate = 0.004;
  /// divide each image by the change of light that is estimated over the background
  bool compensate_flicker = true;
  /// foreground that is a darker shade of its background counts as background
  bool remove_shadows = true;
  /// brightness of the darkest cast shadow, as a fraction of the background's
  double min_shadow_brightness = 0.55;
  /// largest relative difference between the mean colours of a shadow and of its background
  double shadow_chroma_tolerance = 0.018;
  /// foreground that is a patch of sun, a reflection, the light of a switched lamp or a thing that
  /// stands still beside a moving person counts as background; gaussian and mean_shift, lamps and
  /// things only where all of the background is known
  bool follow_changes = true;
  /// radius of the morphological opening that removes specks, px
  int open_radius_px = 1;
  /// radius of the morphological closing that fills gaps, px
  int close_radius_px = 1;
  /// holes up to this area are filled, px; gaussian and mean_shift also fill holes up to 50 times
  /// as large if the person around them looks like the background
  int max_hole_px = 10;
  /// foreground regions below this area are removed, px
  int min_blob_px = 200;
  /// an image that differs from the background in more than this fraction of its pixels shows that
  /// the background is out of date
  double stale_fraction = 0.5;
  /// number of successive such images after which the background is reported as out of date
  int stale_frames = 60;
  /// the model network: an ONNX file and how to run it
  NetworkOptions network;

  void visit(OptionVisitor& v);
  /// Keys of what a running extractor cannot change: what the background is learned from, and the
  /// size of the images.
  static std::set<std::string> fixedKeys();
  /// Throws std::invalid_argument naming key, value and allowed range.
  void validate() const;
};

}  // namespace markerless_mocap
