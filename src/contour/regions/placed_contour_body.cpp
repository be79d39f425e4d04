#include "contour/regions/placed_contour_body.h"

#include "contour/model/contour_kinematics.h"

namespace markerless_mocap {

PlacedBody placedBody(const ContourBody& body, const ContourPose& pose) {
  ContourFrames frames;
  ContourWorldCones cones;
  body.place(pose, frames);
  body.place(frames, cones);
  PlacedBody out{{}, pose.position, int(ContourSegment::kCount)};
  for (size_t c = 0; c < cones.size(); ++c)
    out.cones.push_back({cones[c].a, cones[c].b, cones[c].radius_a, cones[c].radius_b,
                         int(contourKinematicTree().cones[c].ends[0].segment)});
  return out;
}

}  // namespace markerless_mocap
