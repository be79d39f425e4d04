#include "markerless_mocap/skeleton/pose_tree_options.h"

namespace markerless_mocap {

void LimbRatios::visit(OptionVisitor& v) {
  v.field("head", head, 0, 1, "head");
  v.field("upper_neck", upper_neck, 0, 1, "upper neck");
  v.field("lower_neck", lower_neck, 0, 1, "lower neck");
  v.field("shoulder", shoulder, 0, 1, "shoulder");
  v.field("upper_arm", upper_arm, 0, 1, "upper arm");
  v.field("lower_arm", lower_arm, 0, 1, "lower arm");
  v.field("hand", hand, 0, 1, "hand");
  v.field("thorax", thorax, 0, 1, "thorax");
  v.field("upper_spine", upper_spine, 0, 1, "upper spine");
  v.field("lower_spine", lower_spine, 0, 1, "lower spine");
  v.field("hip", hip, 0, 1, "hip");
  v.field("thigh", thigh, 0, 1, "thigh");
  v.field("lower_leg", lower_leg, 0, 1, "lower leg");
  v.field("foot", foot, 0, 1, "foot");
  v.field("toe", toe, 0, 1, "toe");
}

void PoseTreeOptions::visit(OptionVisitor& v) {
  v.field(
      "labelling", labelling, {"template", "ranking"},
      "how extremities are labelled; template: by the lengths of a body between them, with loops "
      "opened where these fit best; ranking: by the rank of the origin (Bakken and Hilton 2012)");
  v.field("side_rule", side_rule, {"offsets", "angles"},
          "how limbs are labelled left or right; offsets: by how far to the left thighs and upper "
          "arms are; angles: by the angles of hips and shoulders (Bakken and Hilton 2012)");
  v.field("persistence", persistence, 0, 0.2,
          "a curve of the skeleton is kept if it stands out of the body by this length after "
          "thinning, m; curves along limbs are shorter by it");
  v.field("tree_paths", tree_paths, {"shortest", "breadth_first"},
          "paths to the top-most voxel; shortest: by length; breadth_first: by number of voxels "
          "(Algorithm 2)");
  v.field("smoothing", smoothing, 0, 0.1,
          "standard deviation of the smoothing along the skeleton, m; 0: none");
  v.field("extremities", extremities, {"surface", "leaf"},
          "where an extremity is; surface: a learned distance before the hull's surface; leaf: at "
          "the leaf of the tree (Bakken and Hilton 2012)");
  v.field("prune_ratio", prune_ratio, 0.01, 0.5,
          "ranking: branches shorter than this fraction of the longest path are spurs; an arm "
          "without its shoulder is 0.274");
  v.field("leg_rank", leg_rank, {"torso", "printed"},
          "ranking: what the second factor of a leg's rank (Eq. 2) compares with its way from the "
          "branching to the origin; torso: the torso's length; printed: the leg's length");
  v.field("degree_spread", degree_spread, 0.1, 100,
          "ranking: divisor of the squared difference of the origin's degree from four (Eq. 1)");
  v.field("shortening_unit", shortening_unit, 0.0001, 1,
          "ranking: unit of the ways that shorten arms and neck (Eq. 3 and 4), m");
  v.field("min_rank", min_rank, 0, 1,
          "ranking: a frame is invalid when the rank of its origin is below this");
  v.field("min_validity", min_validity, 0, 1,
          "template: a frame is invalid when the estimated probability of correct labels and sides "
          "is below this");
  v.field("follow_labels", follow_labels,
          "ranking: label extremities by the nearest ones of the last valid frame");
  v.field("max_torso", max_torso, 1, 100,
          "of the path that both legs share, what is beyond this multiple of the torso's length "
          "belongs to the legs");
  v.field("min_bend", min_bend, 0, 1,
          "sine of the bend below which a knee or an ankle does not tell the forward direction "
          "(Algorithm 5)");
  v.field("short_leg", short_leg, 0, 100,
          "the foot of a leg that is shorter than the other one by this many foot lengths is not "
          "used (Algorithm 5)");
  v.section("limb_ratios", limb_ratios,
            "ranking and sides: lengths of limbs as fractions of the longest path (Table 1)");
}

void PoseTreeOptions::validate() const {
  checkFields(*this);
}

}  // namespace markerless_mocap
