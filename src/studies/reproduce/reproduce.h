#pragma once

#include "studies/reproduce/paper.h"
#include "studies/reproduce/run_list.h"

namespace markerless_mocap {

/// Renders the captures, executes the runs and writes FOLDER/index.html, FOLDER/claims.csv and
/// FOLDER/results.json. Throws as executeRuns().
/// \param studio changes the virtual studio of all captures
std::vector<Claim> reproduce(const Paper& paper, const ReproduceRequest& request,
                             const Overrides& studio, const RunListOptions& options);

/// Page with the claims first, then the tables and figures.
Page paperPage(const std::string& title, const std::vector<Claim>& claims, const Page& body);
/// Comma-separated values, one line per claim.
std::string claimsCsv(const std::vector<Claim>& claims);

}  // namespace markerless_mocap
