#include "character/adult_character.h"

#include "character/body/surface_net.h"
#include "character/clothes/character_colors.h"
#include "character/clothes/dressed_shape.h"
#include "character/skin/skin_weights.h"

namespace markerless_mocap {
namespace {

constexpr double kPitch = 0.0115;  ///< of the lattice for a stature of 1.75 m, metres

Eigen::AlignedBox3d spaceOf(const HumanSkeleton& skeleton) {
  const double reach = skeleton.tailOf(Bone::kLeftHand).y() + 0.05 * skeleton.stature;
  return {Eigen::Vector3d(-0.28 * skeleton.stature, -reach, -0.03 * skeleton.stature),
          Eigen::Vector3d(0.28 * skeleton.stature, reach, 1.04 * skeleton.stature)};
}

/// Two triangles per quad, split along the shorter diagonal.
std::vector<std::array<int, 3>> trianglesOf(const Surface& surface) {
  std::vector<std::array<int, 3>> triangles;
  triangles.reserve(2 * surface.quads.size());
  for (const std::array<int, 4>& q : surface.quads) {
    const auto length = [&](size_t a, size_t b) {
      return (surface.vertices[size_t(q[a])] - surface.vertices[size_t(q[b])]).squaredNorm();
    };
    if (length(0, 2) <= length(1, 3)) {
      triangles.push_back({q[0], q[1], q[2]});
      triangles.push_back({q[0], q[2], q[3]});
    } else {
      triangles.push_back({q[0], q[1], q[3]});
      triangles.push_back({q[1], q[2], q[3]});
    }
  }
  return triangles;
}

}  // namespace

Character makeCharacter(const CharacterOptions& options) {
  options.validate();
  Character person;
  person.skeleton = HumanSkeleton::adult(options.stature, options.male);
  const BodyBuild build{options.stature, options.male,
                        fatnessOf(options.bmi, options.stature, options.male)};
  const DressedShape shape(BodyShape(person.skeleton, build), options);
  const Surface surface = surfaceOf([&](const Eigen::Vector3d& p) { return shape.distance(p); },
                                    spaceOf(person.skeleton), kPitch * options.stature / 1.75);
  const CharacterColors look(uint64_t(options.appearance_seed), person.skeleton);
  std::vector<Layer> layers;
  for (const Eigen::Vector3d& vertex : surface.vertices) {
    layers.push_back(shape.layerAt(vertex));
    person.mesh.vertices.push_back(vertex.cast<float>());
    person.mesh.colors.push_back(look.colorAt(vertex, layers.back()));
  }
  person.mesh.triangles = trianglesOf(surface);
  person.weights = skinWeights(person.skeleton, surface, layers);
  return person;
}

}  // namespace markerless_mocap
