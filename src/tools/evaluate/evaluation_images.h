#pragma once

#include <functional>
#include <map>
#include <opencv2/core/mat.hpp>
#include <string>
#include <vector>

#include "evaluation/joint_error.h"
#include "markerless_mocap/hull/hull_carver.h"
#include "pages/player_hulls.h"
#include "tools/common/player_views.h"
#include "tools/common/recording.h"
#include "tools/common/result_record.h"
#include "tools/evaluate/mask_store.h"

namespace markerless_mocap {

/// Overlaps of one frame set; NaN if there is nothing to compare.
struct FrameSetOverlap {
  int64_t stamp_ns = 0;
  double mask = NAN;    ///< silhouettes and exact masks, mean over the cameras
  double person = NAN;  ///< masks of the person and exact masks, mean over the cameras
  double body = NAN;    ///< fitted body and exact masks, mean over the cameras
  double hull = NAN;    ///< hull and the hull carved from the exact masks
};

/// Intersection over union with the exact masks, 0 to 1.
struct ImageMetrics {
  std::vector<std::string> cameras;
  std::vector<SummaryStatistics> mask_iou, person_iou, body_iou;  ///< per camera
  SummaryStatistics hull_iou{0, NAN, NAN, NAN, NAN, NAN};
  std::vector<FrameSetOverlap> frame_sets;
};

/// What a page shows of a recording.
struct ShownImages {
  CameraRig rig;
  PlayerViews views;
  PlayerHulls hulls;
};

/// The hulls of a result. \param stamps_ns of the frames, ascending
/// \param tolerance_ns maximum difference of a stamp
PlayerHulls readHulls(const std::string& results, const std::vector<int64_t>& stamps_ns,
                      int64_t tolerance_ns);

/// Compares silhouettes, masks of the person, body and hull of a result with the exact masks at
/// given stamps.
class ImageEvaluator {
 public:
  /// Reads the masks of both bags. Throws as Recording if the ground truth has no cameras.
  /// \param rig rig file of the cameras; empty: those of the ground truth
  /// \param stamps_ns of the frame sets, ascending
  /// \param tolerance_ns maximum difference of a stamp
  ImageEvaluator(const std::string& truth, const std::string& rig, const std::string& results,
                 const ResultRecord& record, std::vector<int64_t> stamps_ns, int64_t tolerance_ns);

  bool hasTrueMasks() const { return !true_masks_.empty(); }
  /// \param rules options of the hull stage; the lattice is that of the results
  ImageMetrics measure(const HullOptions& rules, const std::function<void(double)>& progress);
  /// Adds the rig and the views with the fitted body and the exact masks.
  /// \param frame_stamps_ns of all frames of the page, ascending
  void show(const std::vector<int64_t>& frame_stamps_ns, ShownImages* shown) const;

 private:
  const ResultFrame* frameAt(int64_t stamp_ns) const;
  std::vector<cv::Mat> bodiesAt(int64_t stamp_ns) const;
  std::vector<CameraFrame> framesAt(const rosbag::Bag& bag, int64_t stamp_ns) const;
  std::vector<cv::Mat> trueMasksAt(int64_t stamp_ns) const;
  void measureHulls(const HullOptions& rules, ImageMetrics* measures);

  std::string truth_, results_;
  const ResultRecord& record_;
  std::vector<int64_t> stamps_ns_;
  int64_t tolerance_ns_;
  Recording recording_;
  MaskStore true_masks_, found_masks_, person_masks_;
};

}  // namespace markerless_mocap
