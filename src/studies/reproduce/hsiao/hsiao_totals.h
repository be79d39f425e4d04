#pragma once

#include <string>
#include <vector>

#include "evaluation/joint_error.h"
#include "evaluation/part_truth.h"
#include "studies/reproduce/paper.h"

namespace markerless_mocap {

/// Results of tracked sequences (trackSequence()).
struct Tracked {
  SummaryStatistics D;                ///< mm
  SummaryStatistics D_of_six;         ///< mm, in frames whose segmentation has six parts
  SummaryStatistics D_of_fewer;       ///< mm, in the other frames
  double six;                         ///< share of these frames
  double lost, reset, swaps, jitter;  ///< shares; mm
};
Tracked trackedOf(const std::vector<const Json*>& runs);

/// The runs of the published system over one sequence, one for each seed.
std::vector<const Json*> publishedRuns(const Results& results, const std::string& sequence);

/// Over all nine sequences.
struct HsiaoTotals {
  std::vector<const Json*> published, basic;
  std::vector<double> ours;       ///< mean D of the default method, mm
  std::vector<double> ours_lost;  ///< its share of frames without a pose
};
HsiaoTotals totalsOf(const Results& results);

/// Share of the frames with a pose whose D is at most `limit`, mm.
double shareWithin(const std::vector<const Json*>& runs, double limit);

/// How well a variant of the segmentation (partVariants()) cuts the nine sequences.
struct PartTotals {
  double correct = 0.0, six = 0.0;  ///< shares
  std::vector<double> found = std::vector<double>(kTruePartCount, 0.0);
  std::vector<double> curve = std::vector<double>(4, 0.0);  ///< torso, head, arms, legs; mm
};
PartTotals partsOf(const Results& results, const std::string& variant);

/// "0 %", "207 mm"
std::string wholePercent(double fraction);
std::string wholeMillimetres(double mm);

}  // namespace markerless_mocap
