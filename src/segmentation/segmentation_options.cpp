#include <stdexcept>
#include <string>

#include "markerless_mocap/segmentation/body_segmenter.h"

namespace markerless_mocap {

void ColorBonus::visit(OptionVisitor& v) {
  v.field(
      "all", all, -0.99, 1.0,
      "a of Eq. 3-15: added to an edge's weight of 1 when all cameras that vote find one colour");
  v.field("most", most, -0.99, 1.0, "b of Eq. 3-15: added when most of them do");
  v.field("few", few, -0.99, 1.0,
          "c of Eq. 3-15: added when few of them do; every weight stays above 0");
  v.field("most_from", most_from, 0.0, 1.0,
          "th_1 of Eq. 3-15, as a fraction of the cameras that vote: from here on, most do");
  v.field("few_below", few_below, 0.0, 1.0,
          "th_3 of Eq. 3-15, as a fraction of the cameras that vote: below this, few do");
}

void SplineWalkOptions::visit(OptionVisitor& v) {
  v.field("initial_nodes", initial_nodes, 0.0, 1.0,
          "P: number of nodes that a branch begins with, as a fraction of all nodes");
  v.field("step_nodes", step_nodes, 0.0, 1.0,
          "N: number of nodes that a step adds, as a fraction of all nodes");
  v.field("turn_angle", turn_angle, 0.0, 1.6,
          "a new principal direction is used where it turns by more than this, rad");
  v.field("stop_radius", stop_radius, 0.0, 1.0,
          "a branch ends this near the origin, as a fraction of the largest distance of a node "
          "from it");
  v.field("max_outliers", max_outliers, 0.0, 1.0,
          "OT_1: a branch ends with more outliers than this, as a fraction of all nodes");
  v.field("outlier_distance", outlier_distance, 0.0, 1.0,
          "OT_2: a node this far from the spline is an outlier, as a fraction of its start's "
          "distance");
  v.field("tube_radius", tube_radius, 0.0, 1.0,
          "nodes this near the spline belong to the branch, as a fraction of its start's distance");
}

void SegmentationOptions::visit(OptionVisitor& v) {
  v.field("branch_method", branch_method, {"merge_tree", "spline_walk"},
          "how limbs are found in the eigenmap; merge_tree: by the maxima of the distance from the "
          "core; spline_walk: by splines that grow inwards from the extremities");
  v.field("walk_stop", walk_stop, {"origin", "outliers"},
          "where a branch of spline_walk ends; origin: near the origin of the eigenmap (Hsiao "
          "2008), with a shrink_weight; outliers: where many nodes are far from the "
          "spline (Sundaresan and Chellappa 2008), with shrink_weight 0");
  v.field("modes", modes, 0, 20,
          "dimensions of the eigenmap; 0: 10 for merge_tree, 6 for spline_walk");
  v.field(
      "use_color_votes", use_color_votes,
      "weight the edges between voxels by the cameras' votes that neighbours have the same colour");
  v.section("color_bonus", color_bonus, "how votes weight edges");
  v.field(
      "shrink_weight", shrink_weight, 0.0, 1000.0,
      "weight added to the edges in the thick core of the body, which draws the torso together");
  v.field("shrink_degree", shrink_degree, 0.0, 1.0,
          "which nodes are the thick core; 0: those deepest under the surface; else those with at "
          "least this fraction of the largest degree (Hsiao 2008, 3.1.4.2 A-2: 1)");
  v.section("spline_walk", spline_walk, "the method spline_walk");
  v.field("site_modes", site_modes, 0, 20,
          "modes of a part's own eigenmap that give its curve's site values; 0: 10 for the torso, "
          "3 for other parts; 1: the Fiedler vector alone (Hsiao 2008, 3.1.5.2)");
  v.field(
      "max_cost", max_cost, 0.1, 9.0,
      "a hull is not a person when the mean squared z-score of its limbs' measures is above this");
  v.field("min_litres", min_litres, 0.0, 1000.0, "volume of the smallest hull of a person, litres");
  v.field("max_litres", max_litres, 0.0, 1000.0, "volume of the largest hull of a person, litres");
}

void SegmentationOptions::validate() const {
  checkFields(*this);
  if (min_litres >= max_litres) {
    throw std::invalid_argument(
        std::string(kStage) + "/min_litres is " + std::to_string(min_litres) +
        ", allowed is less than max_litres, which is " + std::to_string(max_litres));
  }
}

}  // namespace markerless_mocap
