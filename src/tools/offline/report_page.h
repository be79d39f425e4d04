#pragma once

#include <array>
#include <cstdint>
#include <opencv2/core/mat.hpp>
#include <string>
#include <vector>

#include "markerless_mocap/products/body_pose.h"

namespace markerless_mocap {

/// One frame in the report; numbers are NaN if unknown.
struct ReportRow {
  int64_t stamp_ns = 0;
  PoseStatus status = PoseStatus::kLost;
  std::string reason;
  double mean_iou = 0.0;  ///< over the views
  double skeleton_error_m = 0.0;
  std::array<bool, kPartCount> part_seen{};       ///< by PartLabel
  std::array<double, kPartCount> part_sigma_m{};  ///< as BodyPose::part_sigma_m
};

/// One instant; the mats are CV_8UC3.
struct ReportPicture {
  std::string caption;
  cv::Mat image;               ///< all views, cropped to the body
  std::vector<cv::Mat> views;  ///< the whole view of each camera with its evidence
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
  std::vector<ReportRow> rows;
  std::vector<ReportCamera> cameras;
  std::vector<ReportPicture> pictures;
};

/// A self-contained HTML page: status band, overlap and error over time as SVG, mean overlap per
/// camera, which parts were not seen and why, images as JPEG, and a section for each camera.
std::string reportPage(const ReportContent& content);

}  // namespace markerless_mocap
