#pragma once

#include <optional>
#include <string>
#include <vector>

#include "markerless_mocap/pipeline/pipeline.h"
#include "markerless_mocap/tracking/pose_filter.h"
#include "tools/common/recording.h"
#include "tools/offline/report_page.h"

namespace markerless_mocap {

/// Throws std::runtime_error if the folder of a report cannot be made or written to.
void makeReportFolder(const std::string& folder);

/// Compares the fitted bodies with the masks, and collects what the page of a run shows.
class RunReport {
 public:
  /// Creates the folder. Throws std::runtime_error if this fails.
  /// \param filter of the motion in the page; empty: as the tracker gives it
  /// \param images false: no picture of a camera
  /// \param max_frames of the page; of a longer run it shows every second frame set, or every
  ///   fourth, ..., so that memory and page have a limit
  RunReport(std::string folder, const BodyModel& model, const CameraRig& rig,
            std::optional<PoseFilter> filter = std::nullopt, bool images = true,
            size_t max_frames = kMaxFrames);

  /// \return intersection over union of each view with a mask; empty if the pose is lost
  std::vector<double> add(const FrameSet& frame_set, const PipelineResult& result);
  /// The backgrounds to show, one per camera; nullptr: none.
  /// \param from_recording those that were learned from the whole recording, or no elements
  /// \param in_use those in use after the last frame set
  void addBackgrounds(const std::vector<SharedBackground>& from_recording,
                      const std::vector<SharedBackground>& in_use);
  /// Writes report.html and the overlays as PNG. Throws std::runtime_error if this fails.
  /// \param remarks lines at the top of the page
  void write(const std::string& title, const std::vector<std::string>& remarks = {});

 private:
  ResultFrame frameOf(const FrameSet& frame_set, const BodyPose& raw);
  void halveFrames();
  std::vector<cv::Mat> bodyMasks(const BodyPose& pose) const;
  /// Of each view; NaN: there is nothing to compare.
  std::vector<double> overlapsOf(const FrameSet& frame_set, const PipelineResult& result,
                                 const std::vector<cv::Mat>& bodies);
  void keepPictures(size_t row, const FrameSet& frame_set, const PipelineResult& result,
                    const std::vector<cv::Mat>& bodies);

  static constexpr size_t kMaxOverlays = 8;
  static constexpr size_t kMaxFrames = 9000;  // five minutes at 30 Hz; some 26 kB each

  std::string folder_;
  const BodyModel& model_;
  const CameraRig& rig_;
  std::optional<PoseFilter> filter_;
  bool images_;
  size_t max_frames_;
  size_t frame_sets_ = 0;  ///< that have come
  size_t step_ = 1;        ///< one in so many is shown
  ReportContent content_;
  PlayerHulls hulls_;
  PlayerViews views_;
  EveryNth<cv::Mat> overlays_{kMaxOverlays};
  std::vector<char> has_recorded_masks_;  ///< by camera
};

}  // namespace markerless_mocap
