#include "tools/evaluate/evaluation_images.h"

#include <rosbag/view.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <opencv2/core.hpp>
#include <optional>
#include <utility>

#include "evaluation/body_silhouette.h"
#include "ros/camera_conversions.h"
#include "ros/hull_conversions.h"
#include "ros/image_conversions.h"
#include "tools/common/bag_io.h"

namespace markerless_mocap {
namespace {

/// Maximum difference between record time and stamp of an image that is searched for an overlay.
constexpr int64_t kRecordedEarlier_ns = 100000000, kRecordedLater_ns = 1000000000;

std::vector<std::string> topicsOf(const CameraRig& rig, const std::string& before,
                                  const std::string& name) {
  std::vector<std::string> topics;
  for (const Camera& camera : rig) topics.push_back(before + "/" + camera.name() + "/" + name);
  return topics;
}

RecordingOptions inWorld(const std::string& world_frame, const std::string& rig) {
  RecordingOptions options;
  options.rig = rig;
  if (!world_frame.empty()) options.world_frame = world_frame;
  return options;
}

/// Overlap of two masks; NaN if one is missing or if both are empty.
double overlapOf(const cv::Mat& found, const cv::Mat& real) {
  if (found.empty() || real.empty() || found.size() != real.size()) return NAN;
  if (cv::countNonZero(found) + cv::countNonZero(real) == 0) return NAN;
  return maskIou(found, real);
}

double voxelIou(const VisualHull& a, const VisualHull& b) {
  size_t both = 0, i = 0, k = 0;
  while (i < a.voxels.size() && k < b.voxels.size()) {
    both += a.voxels[i].index == b.voxels[k].index;
    const bool advance_a = a.voxels[i].index <= b.voxels[k].index;
    const bool advance_b = b.voxels[k].index <= a.voxels[i].index;
    i += advance_a, k += advance_b;
  }
  const size_t either = a.voxels.size() + b.voxels.size() - both;
  return either == 0 ? NAN : double(both) / double(either);
}

std::optional<VoxelGrid> readGrid(const std::string& path) {
  rosbag::Bag bag;
  openForReading(path, bag);
  for (const rosbag::MessageInstance& entry : rosbag::View(bag, rosbag::TopicQuery("/hull/grid")))
    if (const auto grid = messageOf<VoxelGrid>(entry)) return *grid;
  return std::nullopt;
}

HullOptions onLattice(HullOptions rules, const VoxelLattice& lattice) {
  rules.volume = "explicit";
  rules.follow = false;  // the person may be anywhere in the volume
  rules.pitch = lattice.pitch;
  rules.volume_min = lattice.origin;
  rules.volume_max = lattice.origin + lattice.pitch * lattice.size.cast<double>();
  return rules;
}

double meanOf(const std::vector<double>& values) {
  return summaryStatistics(values).mean;
}

}  // namespace

PlayerHulls readHulls(const std::string& results, const std::vector<int64_t>& stamps_ns,
                      int64_t tolerance_ns) {
  PlayerHulls hulls;
  const std::optional<VoxelGrid> grid = readGrid(results);
  if (!grid) return hulls;
  rosbag::Bag bag;
  openForReading(results, bag);
  for (const auto& entry : rosbag::View(bag, rosbag::TopicQuery("/hull/points"))) {
    const auto cloud = messageOf<sensor_msgs::PointCloud2>(entry);
    if (!cloud) continue;
    const int64_t* stamp =
        nearestStamp(stamps_ns, nanosecondsOf(cloud->header.stamp), tolerance_ns);
    const size_t frame = stamp ? size_t(stamp - stamps_ns.data()) : 0;
    if (stamp && hulls.wants(frame)) hulls.add(frame, hullFromMessage(*cloud, *grid));
  }
  return hulls;
}

ImageEvaluator::ImageEvaluator(const std::string& truth, const std::string& rig,
                               const std::string& results, const ResultRecord& record,
                               std::vector<int64_t> stamps_ns, int64_t tolerance_ns)
    : truth_(truth),
      results_(results),
      record_(record),
      stamps_ns_(std::move(stamps_ns)),
      tolerance_ns_(tolerance_ns),
      recording_(truth, inWorld(record.world_frame, rig)),
      true_masks_(truth, topicsOf(recording_.rig(), "/ground_truth", "silhouette"), stamps_ns_,
                  tolerance_ns),
      found_masks_(results, topicsOf(recording_.rig(), "", "silhouette"), stamps_ns_, tolerance_ns),
      person_masks_(results, topicsOf(recording_.rig(), "", "person"), stamps_ns_, tolerance_ns) {}

const ResultFrame* ImageEvaluator::frameAt(int64_t stamp_ns) const {
  const ResultFrame* best = nullptr;
  for (const ResultFrame& frame : record_.frames) {
    const int64_t gap = std::llabs(frame.stamp_ns - stamp_ns);
    if (gap <= tolerance_ns_ && (!best || gap < std::llabs(best->stamp_ns - stamp_ns)))
      best = &frame;
  }
  return best && !best->T_world_link.empty() ? best : nullptr;
}

std::vector<cv::Mat> ImageEvaluator::bodiesAt(int64_t stamp_ns) const {
  const ResultFrame* frame = frameAt(stamp_ns);
  if (!frame || !record_.has_description) return {};
  std::vector<bool> seen;
  for (const Eigen::Isometry3d& T_world_link : frame->T_world_link)
    seen.push_back(T_world_link.matrix().allFinite());
  std::vector<cv::Mat> bodies;
  for (const Camera& camera : recording_.rig())
    bodies.push_back(bodySilhouette(*record_.body, frame->T_world_link, camera, seen));
  return bodies;
}

std::vector<cv::Mat> ImageEvaluator::trueMasksAt(int64_t stamp_ns) const {
  std::vector<cv::Mat> masks;
  for (size_t c = 0; c < recording_.rig().size(); ++c) masks.push_back(true_masks_.at(stamp_ns, c));
  return masks;
}

ImageMetrics ImageEvaluator::measure(const HullOptions& rules,
                                     const std::function<void(double)>& progress) {
  ImageMetrics measures;
  const size_t cameras = recording_.rig().size();
  for (const Camera& camera : recording_.rig()) measures.cameras.push_back(camera.name());
  std::vector<std::vector<double>> mask(cameras), person(cameras), body(cameras);
  for (const int64_t stamp : stamps_ns_) {
    const std::vector<cv::Mat> real = trueMasksAt(stamp), bodies = bodiesAt(stamp);
    std::vector<double> mask_now, person_now, body_now;
    for (size_t c = 0; c < cameras; ++c) {
      mask_now.push_back(overlapOf(found_masks_.at(stamp, c), real[c]));
      person_now.push_back(overlapOf(person_masks_.at(stamp, c), real[c]));
      body_now.push_back(bodies.empty() ? NAN : overlapOf(bodies[c], real[c]));
      mask[c].push_back(mask_now.back());
      person[c].push_back(person_now.back());
      body[c].push_back(body_now.back());
    }
    measures.frame_sets.push_back(
        {stamp, meanOf(mask_now), meanOf(person_now), meanOf(body_now), NAN});
    progress(double(measures.frame_sets.size()) / double(stamps_ns_.size()));
  }
  for (const auto& values : mask) measures.mask_iou.push_back(summaryStatistics(values));
  for (const auto& values : person) measures.person_iou.push_back(summaryStatistics(values));
  for (const auto& values : body) measures.body_iou.push_back(summaryStatistics(values));
  measureHulls(rules, &measures);
  return measures;
}

void ImageEvaluator::measureHulls(const HullOptions& rules, ImageMetrics* measures) {
  const std::optional<VoxelGrid> grid = readGrid(results_);
  if (!grid || !hasTrueMasks()) return;
  HullCarver carver(recording_.rig(), onLattice(rules, latticeFromMessage(*grid)));
  rosbag::Bag bag;
  openForReading(results_, bag);
  std::vector<double> overlaps;
  for (const auto& entry : rosbag::View(bag, rosbag::TopicQuery("/hull/points"))) {
    const auto cloud = messageOf<sensor_msgs::PointCloud2>(entry);
    if (!cloud) continue;
    const int64_t* stamp =
        nearestStamp(stamps_ns_, nanosecondsOf(cloud->header.stamp), tolerance_ns_);
    if (!stamp) continue;
    std::vector<HullView> views;
    for (const cv::Mat& mask : trueMasksAt(*stamp)) views.push_back({mask, cv::Mat()});
    const VisualHull real = carver.carve(views), found = hullFromMessage(*cloud, *grid);
    overlaps.push_back(voxelIou(found, real));
    for (FrameSetOverlap& frame_set : measures->frame_sets)
      if (frame_set.stamp_ns == *stamp) frame_set.hull = overlaps.back();
  }
  measures->hull_iou = summaryStatistics(overlaps);
}

void ImageEvaluator::show(const std::vector<int64_t>& frame_stamps_ns, ShownImages* shown) const {
  shown->rig = recording_.rig();
  rosbag::Bag bag;
  openForReading(truth_, bag);
  for (const int64_t stamp : stamps_ns_) {
    const auto frame = std::lower_bound(frame_stamps_ns.begin(), frame_stamps_ns.end(), stamp);
    shown->views.add(size_t(frame - frame_stamps_ns.begin()), recording_.rig(),
                     framesAt(bag, stamp), trueMasksAt(stamp), bodiesAt(stamp));
  }
}

std::vector<CameraFrame> ImageEvaluator::framesAt(const rosbag::Bag& bag, int64_t stamp_ns) const {
  std::vector<std::string> topics;
  for (const RecordedCamera& camera : recording_.cameras()) topics.push_back(camera.image_topic);
  std::vector<CameraFrame> frames(topics.size());
  rosbag::View near(bag, rosbag::TopicQuery(topics), rosTime(stamp_ns - kRecordedEarlier_ns),
                    rosTime(stamp_ns + kRecordedLater_ns));
  for (const rosbag::MessageInstance& entry : near) {
    const auto camera = std::find(topics.begin(), topics.end(), entry.getTopic()) - topics.begin();
    const auto raw = messageOf<sensor_msgs::Image>(entry);
    const auto packed = messageOf<sensor_msgs::CompressedImage>(entry);
    if (!raw && !packed) continue;
    const int64_t stamp = nanosecondsOf(raw ? raw->header.stamp : packed->header.stamp);
    if (std::llabs(stamp - stamp_ns) <= tolerance_ns_)
      frames[camera].image = raw ? matFromMessage(*raw) : matFromMessage(*packed);
  }
  return frames;
}

}  // namespace markerless_mocap
