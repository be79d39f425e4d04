#pragma once

#include <Eigen/Core>
#include <memory>
#include <string>
#include <vector>

#include "character/character.h"
#include "motion/bone_names.h"

struct aiScene;
namespace Assimp {
class Importer;
}

namespace markerless_mocap {

struct JointWeight {
  size_t joint;
  float weight;
};

/// A rig and the meshes that hang on it, in one pose, in the file's axes and unit.
struct RiggedMesh {
  std::vector<NamedJoint> joints;  ///< parents before children
  std::vector<Eigen::Vector3d> joint_positions;
  ColoredMesh mesh;
  std::vector<std::vector<JointWeight>> weights;  ///< of each vertex, may be empty
};

enum class RestPose {
  kBind,   ///< in which the skin was fastened to the bones
  kNodes,  ///< in which the file's nodes stand
};

/// A model file with bones.
class RiggedScene {
 public:
  /// Throws std::invalid_argument if the file cannot be read, has no mesh or no mesh with bones.
  explicit RiggedScene(const std::string& path);
  ~RiggedScene();

  /// Throws std::invalid_argument if a place is not finite.
  RiggedMesh in(RestPose pose) const;

 private:
  void requireBones() const;

  std::string path_;
  std::unique_ptr<Assimp::Importer> importer_;  // owns the scene
  const aiScene* scene_;
};

}  // namespace markerless_mocap
