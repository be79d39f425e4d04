#pragma once

#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "exports/motion_description.h"

namespace markerless_mocap {

/// Rows of names and values under a title; "±" is the expected error.
struct DescriptionSection {
  std::string title;
  std::vector<std::pair<std::string, std::string>> rows;
};
std::vector<DescriptionSection> descriptionSections(const MotionDescription& motion);

/// The same for the terminal.
void printDescription(const MotionDescription& motion, std::ostream& out);

/// All values, with the expected error of each beside it; null: unknown.
std::string descriptionJson(const MotionDescription& motion);

}  // namespace markerless_mocap
