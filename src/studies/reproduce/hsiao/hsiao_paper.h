#pragma once

#include "studies/reproduce/paper.h"

namespace markerless_mocap {

/// Chapters 3 and 4 of Hsiao 2008 on nine motions of the virtual studio.
std::unique_ptr<Paper> makeHsiaoPaper(const ReproduceRequest& request);

}  // namespace markerless_mocap
