#pragma once

#include "character/character.h"

namespace markerless_mocap {

/// A plain wooden chair of closed boxes on z = 0: who sits on it faces +x. The seat's top is 0.45 m
/// high, its middle above the origin, the back reaches up to 0.9 m.
ColoredMesh chairMesh();

}  // namespace markerless_mocap
