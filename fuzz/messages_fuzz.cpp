// Messages whose fields are whatever the input says, as another program may send them.
#include "byte_source.h"
#include "fuzz_target.h"
#include "ros/camera_conversions.h"
#include "ros/hull_conversions.h"
#include "ros/image_conversions.h"
#include "ros/mask_png.h"
#include "ros/pose_tree_conversions.h"
#include "ros/segmentation_conversions.h"

using namespace markerless_mocap;

namespace {

geometry_msgs::Point point(ByteSource& in) {
  geometry_msgs::Point p;
  for (double* value : {&p.x, &p.y, &p.z}) *value = in.number<float>();
  return p;
}

std::vector<geometry_msgs::Point> points(ByteSource& in) {
  std::vector<geometry_msgs::Point> all(in.length(8));
  for (auto& p : all) p = point(in);
  return all;
}

VoxelGrid grid(ByteSource& in) {
  VoxelGrid grid;
  grid.header.frame_id = "world";
  grid.origin = point(in);
  grid.pitch = in.number<float>();
  for (auto& size : grid.size) size = in.number<uint32_t>();
  return grid;
}

sensor_msgs::PointCloud2 cloud(ByteSource& in) {
  sensor_msgs::PointCloud2 cloud;
  cloud.header.frame_id = "world";
  cloud.width = in.number<uint32_t>();
  cloud.height = in.number<uint32_t>();
  cloud.point_step = in.number<uint32_t>();
  cloud.row_step = in.number<uint32_t>();
  cloud.is_bigendian = in.number<uint8_t>() == 1;
  cloud.fields.resize(in.length(14));
  for (auto& field : cloud.fields) {
    field.name = in.text();
    field.offset = in.number<uint32_t>();
    field.datatype = in.number<uint8_t>();
    field.count = in.number<uint8_t>();
  }
  cloud.data = in.rest();
  return cloud;
}

void readHull(ByteSource& in) {
  const VoxelGrid lattice = grid(in);
  refusesOrReads([&] { latticeFromMessage(lattice); });
  const sensor_msgs::PointCloud2 hull = cloud(in);
  refusesOrReads([&] { hullFromMessage(hull, lattice); });
  refusesOrReads([&] { labelsFromMessage(hull); });
}

void readParts(ByteSource& in) {
  BodyPartsMsg message;
  message.status = in.number<uint8_t>();
  message.parts.resize(in.length(8));
  for (auto& part : message.parts) {
    part.label = in.number<uint8_t>();
    part.seen = in.number<uint8_t>() & 1;
    part.voxel_count = in.number<uint32_t>();
    part.points = points(in);
    part.site_values.resize(in.length(8));
    for (double& value : part.site_values) value = in.number<float>();
  }
  refusesOrReads([&] { partsFromMessage(message); });
}

void readTree(ByteSource& in) {
  PoseTreeMsg message;
  message.status = in.number<uint8_t>();
  message.rank = in.number<float>();
  message.validity = in.number<float>();
  message.nodes = points(in);
  message.parents.resize(in.length(8));
  for (int32_t& parent : message.parents) parent = in.number<int32_t>();
  message.parts.resize(in.length(8));
  for (uint8_t& part : message.parts) part = in.number<uint8_t>();
  message.origin = in.number<int32_t>();
  message.tip_names.resize(in.length(6));
  for (std::string& name : message.tip_names) name = in.text();
  message.tip_nodes.resize(in.length(6));
  for (int32_t& node : message.tip_nodes) node = in.number<int32_t>();
  message.tip_skeleton_ends = points(in);
  message.tip_positions = points(in);
  message.joint_names.resize(in.length(14));
  for (std::string& name : message.joint_names) name = in.text();
  message.joint_positions = points(in);
  for (auto* v : {&message.forward, &message.left})
    for (double* value : {&v->x, &v->y, &v->z}) *value = in.number<float>();
  refusesOrReads([&] { poseTreeFromMessage(message); });
}

void readImage(ByteSource& in) {
  sensor_msgs::Image message;
  message.width = in.number<uint32_t>();
  message.height = in.number<uint32_t>();
  message.step = in.number<uint32_t>();
  message.encoding = in.text();
  message.is_bigendian = in.number<uint8_t>();
  message.data = in.rest();
  refusesOrReads([&] { matFromMessage(message); });
  refusesOrReads([&] { maskFromMessage(message); });
  hasUnknownBackground(message);
}

void readCompressedImage(ByteSource& in) {
  sensor_msgs::CompressedImage message;
  message.format = in.text();
  message.data = in.rest();
  refusesOrReads([&] { matFromMessage(message); });
  refusesOrReads([&] { maskFromCompressed(message); });
}

void readCameraInfo(ByteSource& in) {
  sensor_msgs::CameraInfo info;
  info.width = in.number<uint32_t>();
  info.height = in.number<uint32_t>();
  info.distortion_model = in.text();
  info.D.resize(in.length(10));
  for (double& value : info.D) value = in.number<float>();
  for (double& value : info.K) value = in.number<float>();
  info.binning_x = in.number<uint8_t>();
  info.roi.width = in.number<uint32_t>();
  geometry_msgs::Transform pose;
  for (double* value : {&pose.translation.x, &pose.translation.y, &pose.translation.z,
                        &pose.rotation.x, &pose.rotation.y, &pose.rotation.z, &pose.rotation.w})
    *value = in.number<float>();
  refusesOrReads([&] {
    const Camera camera(calibrationFromMessage("fuzz", info, pose));
    camera.project(Eigen::Vector3d(0.3, -0.2, 1.1));
  });
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  ByteSource in(data, size);
  constexpr void (*kReaders[])(ByteSource&) = {readHull,  readParts,           readTree,
                                               readImage, readCompressedImage, readCameraInfo};
  kReaders[in.number<uint8_t>() % std::size(kReaders)](in);
  return 0;
}
