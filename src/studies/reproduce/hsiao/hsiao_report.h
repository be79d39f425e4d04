#pragma once

#include "studies/reproduce/paper.h"

namespace markerless_mocap {

/// Adds figures and tables of the thesis to the page. \return its claims
std::vector<Claim> hsiaoReport(const Results& results, Page* page);

}  // namespace markerless_mocap
