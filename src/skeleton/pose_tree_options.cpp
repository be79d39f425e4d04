#include "markerless_mocap/skeleton/pose_tree_options.h"

namespace markerless_mocap {

void PoseTreeOptions::visit(OptionVisitor& v) {
  v.field(
      "labelling", labelling, {"template", "ranking"},
      "how extremities are labelled; template: by the lengths of a body between them, with loops "
      "opened where these fit best; ranking: by the rank of the origin (Bakken and Hilton 2012)");
  v.field("side_rule", side_rule, {"offsets", "angles"},
          "how limbs are labelled left or right; offsets: by how far to the left thighs and upper "
          "arms are; angles: by the angles of hips and shoulders (Bakken and Hilton 2012)");
  v.field("prune_ratio", prune_ratio, 0.01, 0.5,
          "ranking: branches shorter than this fraction of the longest path are spurs; 0.274 in "
          "the paper");
  v.field("min_rank", min_rank, 0, 1,
          "ranking: a frame is invalid when the rank of its origin is below this");
  v.field("min_validity", min_validity, 0, 1,
          "template: a frame is invalid when the estimated probability of correct labels and sides "
          "is below this");
  v.field("follow_labels", follow_labels,
          "ranking: label extremities by the nearest ones of the last valid frame");
}

void PoseTreeOptions::validate() const {
  checkFields(*this);
}

}  // namespace markerless_mocap
