#pragma once

#include <functional>
#include <string>
#include <vector>

#include "evaluation/joint_error.h"
#include "fleischmann/fleischmann_pose_estimator.h"
#include "studies/sppso_study/fleischmann_sequence.h"

namespace markerless_mocap {

/// One way to track the film.
struct StudyVariant {
  std::string name;
  FleischmannOptions options;
  double fps = 20.0;
  int runs = 5;  ///< with the seeds 1, 2, ...
};

/// Variants that are held against each other, as one table of Fleischmann 2012, chapter 6.
struct StudyTable {
  std::string id, title;
  std::vector<StudyVariant> variants;
};

/// One run over the film: the error measures are over all tracked frames but the first, which is
/// given.
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
  double medianMean() const;                 ///< of the runs' means, mm
  double medianMaxError() const;             ///< of the runs' largest, mm
  std::vector<double> meanOverRuns() const;  ///< D of each frame, mm
};

/// The tables: 6.2 (evaluations at 60 fps, and 20 fps), 6.5 (annealed filters), 6.6 (partitions),
/// 6.8 (particles against iterations), 6.10 (silhouettes alone, no upper edge), and ours: other
/// starts with a narrower spread.
std::vector<StudyTable> studyTables(const FleischmannOptions& base);

/// Tracks the film from its true first pose. Throws std::invalid_argument unless the film's rate is
/// a multiple of the variant's.
StudyResult runVariant(const FleischmannSequence& film,
                       const FleischmannMotionStatistics& statistics, const StudyVariant& variant);

/// Silhouette, edge and total fitness about the truth of one frame while one parameter varies
/// (Fleischmann 2012, Fig. 6.19), each stretched to 0..1.
struct FitnessCurves {
  std::vector<double> offsets;  ///< of the parameter
  std::vector<double> silhouette, edge, total;
};
FitnessCurves fitnessCurves(const FleischmannSequence& film, size_t frame, int parameter,
                            double reach, const FleischmannOptions& options);

/// Seconds of one frame's thousand evaluations by part (Fleischmann 2012, Table 6.5).
struct TimeByPart {
  double observing, kinematics, drawing_and_silhouette, edges, rest;
  double total() const { return observing + kinematics + drawing_and_silhouette + edges + rest; }
};
TimeByPart timeByPart(const FleischmannSequence& film,
                      const FleischmannMotionStatistics& statistics,
                      const FleischmannOptions& options);

}  // namespace markerless_mocap
