#pragma once

#include "studies/reproduce/paper.h"

namespace markerless_mocap {

void addHsiaoTablesAndFigures(const Results& results, Page* page);
std::vector<Claim> hsiaoClaims(const Results& results);

}  // namespace markerless_mocap
