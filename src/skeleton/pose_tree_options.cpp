#include "markerless_mocap/skeleton/pose_tree_options.h"

namespace markerless_mocap {

void PoseTreeOptions::visit(OptionVisitor& v) {
  v.field(
      "labelling", labelling, {"template", "ranking"},
      "how ends are named: by a body's lengths between them, loops opened where these fit best, "
      "or by the rank of the origin as published");
  v.field(
      "side_rule", side_rule, {"offsets", "angles"},
      "how limbs are called left or right: by how far to the left thighs and upper arms lie, or "
      "by the angles of hips and shoulders as published");
  v.field("prune_ratio", prune_ratio, 0.01, 0.5,
          "in `ranking`, branches shorter than this share of the longest path are spurs; as "
          "published 0.274");
  v.field("min_rank", min_rank, 0, 1,
          "in `ranking`, ranks of the origin below this make a frame invalid");
  v.field("min_validity", min_validity, 0, 1,
          "in `template`, estimated probability of right labels and sides below which a frame is "
          "invalid");
  v.field("follow_labels", follow_labels,
          "in `ranking`, ends are named by the nearest ones of the last valid frame");
}

void PoseTreeOptions::validate() const {
  checkFields(*this);
}

}  // namespace markerless_mocap
