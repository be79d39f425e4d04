#pragma once

#include "markerless_mocap/skeleton/limb_ratios.h"

/// The published proportions, which are the units of the learned models.
namespace markerless_mocap::label_ratio {

constexpr LimbRatios kTable1{};
constexpr double kNeck = kTable1.neck(), kArm = kTable1.arm();
constexpr double kTorso = kTable1.torso(), kLeg = kTable1.leg();
constexpr double kWholeFoot = kTable1.foot + kTable1.toe;

}  // namespace markerless_mocap::label_ratio
