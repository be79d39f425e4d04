#include "markerless_mocap/pipeline/tracker_options.h"

namespace markerless_mocap {

void TrackerOptions::visit(OptionVisitor& v) {
  v.field("method", method, {"contour", "hsiao", "fleischmann"},
          "how the person is followed: the body fitted to the silhouettes' contours, to the part "
          "curves and the hull (Hsiao), or searched by silhouettes and edges (Fleischmann)");
  person.visit(v);
  filter.visit(v);
  hsiao.visit(v);
  PrefixedVisitor of_contour("contour_", v);
  contour.visit(of_contour);
  PrefixedVisitor of_sppso("sppso_", v);
  fleischmann.visit(of_sppso);
}

void TrackerOptions::validate() const {
  checkFields(*this);
  hsiao.validate();
  contour.validate();
  fleischmann.validate();
}

}  // namespace markerless_mocap
