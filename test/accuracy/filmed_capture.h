#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "capture/ground_truth.h"
#include "capture/studio_fixture.h"
#include "capture/virtual_studio.h"
#include "evaluation/joint_track.h"
#include "markerless_mocap/pipeline/pipeline.h"

namespace markerless_mocap {

/// A recording of the virtual studio in memory: images only, as a recording's reader gives them,
/// and the true joints beside them.
class FilmedCapture {
 public:
  explicit FilmedCapture(const StudioOptions& options)
      : studio_(options, packageFiles(), "person1"), rig_(studio_.rig()) {
    truth_.names = groundTruthNames();
    for (int i = 0; i < studio_.frameSetCount(); ++i) add(studio_.render(i));
  }

  /// The studio's, or what is taken for it.
  const CameraRig& rig() const { return rig_; }
  void useRig(const CameraRig& rig) { rig_ = rig; }
  const JointTrack& truth() const { return truth_; }
  const std::vector<FrameSet>& frameSets() const { return frame_sets_; }

  /// Hands out the frame sets one after the other, from the first.
  Pipeline::Source reader() const {
    return [this, next = size_t(0)]() mutable -> std::optional<FrameSet> {
      if (next == frame_sets_.size()) return std::nullopt;
      return frame_sets_[next++];
    };
  }

 private:
  static constexpr int64_t kFirstStamp_ns = 1000'000'000'000;

  void add(const StudioFrameSet& filmed) {
    FrameSet frame_set;
    frame_set.stamp_ns = kFirstStamp_ns + filmed.time_ns;
    for (const cv::Mat& image : filmed.images) frame_set.frames.push_back({image, cv::Mat()});
    frame_sets_.push_back(std::move(frame_set));
    if (!filmed.person) return;
    Eigen::Matrix3Xd points(3, Eigen::Index(filmed.points.size()));
    for (size_t i = 0; i < filmed.points.size(); ++i)
      points.col(Eigen::Index(i)) = filmed.points[i];
    truth_.add(frame_sets_.back().stamp_ns, points);
  }

  VirtualStudio studio_;
  CameraRig rig_;
  std::vector<FrameSet> frame_sets_;
  JointTrack truth_;
};

}  // namespace markerless_mocap
