#pragma once

#include <string>

namespace markerless_mocap {

/// Segment lengths of a person between joint centres, metres. The torso reaches from the hips to
/// the shoulder line, the head from the base of the neck to the top of the head, the hand to the
/// finger tips, the foot from heel to toe. The comments give the names of Hsiao 2008, Table 3-1.
struct BodyProportions {
  double torso = 0, head = 0, upper_arm = 0, forearm = 0;          // L0, L1, L2, L3
  double thigh = 0, shank = 0, shoulder_width = 0, hip_width = 0;  // L4, L5, L6, L7
  double hand = 0, foot = 0, ankle_height = 0;
  double neck = 0;   ///< shoulder line to neck base
  double girth = 1;  ///< scale of all radii; 1: a person of 1.75 m and about 70 litres

  /// Average proportions for a stature in metres, 0.5 to 2.5. The implementation gives the source
  /// of each ratio.
  static BodyProportions fromStature(double stature_m);
};

/// Fills the template urdf/human.urdf.in, given as text, with id and lengths. Each `${name}` and
/// each `${expression}` of names, numbers and + - * / is replaced. Throws std::invalid_argument on
/// an unknown name, or if the id is not alphanumeric with a letter first.
std::string fillUrdfTemplate(const std::string& template_xml, const std::string& id,
                             const BodyProportions& proportions);

}  // namespace markerless_mocap
