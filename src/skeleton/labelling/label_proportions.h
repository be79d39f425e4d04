#pragma once

/// Lengths of limbs as fractions of the longest path, that from a hand to a foot (Bakken & Hilton
/// 2012, table 1).
namespace markerless_mocap::label_ratio {

constexpr double kHead = 0.042, kUpperNeck = 0.042, kLowerNeck = 0.042;
constexpr double kShoulder = 0.085, kUpperArm = 0.124, kLowerArm = 0.121, kHand = 0.029;
constexpr double kThorax = 0.050, kUpperSpine = 0.050, kLowerSpine = 0.050;
constexpr double kHip = 0.061, kThigh = 0.172, kLowerLeg = 0.184, kFoot = 0.050, kToe = 0.025;

constexpr double kNeck = kHead + kUpperNeck + kLowerNeck;
constexpr double kArm = kShoulder + kUpperArm + kLowerArm + kHand;
constexpr double kTorso = kThorax + kUpperSpine + kLowerSpine;
constexpr double kLeg = kHip + kThigh + kLowerLeg + kFoot + kToe;

}  // namespace markerless_mocap::label_ratio
