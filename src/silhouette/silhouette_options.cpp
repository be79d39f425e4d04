#include "markerless_mocap/silhouette/silhouette_options.h"

namespace markerless_mocap {

void SilhouetteOptions::visit(OptionVisitor& v) {
  v.field("model", model, {"gaussian", "mean_shift", "mog2", "knn"},
          "background model: one usual colour per pixel, several, or OpenCV's for comparison");
  v.field("background_frames", background_frames, 2, 10000,
          "images that the background is learned from: of the empty scene, or of one that people "
          "cross so that every pixel shows the scene more often than anything else");
  v.field("threshold_sigmas", threshold_sigmas, 1, 50,
          "a pixel further from the background is foreground, standard deviations");
  v.field("min_sigma", min_sigma, 0.5, 50,
          "least standard deviation of a background pixel, grey levels");
  v.field(
      "update_rate", update_rate, 0, 0.1,
      "share of each image in the background; 0: it stays as learned. Where a person is it only "
      "follows the light, but mog2 and knn learn people too");
  v.field("compensate_flicker", compensate_flicker,
          "divide each image by the change of light estimated over the background");
  v.field("remove_shadows", remove_shadows,
          "take foreground that is a darker shade of its background as background");
  v.field("min_shadow_brightness", min_shadow_brightness, 0.05, 1,
          "brightness of the darkest cast shadow, as a share of the background's");
  v.field("shadow_chroma_tolerance", shadow_chroma_tolerance, 0, 1,
          "a shadow's mean colour differs at most by this from its background's, relative");
  v.field("open_radius_px", open_radius_px, 0, 20, "radius of the opening that removes specks, px");
  v.field("close_radius_px", close_radius_px, 0, 20, "radius of the closing that joins gaps, px");
  v.field("max_hole_px", max_hole_px, 0, 1000000,
          "holes up to this area are filled, px; gaussian and mean_shift also fill those up to 50 "
          "times as large around which the person looks like the background");
  v.field("min_blob_px", min_blob_px, 0, 1000000, "blobs below this area are removed, px");
  v.field("stale_fraction", stale_fraction, 0, 1,
          "more of the image than this share differs from a background that is stale");
  v.field("stale_frames", stale_frames, 1, 100000,
          "the background is stale after so many such images in a row");
}

void SilhouetteOptions::validate() const {
  checkFields(*this);
}

}  // namespace markerless_mocap
