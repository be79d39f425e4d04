#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <vector>

#include "markerless_mocap/camera/camera.h"

namespace markerless_mocap {

/// A round lamp under the ceiling.
struct Lamp {
  Eigen::Vector3f position;  ///< world, metres
  float fraction;            ///< of the light of all lamps; the fractions sum to 1
  float radius;              ///< metres; wide lamps cast soft shadows
};

/// A point on the room's inner surface.
struct RoomPoint {
  Eigen::Vector3f position;  ///< world, metres
  Eigen::Vector3f color;     ///< red, green, blue, 0 to 1; lit, without shadows
};

class RoomTexture;

/// The empty room: a box around the z axis with the floor at z = 0. Floor, walls and ceiling have
/// patterns of several sizes (boards, panels, pictures, doors, windows, skirting, stains, grain)
/// that depend on a seed. Immutable.
class TexturedRoom {
 public:
  /// \param seed seed of colours and patterns
  /// \param half_x, half_y, height metres. Throws std::invalid_argument unless the half sizes are 1
  ///   to 50 and the height 2 to 20.
  TexturedRoom(uint64_t seed, double half_x, double half_y, double height);
  /// A room that contains all cameras of the rig with some space behind them, at least 10 x 10 x
  /// 3.2 m. Throws std::invalid_argument if a camera is below the floor or further out than 45 m.
  static TexturedRoom around(uint64_t seed, const CameraRig& rig);

  /// The point of the room that a ray from `eye`, a point inside the room, hits.
  /// \param direction of any length
  RoomPoint at(const Eigen::Vector3d& eye, const Eigen::Vector3d& direction) const;
  const std::vector<Lamp>& lamps() const { return lamps_; }
  /// Half extents in x and y and the full height, metres.
  const Eigen::Vector3f& halfSize() const { return half_size_; }
  /// The walls' main colour under their light, red green blue, 0 to 1.
  Eigen::Vector3f wallColor() const;

 private:
  Eigen::Vector3f half_size_;
  std::shared_ptr<const RoomTexture> texture_;
  std::vector<Lamp> lamps_;
};

}  // namespace markerless_mocap
