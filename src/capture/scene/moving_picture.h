#pragma once

#include "capture/scene/panel.h"

namespace markerless_mocap {

/// A screen that plays a film: cuts every 1.5 s, between them soft patches that drift.
/// \param seconds any time
ColoredMesh screenMesh(const Panel& panel, double seconds);

/// A window onto trees that move in the wind before a bright sky.
ColoredMesh windowMesh(const Panel& panel, double seconds);

}  // namespace markerless_mocap
