#pragma once

#include <string>
#include <vector>

#include "markerless_mocap/body/body_model.h"

namespace markerless_mocap {

/// Tree and shape of a URDF, before twists are computed.
struct BodyTree {
  std::vector<std::string> links;
  std::vector<BodyJoint> joints;
  std::vector<RoundCone> shape;
};

/// Reads and checks a URDF; see BodyModel::fromUrdf().
BodyTree readBodyTree(const std::string& urdf_xml, const std::string& id);

}  // namespace markerless_mocap
