#include "ros/segmentation_conversions.h"

#include <sensor_msgs/point_cloud2_iterator.h>
#include <tf2_eigen/tf2_eigen.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "ros/aligned_points.h"
#include "ros/message_limits.h"
#include "ros/point_cloud_reader.h"

namespace markerless_mocap {
namespace {

constexpr double kCurveWidth = 0.03;  // width of the line, metres
constexpr double kDimmed = 0.35;      // brightness of a part that is carried over
constexpr size_t kMaxCurvePoints = 10000;
constexpr double kSiteSlack = 1e-6;  // for rounding

uint8_t statusToMessage(SegmentationStatus status) {
  switch (status) {
    case SegmentationStatus::kOk:
      return BodyPartsMsg::OK;
    case SegmentationStatus::kPartial:
      return BodyPartsMsg::PARTIAL;
    case SegmentationStatus::kInvalid:
      return BodyPartsMsg::INVALID;
  }
  throw std::invalid_argument("unknown segmentation status");
}

SegmentationStatus statusFromMessage(uint8_t status) {
  switch (status) {
    case BodyPartsMsg::OK:
      return SegmentationStatus::kOk;
    case BodyPartsMsg::PARTIAL:
      return SegmentationStatus::kPartial;
    case BodyPartsMsg::INVALID:
      return SegmentationStatus::kInvalid;
    default:
      throw std::invalid_argument("BodyParts has the status " + std::to_string(status) +
                                  ", allowed are 0 to 2");
  }
}

bool isUsable(const PartCurve& curve) {
  const bool sizes = curve.points.size() >= 2 && curve.points.size() <= kMaxCurvePoints &&
                     curve.points.size() == curve.site_values.size();
  const auto is_site = [](double s) { return s >= -kSiteSlack && s <= 1.0 + kSiteSlack; };
  return sizes && std::all_of(curve.points.begin(), curve.points.end(), isPlace) &&
         std::all_of(curve.site_values.begin(), curve.site_values.end(), is_site);
}

PartCurve curveFromMessage(const BodyPart& message) {
  PartCurve curve;
  curve.seen = message.seen;
  curve.carried = message.carried;
  if (!curve.seen) return curve;
  curve.whole = message.whole;
  curve.voxel_count = message.voxel_count;
  curve.site_values = message.site_values;
  for (const auto& p : message.points) curve.points.emplace_back(p.x, p.y, p.z);
  if (!isUsable(curve))
    throw std::invalid_argument("BodyParts has an unusable curve of the part " +
                                std::to_string(message.label) + ", allowed are 2 to " +
                                std::to_string(kMaxCurvePoints) +
                                " points within 10 km with one site value of 0 to 1 each");
  return curve;
}

}  // namespace

std::array<uint8_t, 3> partColor(PartLabel label) {
  // Colours of Okabe and Ito, distinguishable with any colour vision.
  constexpr std::array<std::array<uint8_t, 3>, kPartCount> kColors{{{153, 153, 153},
                                                                    {240, 228, 66},
                                                                    {230, 159, 0},
                                                                    {86, 180, 233},
                                                                    {0, 158, 115},
                                                                    {204, 121, 167}}};
  return kColors.at(static_cast<size_t>(label));
}

namespace {

/// Colour of each part, darker if its labels are carried over from earlier frames.
std::array<std::array<uint8_t, 3>, kPartCount> colorsOf(const BodyParts& parts) {
  std::array<std::array<uint8_t, 3>, kPartCount> colors;
  for (size_t label = 0; label < kPartCount; ++label) {
    colors[label] = partColor(static_cast<PartLabel>(label));
    if (!parts.parts[label].carried) continue;
    for (uint8_t& channel : colors[label]) channel = uint8_t(std::lround(kDimmed * channel));
  }
  return colors;
}

}  // namespace

BodyPartsMsg messageFromParts(const BodyParts& parts, const std_msgs::Header& header) {
  BodyPartsMsg message;
  message.header = header;
  message.status = statusToMessage(parts.status);
  message.reason = parts.reason;
  for (int label = 0; label < kPartCount; ++label) {
    const PartCurve& curve = parts.parts[label];
    BodyPart part;
    part.label = static_cast<uint8_t>(label);
    part.seen = curve.seen;
    part.carried = curve.carried;
    if (curve.seen) {
      part.whole = curve.whole;
      part.voxel_count = curve.voxel_count;
      for (const Eigen::Vector3d& p : curve.points) part.points.push_back(tf2::toMsg(p));
      part.site_values = curve.site_values;
    }
    message.parts.push_back(part);
  }
  return message;
}

BodyParts partsFromMessage(const BodyPartsMsg& message) {
  BodyParts parts;
  parts.status = statusFromMessage(message.status);
  parts.reason = message.reason;
  std::array<bool, kPartCount> known{};
  for (const BodyPart& part : message.parts) {
    if (part.label >= kPartCount)
      throw std::invalid_argument("BodyParts has the label " + std::to_string(part.label) +
                                  ", allowed are 0 to 5");
    if (known[part.label])
      throw std::invalid_argument("BodyParts has the label " + std::to_string(part.label) +
                                  " twice");
    known[part.label] = true;
    parts.parts[part.label] = curveFromMessage(part);
  }
  return parts;
}

sensor_msgs::PointCloud2 labelledCloud(const VisualHull& hull, const BodyParts& parts,
                                       const std_msgs::Header& header) {
  if (!parts.labels.empty() && parts.labels.size() != hull.voxels.size())
    throw std::invalid_argument("the hull has " + std::to_string(hull.voxels.size()) +
                                " voxels but there are " + std::to_string(parts.labels.size()) +
                                " labels");
  sensor_msgs::PointCloud2 cloud;
  cloud.header = header;
  cloud.height = 1;
  cloud.is_dense = true;
  const auto colors = colorsOf(parts);
  sensor_msgs::PointCloud2Modifier modifier(cloud);
  const auto f32 = sensor_msgs::PointField::FLOAT32;
  modifier.setPointCloud2Fields(5, "x", 1, f32, "y", 1, f32, "z", 1, f32, "rgb", 1, f32, "label", 1,
                                sensor_msgs::PointField::UINT8);
  alignPoints(&cloud);
  modifier.resize(parts.labels.size());
  sensor_msgs::PointCloud2Iterator<float> xyz(cloud, "x");
  sensor_msgs::PointCloud2Iterator<uint8_t> r(cloud, "r"), g(cloud, "g"), b(cloud, "b");
  sensor_msgs::PointCloud2Iterator<uint8_t> label(cloud, "label");
  for (size_t i = 0; i < parts.labels.size(); ++i) {
    const Eigen::Vector3f center = hull.lattice.center(hull.voxels[i].index).cast<float>();
    std::copy_n(center.data(), 3, &xyz[0]);
    const auto& color = colors.at(parts.labels[i]);
    *r = color[0], *g = color[1], *b = color[2];
    *label = parts.labels[i];
    ++xyz, ++r, ++g, ++b, ++label;
  }
  return cloud;
}

std::vector<uint8_t> labelsFromMessage(const sensor_msgs::PointCloud2& cloud) {
  const PointCloudReader points(cloud, "labelled cloud");
  const size_t offset = points.offset("label", sensor_msgs::PointField::UINT8);
  std::vector<uint8_t> labels(points.size());
  for (size_t i = 0; i < labels.size(); ++i) {
    labels[i] = points.byte(i, offset);
    if (labels[i] >= kPartCount)
      throw std::invalid_argument("labelled cloud has the label " + std::to_string(labels[i]) +
                                  ", allowed are 0 to 5");
  }
  return labels;
}

visualization_msgs::MarkerArray curveMarkers(const BodyParts& parts,
                                             const std_msgs::Header& header) {
  visualization_msgs::MarkerArray markers;
  for (int label = 0; label < kPartCount; ++label) {
    const PartCurve& curve = parts.parts[label];
    visualization_msgs::Marker marker;
    marker.header = header;
    marker.ns = "part_curves";
    marker.id = label;
    marker.type = marker.LINE_STRIP;
    marker.action = curve.seen && curve.points.size() > 1 ? marker.ADD : marker.DELETE;
    marker.pose.orientation.w = 1.0;
    marker.scale.x = kCurveWidth;
    const auto color = partColor(static_cast<PartLabel>(label));
    marker.color.r = color[0] / 255.0f;
    marker.color.g = color[1] / 255.0f;
    marker.color.b = color[2] / 255.0f;
    marker.color.a = 1.0f;
    if (marker.action == marker.ADD)
      for (const Eigen::Vector3d& p : curve.points) marker.points.push_back(tf2::toMsg(p));
    markers.markers.push_back(marker);
  }
  return markers;
}

}  // namespace markerless_mocap
