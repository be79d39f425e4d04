#pragma once

#include <functional>
#include <map>
#include <opencv2/core/mat.hpp>
#include <string>
#include <vector>

#include "evaluation/joint_error.h"
#include "markerless_mocap/hull/hull_carver.h"
#include "tools/common/recording.h"
#include "tools/evaluate/evaluation_results.h"
#include "tools/evaluate/mask_store.h"

namespace markerless_mocap {

/// Overlaps of one instant; NaN where there is nothing to compare.
struct FrameSetOverlap {
  int64_t stamp_ns = 0;
  double mask = NAN;  ///< silhouettes and true masks, mean of the cameras
  double body = NAN;  ///< fitted body and true masks, mean of the cameras
  double hull = NAN;  ///< hull and the one carved from the true masks
};

/// Intersection over union with the exact masks, 0..1.
struct ImageMetrics {
  std::vector<std::string> cameras;
  std::vector<SummaryStatistics> mask_iou, body_iou;  ///< per camera
  SummaryStatistics hull_iou{0, NAN, NAN, NAN, NAN, NAN};
  std::vector<FrameSetOverlap> frame_sets;
};

struct EvaluatedPicture {
  std::string caption;
  cv::Mat image;  ///< CV_8UC3
};

/// Holds silhouettes, body and hull of a result against the exact masks of chosen instants.
class ImageEvaluator {
 public:
  /// Reads the masks of both bags at the instants. Throws as Recording when the truth has no
  /// cameras.
  /// \param rig file that calibrates the cameras; empty: the truth's bag does
  /// \param stamps_ns instants, ascending \param tolerance_ns how far another stamp may lie
  ImageEvaluator(const std::string& truth, const std::string& rig, const std::string& results,
                 const ResultRecord& record, std::vector<int64_t> stamps_ns, int64_t tolerance_ns);

  bool hasTrueMasks() const { return !true_masks_.empty(); }
  /// \param rules of the hull stage; its lattice is taken from the results
  ImageMetrics measure(const HullOptions& rules, const std::function<void(double)>& progress);
  /// The body over the images of one of the instants; an empty mat if there is nothing to show.
  cv::Mat picture(int64_t stamp_ns);

 private:
  const ResultFrame* frameAt(int64_t stamp_ns) const;
  std::vector<cv::Mat> bodiesAt(int64_t stamp_ns) const;
  std::vector<CameraFrame> framesAt(int64_t stamp_ns) const;
  std::vector<cv::Mat> trueMasksAt(int64_t stamp_ns) const;
  void measureHulls(const HullOptions& rules, ImageMetrics* measures);

  std::string truth_, results_;
  const ResultRecord& record_;
  std::vector<int64_t> stamps_ns_;
  int64_t tolerance_ns_;
  Recording recording_;
  MaskStore true_masks_, found_masks_;
};

}  // namespace markerless_mocap
