#pragma once

#include <assimp/material.h>
#include <assimp/scene.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace markerless_mocap {

/// A box about a joint and the place it leads to; world axes, metres.
struct Box {
  std::string name, parent;
  Eigen::Vector3d head, tail;
  double half_width;
  bool skin_colored = false;
  bool weighted = true;
};

/// A person of boxes, 1.8 m tall in a T-pose, standing on z = 0 and facing +x, and the file that
/// tells of it.
struct BoxMan {
  std::vector<Box> boxes;
  /// From world axes in metres to the file's axes and unit.
  Eigen::Matrix4d T_file_world = Eigen::Matrix4d::Identity();
  /// The root node's, from the axes that mesh and joints are told in to the scene's.
  Eigen::Matrix4d root = Eigen::Matrix4d::Identity();
  Eigen::Vector3f skin_color{0.9f, 0.7f, 0.6f}, cloth_color{0.1f, 0.2f, 0.7f};
  std::string cloth_texture;   ///< file name, "*0" for the embedded one
  std::string embedded_image;  ///< bytes of a PNG
  std::vector<Box> loose;      ///< without bones, on the node `parent`
  bool has_bones = true;
  bool inside_out = false;    ///< all triangles
  bool bind_is_lost = false;  ///< vertices told in their bone's axes, bind matrices identity
};

inline Eigen::Vector3d mirroredY(const Eigen::Vector3d& p) {
  return {p.x(), -p.y(), p.z()};
}

/// \param arms below the horizontal, radians \param sided makes a name of (bone, 'l' or 'r')
inline BoxMan boxMan(double arms, const std::function<std::string(const char*, char)>& sided,
                     bool complete) {
  BoxMan man;
  const auto add = [&](const std::string& name, const std::string& parent,
                       const Eigen::Vector3d& head, const Eigen::Vector3d& tail, double width,
                       bool skin = false) {
    man.boxes.push_back({name, parent, head, tail, width, skin});
  };
  const auto middle = [&](const char* bone) { return sided(bone, ' '); };
  add(middle("Hips"), "", {0, 0, 0.95}, {0, 0, 1.06}, 0.14);
  add(middle("Spine"), middle("Hips"), {0, 0, 1.06}, {0, 0, 1.22}, 0.12);
  std::string chest = middle("Spine");
  if (complete) {
    chest = middle("Spine1");
    add(chest, middle("Spine"), {0, 0, 1.22}, {0, 0, 1.50}, 0.14);
    add(middle("Neck"), chest, {0, 0, 1.50}, {0, 0, 1.60}, 0.05, true);
    add(middle("Head"), middle("Neck"), {0, 0, 1.60}, {0, 0, 1.80}, 0.08, true);
  } else {
    man.boxes.back().tail.z() = 1.80;
  }
  const Eigen::Vector3d along(0, std::cos(arms), -std::sin(arms));
  for (char side : {'l', 'r'}) {
    const auto limb = [&](const char* name, const std::string& parent, const Eigen::Vector3d& head,
                          const Eigen::Vector3d& tail, double width, bool skin = false) {
      const bool left = side == 'l';
      add(sided(name, side), parent, left ? head : mirroredY(head), left ? tail : mirroredY(tail),
          width, skin);
      return man.boxes.back().name;
    };
    const Eigen::Vector3d shoulder(0, 0.18, 1.45), elbow = shoulder + 0.30 * along,
                                                   wrist = elbow + 0.25 * along;
    std::string parent = chest;
    if (complete) parent = limb("Shoulder", chest, {0, 0.03, 1.45}, shoulder, 0.05);
    parent = limb("Arm", parent, shoulder, elbow, 0.05);
    parent = limb("ForeArm", parent, elbow, complete ? wrist : wrist + 0.19 * along, 0.04);
    if (complete) {
      parent = limb("Hand", parent, wrist, wrist + 0.10 * along, 0.04, true);
      limb("HandMiddle1", parent, wrist + 0.10 * along, wrist + 0.19 * along, 0.03, true);
    }
    // Feet apart and turned out.
    const Eigen::Vector3d hip(0, 0.10, 0.92), knee(0, 0.15, 0.50), ankle(0, 0.20, 0.08),
        toe(0.14, 0.26, 0.03), tip(0.21, 0.29, 0.03);
    parent = limb("UpLeg", middle("Hips"), hip, knee, 0.07);
    parent = limb("Leg", parent, knee, ankle, 0.05);
    parent = limb("Foot", parent, ankle, complete ? toe : tip, 0.03);
    if (complete) limb("ToeBase", parent, toe, tip, 0.03);
  }
  return man;
}

/// Mixamo's names, y up, facing z, centimetres, arms 45 degrees down.
inline BoxMan mixamoMan() {
  BoxMan man = boxMan(
      M_PI / 4,
      [](const char* bone, char side) {
        return std::string("mixamorig:") +
               (side == 'l'   ? "Left"
                : side == 'r' ? "Right"
                              : "") +
               bone;
      },
      true);
  man.T_file_world.topLeftCorner<3, 3>() << 0, 100, 0, 0, 0, 100, 100, 0, 0;
  return man;
}

/// Blender's names, z up, facing -y, arms straight out; without chest, neck, head, collar bones,
/// hands and toes.
inline BoxMan plainMan() {
  BoxMan man = boxMan(
      0.0,
      [](const char* bone, char side) {
        const std::vector<std::pair<std::string, std::string>> words{
            {"UpLeg", "thigh"}, {"Leg", "shin"},        {"Foot", "foot"},  {"Arm", "upper_arm"},
            {"Hips", "hips"},   {"ForeArm", "forearm"}, {"Spine", "spine"}};
        const auto word = std::find_if(words.begin(), words.end(),
                                       [&](const auto& pair) { return pair.first == bone; });
        return word->second + (side == 'l' ? ".L" : side == 'r' ? ".R" : "");
      },
      false);
  man.T_file_world.topLeftCorner<3, 3>() << 0, 1, 0, -1, 0, 0, 0, 0, 1;
  return man;
}

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

  /// A node for a loose box, which is told in the axes of the person's meshes.
  void hang(const Box& box, unsigned mesh) {
    aiNode* node = new aiNode(box.name);
    aiNode* carrier = scene_.mRootNode;
    for (const Box& bone : man_.boxes) {
      if (bone.name != box.parent) continue;
      carrier = scene_.mRootNode->FindNode(bone.name.c_str());
      node->mTransformation = toAssimp(axesOf(bone).inverse());
    }
    own(node->mMeshes, node->mNumMeshes, std::vector<unsigned>{mesh});
    carrier->addChildren(1, &node);
  }

  aiMesh* looseMesh(const Box& box) const {
    std::vector<aiVector3D> vertices, coordinates;
    std::vector<aiFace> faces;
    addBox(box, vertices, coordinates, faces);
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
