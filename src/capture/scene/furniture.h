#pragma once

#include "character/character.h"

namespace markerless_mocap {

/// A plain wooden chair of closed boxes on z = 0, metres. A person on it faces +x. The top of the
/// seat is at 0.45 m with its middle above the origin; the back reaches up to 0.9 m.
ColoredMesh chairMesh();

/// A closed cardboard box with tape and print on z = 0, 0.6 x 0.45 x 0.7 m, its middle above the
/// origin.
ColoredMesh boxMesh();

/// The leaf of a door, 0.9 x 0.04 x 2.05 m, on z = 0. It turns about the z axis; shut, it lies
/// along +x with its front towards +y.
ColoredMesh doorLeafMesh();
/// What is seen through the open door: a dark rectangle of the size of the leaf, along +x, which
/// faces +y.
ColoredMesh doorwayMesh();

}  // namespace markerless_mocap
