#pragma once

#include "markerless_mocap/options/options.h"

namespace markerless_mocap {

/// Lengths of limbs as fractions of the longest path, that from a hand to a foot (Bakken & Hilton
/// 2012, Table 1).
struct LimbRatios {
  static constexpr const char* kStage = "pose_tree/limb_ratios";
  /// head
  double head = 0.042;
  /// upper neck
  double upper_neck = 0.042;
  /// lower neck
  double lower_neck = 0.042;
  /// shoulder
  double shoulder = 0.085;
  /// upper arm
  double upper_arm = 0.124;
  /// lower arm
  double lower_arm = 0.121;
  /// hand
  double hand = 0.029;
  /// thorax
  double thorax = 0.050;
  /// upper spine
  double upper_spine = 0.050;
  /// lower spine
  double lower_spine = 0.050;
  /// hip
  double hip = 0.061;
  /// thigh
  double thigh = 0.172;
  /// lower leg
  double lower_leg = 0.184;
  /// foot
  double foot = 0.050;
  /// toe
  double toe = 0.025;

  constexpr double neck() const { return head + upper_neck + lower_neck; }
  constexpr double arm() const { return shoulder + upper_arm + lower_arm + hand; }
  constexpr double torso() const { return thorax + upper_spine + lower_spine; }
  constexpr double leg() const { return hip + thigh + lower_leg + foot + toe; }

  void visit(OptionVisitor& v);
};

}  // namespace markerless_mocap
