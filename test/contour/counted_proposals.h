#pragma once

#include <memory>
#include <utility>

#include "contour/contour_urdf_converter.h"
#include "tracking/pose_initializer.h"

namespace markerless_mocap {

/// Always proposes the same pose, and counts.
class CountedProposals : public PoseInitializer {
 public:
  CountedProposals(std::shared_ptr<const BodyModel> model, const ContourPose& pose, int* calls)
      : converter_(std::move(model)), pose_(pose), calls_(calls) {}

  BodyPose update(int64_t, const BodyParts&, const VisualHull&) override {
    ++*calls_;
    BodyPose proposal;
    proposal.status = PoseStatus::kTracked;
    converter_.convert(pose_, proposal.T_world_body, proposal.angles);
    return proposal;
  }
  void reset() override {}

 private:
  ContourUrdfConverter converter_;
  ContourPose pose_;
  int* calls_;
};

}  // namespace markerless_mocap
