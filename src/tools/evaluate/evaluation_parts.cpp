#include "tools/evaluate/evaluation_parts.h"

#include <rosbag/view.h>

#include <stdexcept>

#include "ros/camera_conversions.h"
#include "ros/hull_conversions.h"
#include "ros/point_cloud_reader.h"
#include "ros/segmentation_conversions.h"
#include "tools/common/bag_io.h"

namespace markerless_mocap {
namespace {

constexpr const char *kPoints = "/segmentation/points", *kParts = "/segmentation/parts",
                     *kGrid = "/hull/grid";

static_assert(kTruePartCount == kPartCount);

Eigen::Matrix3Xd pointsOf(const sensor_msgs::PointCloud2& cloud) {
  const PointCloudReader reader(cloud, "labelled cloud");
  const PointReader read(reader);
  Eigen::Matrix3Xd points(3, Eigen::Index(reader.size()));
  for (Eigen::Index i = 0; i < points.cols(); ++i) points.col(i) = read(size_t(i));
  return points;
}

Eigen::Matrix3Xd curveOf(const PartCurve& part) {
  Eigen::Matrix3Xd points(3, Eigen::Index(part.points.size()));
  for (Eigen::Index i = 0; i < points.cols(); ++i) points.col(i) = part.points[size_t(i)];
  return points;
}

/// Messages of one stamp.
struct Messages {
  SegmentedHull hull;
  std::string status, reason;
  bool has_points = false, has_parts = false;
};

void addPoints(const sensor_msgs::PointCloud2& cloud, Messages* said) {
  said->hull.labels = labelsFromMessage(cloud);
  said->hull.voxels = pointsOf(cloud);
  said->has_points = true;
}

void addParts(const BodyPartsMsg& message, Messages* said) {
  const BodyParts parts = partsFromMessage(message);
  said->hull.valid = parts.status == SegmentationStatus::kOk;
  for (size_t i = 0; i < kPartCount; ++i) said->hull.curves[i] = curveOf(parts.parts[i]);
  said->status = toString(parts.status);
  said->reason = parts.reason;
  said->has_parts = true;
}

}  // namespace

PartsRecord readParts(const std::string& path) {
  rosbag::Bag bag;
  openForReading(path, bag);
  PartsRecord record;
  std::map<int64_t, Messages> all;
  double pitch = 0.0;
  const std::vector<std::string> topics{kPoints, kParts, kGrid};
  for (const rosbag::MessageInstance& entry : rosbag::View(bag, rosbag::TopicQuery(topics))) {
    if (const auto grid = messageOf<VoxelGrid>(entry)) pitch = grid->pitch;
    if (const auto cloud = messageOf<sensor_msgs::PointCloud2>(entry)) {
      addPoints(*cloud, &all[nanosecondsOf(cloud->header.stamp)]);
      record.world_frame = cloud->header.frame_id;
    }
    if (const auto parts = messageOf<BodyPartsMsg>(entry))
      addParts(*parts, &all[nanosecondsOf(parts->header.stamp)]);
  }
  for (auto& [stamp, said] : all) {
    if (!said.has_points || !said.has_parts || pitch <= 0.0) continue;
    said.hull.pitch = pitch;
    record.stamps_ns.push_back(stamp);
    record.hulls.push_back(std::move(said.hull));
    record.statuses.push_back(said.status);
    record.reasons.push_back(said.reason);
  }
  return record;
}

PartsEvaluation evaluateParts(const JointTrack& truth, const std::string& world_frame,
                              const PartsRecord& parts, int64_t tolerance_ns) {
  if (parts.world_frame != world_frame)
    throw std::runtime_error("the segmented hulls are in the frame " + parts.world_frame +
                             ", the ground truth in " + world_frame + ": they cannot be compared");
  PartsEvaluation out;
  std::vector<SegmentedHull> hulls;
  for (const int index : matchStamps(truth.stamps_ns, parts.stamps_ns, tolerance_ns)) {
    const bool said = index >= 0;
    hulls.push_back(said ? parts.hulls[size_t(index)] : SegmentedHull());
    out.reasons.push_back(said ? parts.reasons[size_t(index)] : "");
    ++out.status_counts[said ? parts.statuses[size_t(index)] : "missing"];
  }
  out.errors = partErrors(truth.select(partTruthNames()), hulls);
  return out;
}

}  // namespace markerless_mocap
