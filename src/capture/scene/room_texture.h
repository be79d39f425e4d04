#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace markerless_mocap {

/// What covers the walls, floor and ceiling of a room: colour by place.
class RoomTexture {
 public:
  RoomTexture(uint64_t seed, const Eigen::Vector3f& half_size);

  /// Red green blue, 0 to 1, under the room's light. \param axis that the surface is normal to
  /// \param upper whether it is the one of greater coordinate
  /// \param blur metres; what is finer is spread over this width
  Eigen::Vector3f color(const Eigen::Vector3f& point, int axis, bool upper, float blur) const;
  Eigen::Vector3f wallColor() const;

 private:
  /// A rectangle on a wall: picture, door, window, notice.
  struct Panel {
    float along_low, along_high, low, high;  ///< metres along the wall and up
    Eigen::Vector3f color, second;
    float stripe;  ///< metres; 0 for plain
    float frame;   ///< metres
  };

  Eigen::Vector3f floorColor(const Eigen::Vector3f& point, float blur) const;
  Eigen::Vector3f wallColorAt(int wall, float along, float height) const;
  std::vector<Panel> hangPanels(int wall, float half_length) const;

  uint64_t seed_;
  Eigen::Vector3f half_size_;
  Eigen::Vector3f wall_colors_[4];
  Eigen::Vector3f wood_;
  bool boards_along_x_;
  float board_width_;
  std::vector<Panel> panels_[4];
};

}  // namespace markerless_mocap
