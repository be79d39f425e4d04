#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace markerless_mocap {

/// Colour of walls, floor and ceiling of a room as a function of the position.
class RoomTexture {
 public:
  RoomTexture(uint64_t seed, const Eigen::Vector3f& half_size);

  /// Red, green and blue, 0 to 1, under the room's light.
  /// \param axis the surface's normal is along this axis
  /// \param upper whether it is the surface with the larger coordinate
  /// \param blur width over which the pattern is blurred, metres
  Eigen::Vector3f color(const Eigen::Vector3f& point, int axis, bool upper, float blur) const;
  Eigen::Vector3f wallColor() const;

 private:
  /// A rectangle on a wall: picture, door, window, notice.
  struct Panel {
    float along_low, along_high, low, high;  ///< bounds along the wall and upwards, metres
    Eigen::Vector3f color, second;
    float stripe;  ///< width, metres; 0: plain
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
