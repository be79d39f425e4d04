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

/// A rig and its meshes in one pose, in the file's axes and unit.
struct RiggedMesh {
  std::vector<NamedJoint> joints;  ///< parents before children
  std::vector<Eigen::Vector3d> joint_positions;
  ColoredMesh mesh;
  std::vector<std::vector<JointWeight>> weights;  ///< per vertex, may be empty
};

enum class RestPose {
  kBind,   ///< the bind pose
  kNodes,  ///< the pose of the file's nodes
};

/// A model file with a skeleton.
class RiggedScene {
 public:
  /// Throws std::invalid_argument if the file cannot be read, has no mesh or no mesh with bones.
  explicit RiggedScene(const std::string& path);
  ~RiggedScene();

  /// The rig and meshes in a pose. Throws std::invalid_argument if a position is not finite.
  RiggedMesh in(RestPose pose) const;

 private:
  void requireBones() const;

  std::string path_;
  std::unique_ptr<Assimp::Importer> importer_;  // owns the scene
  const aiScene* scene_;
};

}  // namespace markerless_mocap
