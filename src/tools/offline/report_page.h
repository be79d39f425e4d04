#pragma once

#include <array>
#include <opencv2/core/mat.hpp>
#include <string>
#include <vector>

#include "markerless_mocap/products/body_pose.h"
#include "tools/common/player.h"

namespace markerless_mocap {

/// One frame in the report; numbers are NaN if unknown.
struct ReportRow {
  double mean_iou = 0.0;  ///< over the views
  double skeleton_error_m = 0.0;
  std::array<bool, kPartCount> part_seen{};  ///< by PartLabel
};

/// One camera; numbers are NaN if unknown.
struct ReportCamera {
  std::string name;
  std::string background_source;       ///< what it was learned from, or why there is none
  cv::Mat background;                  ///< CV_8UC3, unknown pixels tinted; empty: none
  double background_unknown = 0.0;     ///< fraction of its pixels
  std::vector<double> unknown_of_row;  ///< fraction of the mask's pixels, by row
  std::vector<double> iou_of_row;      ///< overlap of body and mask, by row
};

/// Content of the report.
struct ReportContent {
  std::string title;
  std::vector<std::string> remarks;  ///< lines at the top of the page
  std::vector<ResultFrame> frames;   ///< with their status and reason
  std::vector<ReportRow> rows;       ///< one per frame
  std::vector<ReportCamera> cameras;
};

/// The page of a run: the player; overlap and error over time; joint angles, speeds, feet on the
/// floor and expected errors; which parts were not seen and why; a section for each camera.
/// \param player of the frames
Page reportPage(const ReportContent& content, Json player, const BodyModel& body);

/// What each camera contributed: its background, the share of its masks that is unknown and their
/// overlap with the body over time.
void addCameras(const ReportContent& content, Page* page);

/// When and why parts of the body were not seen: a band over time for each part, a table of frames
/// and expected errors, and the reasons that were given, counted.
void addParts(const ReportContent& content, Page* page);

}  // namespace markerless_mocap
