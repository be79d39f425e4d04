#pragma once

#include <functional>
#include <ostream>

#include "capture/virtual_studio.h"

namespace markerless_mocap {

/// What of a motion becomes samples (LabelSampleWriter), and how.
struct LabelSampleOptions {
  StudioOptions studio;
  StudioFiles files;
  double pitch = 2.0 / 128.0;  ///< of the hulls, metres
  int frames = 36;             ///< spread evenly over the motion
  bool silhouettes = false;    ///< from the images; otherwise the studio's own
  std::function<bool()> interrupted = [] { return false; };  ///< asked at every frame
};

/// Films, carves and writes; after every tenth frame the same with a limb cut off (withLimbCut()),
/// as where silhouettes lose one. Throws as VirtualStudio and on options out of range, and when
/// interrupted.
void writeLabelSamples(const LabelSampleOptions& film, std::ostream* out);

}  // namespace markerless_mocap
