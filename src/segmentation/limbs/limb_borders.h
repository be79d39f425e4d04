#pragma once

#include <vector>

#include "markerless_mocap/products/body_parts.h"

namespace markerless_mocap {

/// Way from a limb's tip to where the limb ends, from how the hull widens: of all nodes within a
/// way of the tip the front, those of the last stretch, is about as large as the limb's
/// cross-section, and jumps where the limb meets the trunk. The head ends where the front would
/// have it at the shoulders, less the neck.
/// \param way from the tip to each node, cube roots of the hull's volume
double limbBorder(PartLabel limb, const std::vector<double>& geodesic);

/// The border of a leg, moved to about halfway to the head: where thighs touch, both together widen
/// early; a skirt widens late.
/// \param to_head way from the leg's tip to the head's
double legBorder(double border, double to_head);

/// Whether a limb is there to its whole length: one that touches the body ends where it touches.
/// \param share of the hull's nodes that it has
bool isWholeLimb(PartLabel limb, double border, double fraction);

/// The nodes of each limb, ascending: those before its border, and where limbs overlap of that
/// limb whose border they are farther from, as shares of the way to it.
/// \param way by PartLabel, empty where there is no limb
/// \param border by PartLabel, of those limbs
std::array<std::vector<uint32_t>, kPartCount> nodesOfLimbs(
    const std::array<std::vector<double>, kPartCount>& geodesic,
    const std::array<double, kPartCount>& border);

}  // namespace markerless_mocap
