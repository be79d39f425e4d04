#include "markerless_mocap/silhouette/silhouette_options.h"

namespace markerless_mocap {

void SilhouetteOptions::visit(OptionVisitor& v) {
  v.field("model", model, {"gaussian", "mean_shift", "mog2", "knn", "network"},
          "background model; gaussian: one colour per pixel; mean_shift: several (Hsiao 2008); "
          "mog2, knn: OpenCV's, for comparison; network: no background, a network that segments "
          "people");
  v.field("background", background, {"auto", "first_images", "recording"},
          "what the background is learned from; first_images: the first `background_frames`; "
          "recording: all images, where nobody need leave the scene; auto: the first images if "
          "nobody is in them, else as recording. mean_shift, mog2 and knn always learn from the "
          "first images");
  v.field(
      "background_frames", background_frames, 2, 10000,
      "number of first images that the background is learned from; they show the empty scene, or "
      "people who cross it so that every pixel shows the background most often");
  v.field("max_megapixels", max_megapixels, 0.01, 1000,
          "a larger image is averaged down by a whole number before all else, million pixels; "
          "lengths and areas in px below are those of the smaller image");
  v.field("threshold_sigmas", threshold_sigmas, 1, 50,
          "a pixel that differs from the background by more than this is foreground, standard "
          "deviations");
  v.field("min_sigma", min_sigma, 0.5, 50,
          "lower bound of the standard deviation of a background pixel, grey levels");
  v.field("update_rate", update_rate, 0, 0.1,
          "weight of each new image in the background; 0: the background stays as learned. Where a "
          "person is, gaussian and mean_shift follow only the light, mog2 and knn learn the person "
          "too");
  v.field("compensate_flicker", compensate_flicker,
          "divide each image by the change of light that is estimated over the background");
  v.field("remove_shadows", remove_shadows,
          "foreground that is a darker shade of its background counts as background");
  v.field("min_shadow_brightness", min_shadow_brightness, 0.05, 1,
          "brightness of the darkest cast shadow, as a fraction of the background's");
  v.field("shadow_chroma_tolerance", shadow_chroma_tolerance, 0, 1,
          "largest relative difference between the mean colours of a shadow and of its background");
  v.field(
      "follow_changes", follow_changes,
      "foreground that is a patch of sun, a reflection, the light of a switched lamp or a thing "
      "that stands still beside a moving person counts as background; gaussian and mean_shift, "
      "lamps and things only where all of the background is known");
  v.field("open_radius_px", open_radius_px, 0, 20,
          "radius of the morphological opening that removes specks, px");
  v.field("close_radius_px", close_radius_px, 0, 20,
          "radius of the morphological closing that fills gaps, px");
  v.field("max_hole_px", max_hole_px, 0, 1000000,
          "holes up to this area are filled, px; gaussian and mean_shift also fill holes up to 50 "
          "times as large if the person around them looks like the background");
  v.field("min_blob_px", min_blob_px, 0, 1000000,
          "foreground regions below this area are removed, px");
  v.field("stale_fraction", stale_fraction, 0, 1,
          "an image that differs from the background in more than this fraction of its pixels "
          "shows that the background is out of date");
  v.field("stale_frames", stale_frames, 1, 100000,
          "number of successive such images after which the background is reported as out of date");
  v.section("network", network, "the model network: an ONNX file and how to run it");
}

std::set<std::string> SilhouetteOptions::fixedKeys() {
  return {"model", "background", "background_frames", "max_megapixels", "network"};
}

void SilhouetteOptions::validate() const {
  checkFields(*this);
}

}  // namespace markerless_mocap
