#include "markerless_mocap/pipeline/tracker_options.h"

namespace markerless_mocap {

void TrackerOptions::visit(OptionVisitor& v) {
  v.field("method", method, {"contour", "hsiao", "fleischmann"},
          "how the person is tracked; contour: fit a body to the contours of the silhouettes; "
          "hsiao: fit a body to part curves and hull (Hsiao 2008); fleischmann: search by "
          "silhouettes and edges (Fleischmann 2012)");
  person.visit(v);
  v.section("filter", filter, "output filter of tf and joint_states (Casiez et al. 2012)");
  v.section("contour", contour, "the method contour");
  v.section("hsiao", hsiao,
            "the method hsiao, which also proposes start poses to the other methods");
  v.section("fleischmann", fleischmann, "the method fleischmann");
}

void TrackerOptions::validate() const {
  checkFields(*this);
  hsiao.validate();
  contour.validate();
  fleischmann.validate();
}

}  // namespace markerless_mocap
