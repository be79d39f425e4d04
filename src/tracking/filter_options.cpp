#include "markerless_mocap/tracking/filter_options.h"

namespace markerless_mocap {

void FilterOptions::visit(OptionVisitor& v) {
  v.field("filter", enabled,
          "whether tf and joint_states are freed from jitter; pose is always raw");
  v.field("filter_cutoff", cutoff, 0.01, 100.0,
          "cutoff of that filter for a body at rest, Hz; lower: calmer");
  v.field("filter_beta", beta, 0.0, 1000.0,
          "by how much the cutoff rises with the fastest coordinate of the body, Hz per rad/s of a "
          "joint or the root's turning, or per m/s of the root; lower: calmer in motion, later");
}

}  // namespace markerless_mocap
