#include "markerless_mocap/silhouette/silhouette_extractor.h"

namespace markerless_mocap {

void SilhouetteOptions::visit(OptionVisitor& v) {
  v.field("background_frames", background_frames, 2, 250,
          "images of the empty scene that the background is learned from");
  v.field("threshold_sigmas", threshold_sigmas, 1, 50,
          "a pixel further from the background is foreground, standard deviations");
  v.field("min_sigma", min_sigma, 0.5, 50,
          "least standard deviation of a background pixel, grey levels");
  v.field("compensate_flicker", compensate_flicker,
          "divide each image by the change of light estimated over the background");
  v.field("remove_shadows", remove_shadows,
          "take foreground that is a darker shade of its background as background");
  v.field("shadow_darkest", shadow_darkest, 0.05, 1,
          "brightness of the darkest cast shadow, as a share of the background's");
  v.field("shadow_chroma_tolerance", shadow_chroma_tolerance, 0, 1,
          "a shadow's colour differs at most by this from its background's, relative");
  v.field("open_radius_px", open_radius_px, 0, 20, "radius of the opening that removes specks, px");
  v.field("close_radius_px", close_radius_px, 0, 20, "radius of the closing that joins gaps, px");
  v.field("max_hole_px", max_hole_px, 0, 1000000, "holes up to this area are filled, px");
  v.field("min_blob_px", min_blob_px, 0, 1000000, "blobs below this area are removed, px");
}

void SilhouetteOptions::validate() const {
  checkFields(*this);
}

}  // namespace markerless_mocap
