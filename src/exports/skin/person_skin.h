#pragma once

#include <array>
#include <vector>

#include "character/character.h"
#include "exports/export_skeleton.h"

namespace markerless_mocap {

/// A skinned surface for a skeleton, at rest, in the skeleton's axes.
struct PersonSkin {
  ColoredMesh mesh;
  std::vector<Eigen::Vector3f> normals;        ///< per vertex, unit length
  std::vector<std::array<uint8_t, 4>> joints;  ///< per vertex, indices into the skeleton
  std::vector<std::array<float, 4>> weights;   ///< per vertex, sum 1; unused ones are 0
};

/// The average adult of this package, of the body's height, stretched along each bone to the
/// body's joints. Its girth is not the measured one.
PersonSkin personSkin(const BodyModel& body, const ExportSkeleton& skeleton);

}  // namespace markerless_mocap
