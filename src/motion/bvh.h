#pragma once

#include <Eigen/Geometry>
#include <iosfwd>
#include <string>
#include <vector>

namespace markerless_mocap {

/// A number of a BVH frame: a place along, or a turn about, one axis of the parent.
struct BvhChannel {
  int axis = 0;  ///< 0 x, 1 y, 2 z
  bool rotates = false;
};

/// A joint of a BVH hierarchy, or an end site, which has no channels.
struct BvhJoint {
  std::string name;  ///< an end site is named after its joint: "<joint> end"
  int parent = -1;   ///< index of a joint before this one; -1 for the root
  bool is_end = false;
  Eigen::Vector3d offset = Eigen::Vector3d::Zero();  ///< from the parent, in the file's unit
  std::vector<BvhChannel> channels;                  ///< in the order of the file
  /// Position channels replace the offset; if they are about zero all the time in a joint that has
  /// an offset, they are taken as displacements from it.
  bool positions_displace = false;
};

/// Where each joint is in the file's own axes and unit.
struct BvhPose {
  std::vector<Eigen::Quaterniond> R_world_joint;
  std::vector<Eigen::Vector3d> positions;
};

/// A motion as Biovision Hierarchy files store it.
struct BvhMotion {
  std::vector<BvhJoint> joints;  ///< parents before children
  double frame_time = 0.0;       ///< seconds
  /// Channel values of each frame in the order of the joints: file units and degrees.
  std::vector<std::vector<double>> frames;

  BvhPose pose(size_t frame) const;
  /// All rotations zero.
  BvhPose rest() const;
};

/// Reads any order of channels, positions in any joint, any spacing, upper or lower case keywords.
/// Throws std::invalid_argument that names file, line, fault and what is allowed: not a BVH, a
/// missing ROOT, an unknown channel, an unclosed joint, values missing or too many in a frame, NaN,
/// no frames, more or fewer frames than told, a frame time that is not positive.
BvhMotion readBvh(std::istream& stream, const std::string& name);

/// The same from a file; throws too if the file cannot be read.
BvhMotion readBvh(const std::string& path);

}  // namespace markerless_mocap
