#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>

#include "character/clothes/dressed_shape.h"

namespace markerless_mocap {

/// The colours of a person.
class CharacterColors {
 public:
  /// \param seed selects the colours
  CharacterColors(uint64_t seed, const HumanSkeleton& skeleton);

  /// Red, green and blue, 0 to 1, of a layer at a point of the body at rest: pattern or grain of
  /// cloth, eyes and lips of the face.
  Eigen::Vector3f colorAt(const Eigen::Vector3d& p, Layer layer) const;

 private:
  Eigen::Vector3d cloth(const Eigen::Vector3d& p, Layer layer) const;
  Eigen::Vector3d face(const Eigen::Vector3d& p) const;

  double stature_;
  std::array<Eigen::Vector3d, kLayerCount> base_;
  Eigen::Vector3d second_;  ///< second colour of the shirt's pattern
  int pattern_;
};

}  // namespace markerless_mocap
