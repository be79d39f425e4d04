#pragma once

#include <string>

namespace markerless_mocap {

/// Segment lengths of a person between joint centres, metres: torso from the hips to the shoulder
/// line, head from the neck base to its top, hand to the finger tips, foot from heel to toe.
/// Names of Hsiao 2008, Table 3-1, in comments.
struct BodyProportions {
  double torso = 0, head = 0, upper_arm = 0, forearm = 0;          // L0, L1, L2, L3
  double thigh = 0, shank = 0, shoulder_width = 0, hip_width = 0;  // L4, L5, L6, L7
  double hand = 0, foot = 0, ankle_height = 0;
  double neck = 0;   ///< shoulder line to neck base
  double girth = 1;  ///< scale of all radii; 1 is a person of 1.75 m and about 70 litres

  /// From stature in metres, 0.5 to 2.5 (ratios with their source in the implementation).
  static BodyProportions fromStature(double stature_m);
};

/// Fills the template urdf/human.urdf.in (its text given) with id and lengths. Every `${name}` and
/// `${expression of + - * / and names}` is replaced; throws std::invalid_argument on an unknown
/// name or an id that is not letter-first alphanumeric.
std::string fillUrdfTemplate(const std::string& template_xml, const std::string& id,
                             const BodyProportions& proportions);

}  // namespace markerless_mocap
