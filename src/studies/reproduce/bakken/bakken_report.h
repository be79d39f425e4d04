#pragma once

#include "studies/reproduce/paper.h"

namespace markerless_mocap {

/// Section 4 under its own numbers, and what the learned labelling is worth. Captures that were not
/// made are left out.
std::vector<Claim> bakkenReport(const Results& results, Page* page);

/// The claims of section 4.
std::vector<Claim> bakkenClaims(const Results& results);

}  // namespace markerless_mocap
