#pragma once

#include <vector>

#include "markerless_mocap/products/body_parts.h"

namespace markerless_mocap {

/// Geodesic distance from a limb's extremity to its border with the trunk, from the widening of the
/// hull. The front, the number of nodes in the last interval of the distance, is about the limb's
/// cross-section; it jumps where the limb meets the trunk. For the head the jump is at the
/// shoulders, and the neck is subtracted.
/// \param geodesic geodesic distances from the extremity to each node, cube roots of the hull's
/// volume
double limbBorder(PartLabel limb, const std::vector<double>& geodesic);

/// The border of a leg, limited to about half of the distance to the head: thighs that touch widen
/// too early, a skirt too late.
/// \param to_head distance from the foot's extremity to the head's
double legBorder(double border, double to_head);

/// Whether a limb has its whole length. A limb that touches the body ends where it touches.
/// \param fraction fraction of the hull's nodes that belong to it
bool isWholeLimb(PartLabel limb, double border, double fraction);

/// The nodes of each limb, ascending: those before its border. A node before several borders
/// belongs to the limb for which its distance is the smallest fraction of the border.
/// \param geodesic by PartLabel; empty if the limb is not found
/// \param border by PartLabel, of the limbs found
std::array<std::vector<uint32_t>, kPartCount> nodesOfLimbs(
    const std::array<std::vector<double>, kPartCount>& geodesic,
    const std::array<double, kPartCount>& border);

}  // namespace markerless_mocap
