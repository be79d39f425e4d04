#include "markerless_mocap/fitting/tracker_options.h"

namespace markerless_mocap {

void TrackerOptions::visit(OptionVisitor& v) {
  v.field("method", method, {"contour", "skeleton", "sppso"},
          "how the person is followed: the body fitted to the silhouettes' contours, to the part "
          "curves and the hull (Hsiao), or searched by silhouettes and edges (Fleischmann)");
  v.field("measure", measure,
          "whether the body's sizes are measured before the first pose is claimed (contour); "
          "false: proportions of the stature");
  v.field("stature_deviation", stature_deviation, 0.001, 1.0,
          "standard deviation of the stature's error when the body is measured, m");
  v.field("measuring_poses", measuring_poses, 5, 300,
          "different poses that the body is measured from");
  v.field("filter", filter,
          "whether tf and joint_states are freed from jitter; pose is always raw");
  v.field("filter_cutoff", filter_cutoff, 0.01, 100.0,
          "cutoff of that filter for a body at rest, Hz; lower: calmer");
  v.field("filter_beta", filter_beta, 0.0, 1000.0,
          "by how much the cutoff rises with the fastest coordinate of the body, Hz per rad/s of a "
          "joint or the root's turning, or per m/s of the root; lower: calmer in motion, later");
  skeleton.visit(v);
  PrefixedVisitor of_contour("contour_", v);
  contour.visit(of_contour);
  PrefixedVisitor of_sppso("sppso_", v);
  sppso.visit(of_sppso);
}

void TrackerOptions::validate() const {
  checkFields(*this);
  skeleton.validate();
  contour.validate();
  sppso.validate();
}

}  // namespace markerless_mocap
