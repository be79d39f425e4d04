#pragma once

#include <memory>
#include <optional>

#include "evaluation/joint_track.h"
#include "markerless_mocap/pipeline/pipeline.h"
#include "studies/reproduce/paper.h"
#include "tools/common/recording.h"

namespace markerless_mocap {

/// One of the sequences of chapter 4, and the motion of this package that is like it.
struct HsiaoSequence {
  std::string id;    ///< s1 to s9
  std::string name;  ///< in the thesis
  int frames;        ///< number of frames in the thesis, at about 30 per second
  std::string rig;   ///< Figure 3-5: eight around; Figure 4-1: seven around, one above
  std::string motion;
  double start;  ///< seconds of the motion that a short capture skips
};
const std::vector<HsiaoSequence>& hsiaoSequences();

/// Captures of the nine sequences (eight cameras, 320 x 240, 30 per second), then of s1 by the
/// cameras of Figure 4-1 ("s1_overhead") and by four at the ceiling whose calibration is 4 px off
/// ("laboratory"), as the thesis' own. Short ones have 24 frames at 10 per second.
std::vector<Capture> hsiaoCaptures(bool quick);

/// True points of a capture, by stamp: groundTruthNames().
struct HsiaoTruth {
  JointTrack points;
  double stature;
};
/// From the options of the capture alone. Throws as VirtualStudio.
HsiaoTruth hsiaoTruth(const Capture& capture);

/// A capture that runs through the stages.
class HsiaoFilm {
 public:
  /// \param truth of the capture; its stature is given to the system
  /// \param changes of the options in config/as_published/hsiao.yaml, by path ("a/b/c")
  HsiaoFilm(const Capture& capture, const HsiaoTruth& truth, const Overrides& changes);

  /// What the stages make of the next frame set that shows the person; nothing after the last.
  std::optional<PipelineResult> next();
  const FrameSet& frameSet() const { return frame_set_; }
  const CameraRig& rig() const { return recording_.rig(); }
  const PipelineOptions& options() const { return options_; }

 private:
  Recording recording_;
  int64_t first_stamp_;
  PipelineOptions options_;
  Pipeline pipeline_;
  FrameSet frame_set_;
};

/// The options as published, changed.
PipelineOptions publishedHsiao(double stature, const Overrides& changes);

}  // namespace markerless_mocap
