#pragma once

#include <Eigen/Core>
#include <vector>

namespace markerless_mocap {

/// One cross-section of a loft: an oval of half width `side` both ways and `front`, `back` to the
/// other directions, about (side_centre, front_centre). Metres.
struct LoftSection {
  double at = 0.0;
  double side_centre = 0.0, front_centre = 0.0;
  double side = 0.0, front = 0.0, back = 0.0;
};

/// Which coordinates run along a loft, to its sides and to its front.
struct LoftAxes {
  int along, side, front;
};

/// A body drawn through cross-sections, as a signed distance: exact on the surface, measured
/// within the section elsewhere.
class Loft {
 public:
  /// \param sections by increasing `at`, joined by monotone cubics \param square 0 gives ellipses,
  /// 1 rounded rectangles \param end_round radius that the flat ends' edges are rounded with
  Loft(LoftAxes axes, const std::vector<LoftSection>& sections, double square, double end_round);

  double distance(const Eigen::Vector3d& p) const;

 private:
  LoftAxes axes_;
  double square_, end_round_;
  double begin_ = 0.0, end_ = 0.0, per_metre_ = 0.0;
  std::vector<LoftSection> samples_;  ///< evenly spaced
};

}  // namespace markerless_mocap
