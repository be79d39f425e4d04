#include "hsiao/model/hsiao_body_shape.h"

#include <algorithm>
#include <cmath>

namespace markerless_mocap {

HsiaoBodyShape::HsiaoBodyShape(const BodyModel& model, const HsiaoBodyModel& body_model) {
  for (const RoundCone& cone : model.shape()) {
    const HsiaoSegmentPoint& link = body_model.links()[cone.link];
    cones_.push_back(
        {link.segment, link.offset + cone.a, link.offset + cone.b, cone.radius_a, cone.radius_b});
    fill(cones_.back());
  }
}

void HsiaoBodyShape::fill(const HsiaoSegmentCone& cone) {
  const double spacing = 0.5 * std::min(cone.radius_a, cone.radius_b);
  const int steps = spacing > 0 ? int(std::ceil((cone.b - cone.a).norm() / spacing)) : 0;
  for (int i = 0; i <= steps; ++i) {
    const double t = steps > 0 ? double(i) / steps : 0.0;
    spheres_.push_back({{cone.segment, cone.a + t * (cone.b - cone.a)},
                        cone.radius_a + t * (cone.radius_b - cone.radius_a)});
  }
}

HsiaoWorldCone HsiaoBodyShape::inWorld(const HsiaoFrames& frames, int cone) const {
  const HsiaoSegmentCone& c = cones_[cone];
  const Eigen::Vector3d ab = frames.R[c.segment] * (c.b - c.a);
  const double squared = ab.squaredNorm();
  return {frames.p[c.segment] + frames.R[c.segment] * c.a, ab, squared > 0 ? 1.0 / squared : 0.0,
          c.radius_a, c.radius_b - c.radius_a};
}

void HsiaoBodyShape::inWorld(const HsiaoFrames& frames, std::vector<HsiaoWorldCone>& out) const {
  out.resize(cones_.size());
  for (size_t i = 0; i < cones_.size(); ++i) out[i] = inWorld(frames, int(i));
}

}  // namespace markerless_mocap
