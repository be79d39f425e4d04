#pragma once

#include <functional>
#include <ostream>

#include "capture/virtual_studio.h"

namespace markerless_mocap {

/// Options for samples from a motion (LabelSampleWriter).
struct LabelSampleOptions {
  StudioOptions studio;
  StudioFiles files;
  double pitch = 2.0 / 128.0;  ///< of the hulls, metres per voxel
  int frames = 36;             ///< distributed evenly over the motion
  bool silhouettes = false;    ///< extract silhouettes from the images; false: exact masks
  std::function<bool()> interrupted = [] { return false; };  ///< called for every frame
};

/// Renders, carves and writes samples. After every tenth frame it writes a second sample in which a
/// limb is cut off (withLimbCut()), as in damaged silhouettes. Throws as VirtualStudio, on options
/// out of range, and if interrupted.
void writeLabelSamples(const LabelSampleOptions& options, std::ostream* out);

}  // namespace markerless_mocap
