#include "markerless_mocap/tracking/filter_options.h"

namespace markerless_mocap {

void FilterOptions::visit(OptionVisitor& v) {
  v.field("enabled", enabled,
          "remove jitter from tf and joint_states; the topic pose is never filtered");
  v.field("cutoff", cutoff, 0.01, 100.0,
          "cutoff frequency for a body at rest, Hz; lower: less jitter");
  v.field("beta", beta, 0.0, 1000.0,
          "rise of the cutoff frequency with the fastest coordinate of the body, Hz per rad/s of a "
          "joint or of the root's rotation, or per m/s of the root; lower: less jitter in motion, "
          "but more delay");
}

}  // namespace markerless_mocap
