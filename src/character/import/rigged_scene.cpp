#include "character/import/rigged_scene.h"

#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <algorithm>

#include <assimp/Importer.hpp>
#include <filesystem>
#include <optional>
#include <stdexcept>

#include "character/import/gltf_check.h"
#include "character/import/material_colors.h"
#include "character/import/node_joints.h"

namespace markerless_mocap {
namespace {

using Eigen::Matrix4d;
using Eigen::Vector3d;

/// Merges the meshes of a scene in one pose.
class Merger {
 public:
  Merger(const aiScene& scene, const std::string& path, RestPose pose)
      : scene_(scene),
        path_(path),
        nodes_(scene),
        colors_(scene, path),
        T_joint_(pose == RestPose::kBind ? nodes_.bindTransforms() : nodes_.nodeTransforms()) {}

  RiggedMesh merged() {
    for (unsigned m = 0; m < scene_.mNumMeshes; ++m)
      if (scene_.mMeshes[m]->HasBones()) addSkinned(*scene_.mMeshes[m]);
    addHanging(*scene_.mRootNode);
    result_.joints = nodes_.joints();
    for (const Matrix4d& transform : T_joint_)
      result_.joint_positions.push_back(transform.topRightCorner<3, 1>());
    turnOutward();
    requireFinite();
    return std::move(result_);
  }

 private:
  void addSkinned(const aiMesh& mesh) {
    std::vector<Matrix4d> blends(mesh.mNumVertices, Matrix4d::Zero());
    std::vector<std::vector<JointWeight>> weights(mesh.mNumVertices);
    std::vector<double> sums(mesh.mNumVertices, 0.0);
    const auto transformOf = [&](const aiBone& bone) -> Matrix4d {
      return T_joint_[nodes_.jointOf(bone)] * matrixOf(bone.mOffsetMatrix);
    };
    for (unsigned b = 0; b < mesh.mNumBones; ++b) {
      const aiBone& bone = *mesh.mBones[b];
      const Matrix4d transform = transformOf(bone);
      for (unsigned w = 0; w < bone.mNumWeights; ++w) {
        const aiVertexWeight& entry = bone.mWeights[w];
        if (entry.mVertexId >= mesh.mNumVertices || !(entry.mWeight > 0.0f)) continue;
        blends[entry.mVertexId] += double(entry.mWeight) * transform;
        sums[entry.mVertexId] += double(entry.mWeight);
        weights[entry.mVertexId].push_back({nodes_.jointOf(bone), entry.mWeight});
      }
    }
    const Matrix4d whole = transformOf(*mesh.mBones[0]);
    for (size_t v = 0; v < blends.size(); ++v)
      blends[v] = sums[v] > 0.0 ? Matrix4d(blends[v] / sums[v]) : whole;
    append(mesh, blends, weights, whole.topLeftCorner<3, 3>().determinant() < 0.0);
  }

  /// Adds meshes without bones below a joint's node, for example eyes and hats.
  void addHanging(const aiNode& node) {
    const std::optional<size_t> joint = nodes_.carrierOf(node);
    for (unsigned m = 0; joint && m < node.mNumMeshes; ++m) {
      const aiMesh& mesh = *scene_.mMeshes[node.mMeshes[m]];
      if (mesh.HasBones()) continue;
      const Matrix4d transform =
          T_joint_[*joint] * nodes_.nodeTransforms()[*joint].inverse() * nodeTransform(node);
      append(mesh, std::vector<Matrix4d>(mesh.mNumVertices, transform),
             std::vector<std::vector<JointWeight>>(mesh.mNumVertices, {{*joint, 1.0f}}),
             transform.topLeftCorner<3, 3>().determinant() < 0.0);
    }
    for (unsigned c = 0; c < node.mNumChildren; ++c) addHanging(*node.mChildren[c]);
  }

  void append(const aiMesh& mesh, const std::vector<Matrix4d>& transforms,
              const std::vector<std::vector<JointWeight>>& weights, bool mirrored) {
    ColoredMesh& all = result_.mesh;
    const int first = int(all.vertices.size());
    for (unsigned v = 0; v < mesh.mNumVertices; ++v) {
      const aiVector3D& p = mesh.mVertices[v];
      all.vertices.push_back(
          (transforms[v] * Eigen::Vector4d(p.x, p.y, p.z, 1.0)).head<3>().cast<float>());
    }
    const std::vector<Eigen::Vector3f> colors = colors_.of(mesh);
    all.colors.insert(all.colors.end(), colors.begin(), colors.end());
    result_.weights.insert(result_.weights.end(), weights.begin(), weights.end());
    for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
      const aiFace& face = mesh.mFaces[f];
      if (face.mNumIndices != 3) continue;
      std::array<int, 3> triangle;
      for (size_t k = 0; k < 3; ++k) triangle[k] = first + int(face.mIndices[mirrored ? 2 - k : k]);
      all.triangles.push_back(triangle);
    }
  }

  /// A mesh with a negative volume has inverted triangles; they are turned.
  void turnOutward() {
    ColoredMesh& mesh = result_.mesh;
    Vector3d middle = Vector3d::Zero();
    for (const Eigen::Vector3f& vertex : mesh.vertices) middle += vertex.cast<double>();
    middle /= double(std::max<size_t>(mesh.vertices.size(), 1));
    double volume = 0.0;
    const auto corner = [&](int v) -> Vector3d {
      return mesh.vertices[size_t(v)].cast<double>() - middle;
    };
    for (const auto& [a, b, c] : mesh.triangles)
      volume += corner(a).dot(corner(b).cross(corner(c)));
    if (volume >= 0.0) return;
    for (std::array<int, 3>& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
  }

  void requireFinite() const {
    for (const Eigen::Vector3f& vertex : result_.mesh.vertices)
      if (!vertex.allFinite())
        throw std::invalid_argument(path_ + ": a vertex's place is not a finite number");
    for (size_t j = 0; j < result_.joint_positions.size(); ++j)
      if (!result_.joint_positions[j].allFinite())
        throw std::invalid_argument(path_ + ": the place of the joint " + result_.joints[j].name +
                                    " is not a finite number");
  }

  const aiScene& scene_;
  const std::string& path_;
  NodeJoints nodes_;
  MaterialColors colors_;
  std::vector<Matrix4d> T_joint_;
  RiggedMesh result_;
};

}  // namespace

RiggedScene::RiggedScene(const std::string& path)
    : path_(path), importer_(std::make_unique<Assimp::Importer>()) {
  if (!std::filesystem::is_regular_file(path))
    throw std::invalid_argument(path + ": there is no such file");
  checkGltf(path);
  // Separate pivot nodes would be between the joints, and normals would keep equal vertices
  // separate.
  importer_->SetPropertyBool(AI_CONFIG_IMPORT_FBX_PRESERVE_PIVOTS, false);
  importer_->SetPropertyInteger(AI_CONFIG_PP_RVC_FLAGS,
                                aiComponent_NORMALS | aiComponent_TANGENTS_AND_BITANGENTS);
  scene_ = importer_->ReadFile(path, aiProcess_ValidateDataStructure | aiProcess_RemoveComponent |
                                         aiProcess_Triangulate | aiProcess_JoinIdenticalVertices);
  if (!scene_)
    throw std::invalid_argument(path + ": is no model that can be read (" +
                                importer_->GetErrorString() + ")");
  if (scene_->mNumMeshes == 0) throw std::invalid_argument(path + ": has no mesh");
  requireBones();
}

void RiggedScene::requireBones() const {
  bool found = false;
  for (unsigned m = 0; m < scene_->mNumMeshes; ++m) {
    const aiMesh& mesh = *scene_->mMeshes[m];
    for (unsigned b = 0; b < mesh.mNumBones; ++b)
      if (!scene_->mRootNode->FindNode(mesh.mBones[b]->mName))
        throw std::invalid_argument(path_ + ": the bone " + mesh.mBones[b]->mName.C_Str() +
                                    " has no node");
    found |= mesh.HasBones();
  }
  if (!found)
    throw std::invalid_argument(path_ +
                                ": no mesh is fastened to bones, a rigged character is needed");
}

RiggedScene::~RiggedScene() = default;

RiggedMesh RiggedScene::in(RestPose pose) const {
  return Merger(*scene_, path_, pose).merged();
}

}  // namespace markerless_mocap
