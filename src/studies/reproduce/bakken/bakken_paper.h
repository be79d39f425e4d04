#pragma once

#include <memory>

#include "studies/reproduce/paper.h"

namespace markerless_mocap {

/// Bakken & Hilton 2012: the dance of section 4 before seven cameras and one overhead, and
/// stand-ins for the recordings of i3DPost.
std::unique_ptr<Paper> makeBakkenPaper(const ReproduceRequest& request);

}  // namespace markerless_mocap
