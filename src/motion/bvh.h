#pragma once

#include <Eigen/Geometry>
#include <iosfwd>
#include <string>
#include <vector>

namespace markerless_mocap {

/// A channel of a BVH frame: a position along, or a rotation about, one axis of the parent.
struct BvhChannel {
  int axis = 0;  ///< 0 x, 1 y, 2 z
  bool rotates = false;
};

/// A joint of a BVH hierarchy, or an end site, which has no channels.
struct BvhJoint {
  std::string name;  ///< an end site is named "<joint> end"
  int parent = -1;   ///< index of an earlier joint; -1 for the root
  bool is_end = false;
  Eigen::Vector3d offset = Eigen::Vector3d::Zero();  ///< from the parent, in the file's unit
  std::vector<BvhChannel> channels;                  ///< in the order of the file
  /// Whether position channels are displacements from the offset. They normally replace it. They
  /// are displacements if they are always about zero in a joint that has an offset.
  bool positions_displace = false;
};

/// Pose of each joint in the axes and unit of the file.
struct BvhPose {
  std::vector<Eigen::Quaterniond> R_world_joint;
  std::vector<Eigen::Vector3d> positions;
};

/// A motion as stored in a Biovision Hierarchy (BVH) file.
struct BvhMotion {
  std::vector<BvhJoint> joints;  ///< parents before children
  double frame_time = 0.0;       ///< seconds
  /// Channel values of each frame in the order of the joints, in file units and degrees.
  std::vector<std::vector<double>> frames;

  BvhPose pose(size_t frame) const;
  /// The pose with all rotations zero.
  BvhPose rest() const;
};

/// Reads a BVH file. Channels may have any order, each joint may have positions, spacing is free,
/// and keywords may be in upper or lower case. Throws std::invalid_argument with a message that
/// names the file, the line, the error and the allowed values: if it is not a BVH file, ROOT is
/// missing, a channel is unknown, a joint is not closed, a frame has too few or too many values or
/// NaN, there are no frames, their number differs from the header's, or the frame time is not
/// positive.
BvhMotion readBvh(std::istream& stream, const std::string& name);

/// The same from a file. Also throws if the file cannot be read.
BvhMotion readBvh(const std::string& path);

}  // namespace markerless_mocap
