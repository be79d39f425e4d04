#pragma once

#include "character/character.h"

namespace markerless_mocap {

/// A plain wooden chair of closed boxes on z = 0, metres. A person on it faces +x. The top of the
/// seat is at 0.45 m with its middle above the origin; the back reaches up to 0.9 m.
ColoredMesh chairMesh();

}  // namespace markerless_mocap
