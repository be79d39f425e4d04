#pragma once

#include <functional>
#include <string>
#include <vector>

#include "evaluation/joint_error.h"
#include "fleischmann/fleischmann_pose_estimator.h"
#include "studies/sppso_study/fleischmann_sequence.h"

namespace markerless_mocap {

/// One variant of the tracker.
struct StudyVariant {
  std::string name;
  FleischmannOptions options;
  double fps = 20.0;
  int runs = 5;  ///< with seeds 1, 2, ...
};

/// Variants that are compared in one table of Fleischmann 2012, chapter 6.
struct StudyTable {
  std::string id, title;
  std::vector<StudyVariant> variants;
};

/// One run over the sequence. The errors are over all tracked frames except the first one, whose
/// pose is given.
struct StudyRun {
  JointErrors errors;
  double seconds_per_frame = 0.0;
  int lost = 0;
};

/// A variant's runs.
struct StudyResult {
  std::vector<double> seconds;  ///< of the frames
  std::vector<StudyRun> runs;

  double meanError() const;                  ///< of all runs, mm
  double maxError() const;                   ///< of all runs, mm
  double medianMean() const;                 ///< median over the runs of their mean, mm
  double medianMaxError() const;             ///< median over the runs of their maximum, mm
  std::vector<double> meanOverRuns() const;  ///< D of each frame, mm
};

/// The tables 6.2 (evaluations at 60 fps, and 20 fps), 6.5 (annealed filters), 6.6 (partitions),
/// 6.8 (particles and iterations), 6.10 (silhouettes only, no upper edge of the torso), and one of
/// our own: other start poses with a smaller sigma.
std::vector<StudyTable> studyTables(const FleischmannOptions& base);

/// Tracks the sequence from its true first pose. Throws std::invalid_argument if the rate of the
/// sequence is not a multiple of the variant's.
StudyResult runVariant(const FleischmannSequence& film,
                       const FleischmannMotionStatistics& statistics, const StudyVariant& variant);

/// Silhouette, edge and total fitness around the true pose of one frame while one parameter varies
/// (Fleischmann 2012, Fig. 6.19), each scaled to 0 to 1.
struct FitnessCurves {
  std::vector<double> offsets;  ///< of the parameter
  std::vector<double> silhouette, edge, total;
};
FitnessCurves fitnessCurves(const FleischmannSequence& film, size_t frame, int parameter,
                            double reach, const FleischmannOptions& options);

/// Duration in seconds of a thousand evaluations for one frame, by part (Fleischmann 2012, Table
/// 6.5).
struct TimeByPart {
  double observing, kinematics, drawing_and_silhouette, edges, rest;
  double total() const { return observing + kinematics + drawing_and_silhouette + edges + rest; }
};
TimeByPart timeByPart(const FleischmannSequence& film,
                      const FleischmannMotionStatistics& statistics,
                      const FleischmannOptions& options);

}  // namespace markerless_mocap
