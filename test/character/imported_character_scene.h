#pragma once

#include <assimp/material.h>
#include <assimp/scene.h>

#include <utility>

#include "character/imported_character_man.h"

namespace markerless_mocap {

/// Builds the scene that a model file is written from.
class BoxManScene {
 public:
  explicit BoxManScene(const BoxMan& man) : man_(man) {
    addMaterials();
    addNodes();
    std::vector<aiMesh*> meshes;
    std::vector<unsigned> own_meshes;
    for (bool skin : {false, true}) {
      if (std::none_of(man.boxes.begin(), man.boxes.end(),
                       [&](const Box& box) { return box.skin_colored == skin; }))
        continue;
      own_meshes.push_back(unsigned(meshes.size()));
      meshes.push_back(mesh(skin));
    }
    own(scene_.mRootNode->mMeshes, scene_.mRootNode->mNumMeshes, own_meshes);
    for (const Box& box : man.loose) {
      hang(box, unsigned(meshes.size()));
      meshes.push_back(looseMesh(box));
    }
    own(scene_.mMeshes, scene_.mNumMeshes, meshes);
  }

  const aiScene& scene() const { return scene_; }

 private:
  template <typename T>
  static void own(T*& array, unsigned& count, const std::vector<T>& values) {
    array = new T[values.size()];
    std::copy(values.begin(), values.end(), array);
    count = unsigned(values.size());
  }

  static aiMatrix4x4 toAssimp(const Eigen::Matrix4d& m) {
    aiMatrix4x4 matrix;
    for (unsigned r = 0; r < 4; ++r)
      for (unsigned c = 0; c < 4; ++c) matrix[r][c] = float(m(r, c));
    return matrix;
  }

  Eigen::Vector3d inFile(const Eigen::Vector3d& world) const {
    return man_.T_file_world.topLeftCorner<3, 3>() * world;
  }

  /// A bone's axes in the file: y along it, as most programs have it.
  Eigen::Matrix4d axesOf(const Box& box) const {
    Eigen::Matrix4d axes = Eigen::Matrix4d::Identity();
    axes.topLeftCorner<3, 3>() =
        Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitY(), inFile(box.tail - box.head))
            .toRotationMatrix();
    axes.topRightCorner<3, 1>() = inFile(box.head);
    return axes;
  }

  void addMaterials() {
    std::vector<aiMaterial*> materials;
    for (const Eigen::Vector3f& color : {man_.cloth_color, man_.skin_color}) {
      aiMaterial* material = new aiMaterial;
      const aiColor4D diffuse(color.x(), color.y(), color.z(), 1.0f);
      material->AddProperty(&diffuse, 1, AI_MATKEY_COLOR_DIFFUSE);
      materials.push_back(material);
    }
    if (!man_.cloth_texture.empty()) {
      const aiString name(man_.cloth_texture);
      materials[0]->AddProperty(&name, AI_MATKEY_TEXTURE_DIFFUSE(0));
    }
    own(scene_.mMaterials, scene_.mNumMaterials, materials);
    if (man_.embedded_image.empty()) return;
    aiTexture* image = new aiTexture;
    image->mWidth = unsigned(man_.embedded_image.size());
    image->mHeight = 0;
    image->pcData = new aiTexel[man_.embedded_image.size() / sizeof(aiTexel) + 1];
    std::copy(man_.embedded_image.begin(), man_.embedded_image.end(),
              reinterpret_cast<char*>(image->pcData));
    std::copy_n("png", 4, image->achFormatHint);
    own(scene_.mTextures, scene_.mNumTextures, {image});
  }

  void addNodes() {
    scene_.mRootNode = new aiNode("Scene");
    scene_.mRootNode->mTransformation = toAssimp(man_.root);
    addChildren(*scene_.mRootNode, "", Eigen::Matrix4d::Identity());
  }

  void addChildren(aiNode& node, const std::string& parent, const Eigen::Matrix4d& axes) {
    std::vector<aiNode*> children;
    for (const Box& box : man_.boxes) {
      if (box.parent != parent) continue;
      aiNode* child = new aiNode(box.name);
      child->mTransformation = toAssimp(axes.inverse() * axesOf(box));
      addChildren(*child, box.name, axesOf(box));
      children.push_back(child);
    }
    if (!children.empty()) node.addChildren(unsigned(children.size()), children.data());
  }

  /// A node for a loose box, which is told in the axes of the person's meshes, mirrored.
  void hang(const Box& box, unsigned mesh) {
    aiNode* node = new aiNode(box.name);
    aiNode* carrier = scene_.mRootNode;
    Eigen::Matrix4d mirror = Eigen::Matrix4d::Identity();
    mirror(0, 0) = -1.0;
    node->mTransformation = toAssimp(mirror);
    for (const Box& bone : man_.boxes) {
      if (bone.name != box.parent) continue;
      carrier = scene_.mRootNode->FindNode(bone.name.c_str());
      node->mTransformation = toAssimp(axesOf(bone).inverse() * mirror);
    }
    own(node->mMeshes, node->mNumMeshes, std::vector<unsigned>{mesh});
    carrier->addChildren(1, &node);
  }

  aiMesh* looseMesh(const Box& box) const {
    std::vector<aiVector3D> vertices, coordinates;
    std::vector<aiFace> faces;
    addBox(box, vertices, coordinates, faces);
    for (aiVector3D& vertex : vertices) vertex.x *= -1.0f;
    for (aiFace& face : faces) std::swap(face.mIndices[1], face.mIndices[2]);
    return mesh(vertices, coordinates, faces, {}, false);
  }

  /// The boxes of one colour.
  aiMesh* mesh(bool skin) const {
    std::vector<aiVector3D> vertices, coordinates;
    std::vector<aiFace> faces;
    std::vector<aiBone*> bones;
    for (const Box& box : man_.boxes) {
      if (box.skin_colored != skin) continue;
      const unsigned first = unsigned(vertices.size());
      addBox(box, vertices, coordinates, faces);
      if (man_.has_bones) bones.push_back(bone(box, first));
    }
    return mesh(vertices, coordinates, faces, bones, skin);
  }

  static aiMesh* mesh(const std::vector<aiVector3D>& vertices,
                      const std::vector<aiVector3D>& coordinates, const std::vector<aiFace>& faces,
                      const std::vector<aiBone*>& bones, bool skin) {
    aiMesh* mesh = new aiMesh;
    mesh->mName = aiString(skin ? "skin" : "cloth");
    mesh->mMaterialIndex = skin ? 1 : 0;
    mesh->mPrimitiveTypes = aiPrimitiveType_TRIANGLE;
    own(mesh->mVertices, mesh->mNumVertices, vertices);
    own(mesh->mTextureCoords[0], mesh->mNumVertices, coordinates);
    mesh->mNumUVComponents[0] = 2;
    own(mesh->mFaces, mesh->mNumFaces, faces);
    if (!bones.empty()) own(mesh->mBones, mesh->mNumBones, bones);
    return mesh;
  }

  aiBone* bone(const Box& box, unsigned first) const {
    aiBone* bone = new aiBone;
    bone->mName = aiString(box.name);
    if (!man_.bind_is_lost) bone->mOffsetMatrix = toAssimp(axesOf(box).inverse());
    std::vector<aiVertexWeight> weights;
    for (unsigned v = 0; v < 8; ++v) weights.emplace_back(first + v, box.weighted ? 1.0f : 0.0f);
    own(bone->mWeights, bone->mNumWeights, weights);
    return bone;
  }

  /// Texture coordinates: u to the person's left, v upward.
  void addBox(const Box& box, std::vector<aiVector3D>& vertices,
              std::vector<aiVector3D>& coordinates, std::vector<aiFace>& faces) const {
    const unsigned first = unsigned(vertices.size());
    const Eigen::Vector3d along = (box.tail - box.head).normalized();
    Eigen::Vector3d across = Eigen::Vector3d::UnitX();
    if (std::abs(along.x()) > 0.5) across = Eigen::Vector3d::UnitZ();
    across = (across - along * along.dot(across)).normalized();
    const Eigen::Vector3d aside = along.cross(across);
    for (int i = 0; i < 8; ++i) {
      const Eigen::Vector3d corner =
          (i & 4 ? box.tail : box.head) +
          box.half_width * ((i & 1 ? 1 : -1) * across + (i & 2 ? 1 : -1) * aside);
      Eigen::Vector4d in_file = inFile(corner).homogeneous();
      if (man_.bind_is_lost) in_file = axesOf(box).inverse() * in_file;
      const Eigen::Vector3f p = in_file.head<3>().cast<float>();
      vertices.emplace_back(p.x(), p.y(), p.z());
      coordinates.emplace_back(corner.y() > 0 ? 0.75f : 0.25f, corner.z() > 1.0 ? 0.75f : 0.25f,
                               0.0f);
    }
    const unsigned quads[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                  {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    const bool mirrored = (man_.T_file_world.determinant() < 0.0) != man_.inside_out;
    for (const auto& quad : quads)
      for (const auto& [b, c] : {std::pair(1, 2), std::pair(2, 3)}) {
        aiFace face;
        own(face.mIndices, face.mNumIndices,
            {first + quad[0], first + quad[mirrored ? c : b], first + quad[mirrored ? b : c]});
        faces.push_back(face);
      }
  }

  const BoxMan& man_;
  aiScene scene_;
};

}  // namespace markerless_mocap
