#pragma once

#include <Eigen/Core>
#include <vector>

namespace markerless_mocap {

/// One cross-section of a loft, metres: an oval around (side_centre, front_centre) with half width
/// `side` to both sides and the extents `front` and `back`.
struct LoftSection {
  double at = 0.0;
  double side_centre = 0.0, front_centre = 0.0;
  double side = 0.0, front = 0.0, back = 0.0;
};

/// Indices of the coordinates along a loft, to its sides and to its front.
struct LoftAxes {
  int along, side, front;
};

/// A solid through cross-sections, as a signed distance. The distance is exact on the surface;
/// elsewhere it is measured inside the cross-section.
class Loft {
 public:
  /// \param sections ascending by `at`, joined by monotone cubics
  /// \param square 0 gives ellipses, 1 rounded rectangles
  /// \param end_round radius of the edges of the flat ends, metres
  Loft(LoftAxes axes, const std::vector<LoftSection>& sections, double square, double end_round);

  double distance(const Eigen::Vector3d& p) const;

 private:
  LoftAxes axes_;
  double square_, end_round_;
  double begin_ = 0.0, end_ = 0.0, per_metre_ = 0.0;
  std::vector<LoftSection> samples_;  ///< evenly spaced
};

}  // namespace markerless_mocap
