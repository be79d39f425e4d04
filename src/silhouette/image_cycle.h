#pragma once

namespace markerless_mocap {

/// What silhouettes do with every n-th image only, begins anew after so many images of a camera.
constexpr int kImageCycle = 240;

}  // namespace markerless_mocap
