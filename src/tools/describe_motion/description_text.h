#pragma once

#include <ostream>
#include <string>

#include "exports/motion_description.h"

namespace markerless_mocap {

/// The table for the terminal. "±" is the expected error.
void printDescription(const MotionDescription& motion, std::ostream& out);

/// All values, with the expected error of each beside it; null: unknown.
std::string descriptionJson(const MotionDescription& motion);

}  // namespace markerless_mocap
