#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <assimp/Importer.hpp>
#include <cstring>
#include <map>
#include <nlohmann/json.hpp>

#include "exports/export_fixture.h"

namespace markerless_mocap {
namespace {

using Eigen::Matrix4d;
using Eigen::Vector3d;

Matrix4d matrixOf(const aiMatrix4x4& m) {
  Matrix4d out;
  for (unsigned row = 0; row < 4; ++row)
    for (unsigned column = 0; column < 4; ++column) out(row, column) = m[row][column];
  return out;
}

/// The file through Assimp's reader.
class GlbFile : public MovingPerson {
 protected:
  void read(const PersonMotion& motion) {
    bytes_ = glbOf(motion, exportSkeleton(*body_, "motionbuilder"));
    scene_ = importer_.ReadFileFromMemory(bytes_.data(), bytes_.size(),
                                          aiProcess_ValidateDataStructure, "glb");
    ASSERT_TRUE(scene_) << importer_.GetErrorString();
    ASSERT_EQ(scene_->mNumMeshes, 1u);
    ASSERT_EQ(scene_->mNumAnimations, 1u);
  }

  /// World poses of all nodes at a key of the animation.
  std::map<std::string, Matrix4d> nodesAt(unsigned key) const {
    std::map<std::string, Matrix4d> out;
    add(*scene_->mRootNode, Matrix4d::Identity(), key, &out);
    return out;
  }
  void add(const aiNode& node, const Matrix4d& parent, unsigned key,
           std::map<std::string, Matrix4d>* out) const {
    Matrix4d local = matrixOf(node.mTransformation);
    for (unsigned c = 0; c < scene_->mAnimations[0]->mNumChannels; ++c) {
      const aiNodeAnim& channel = *scene_->mAnimations[0]->mChannels[c];
      if (channel.mNodeName != node.mName) continue;
      const aiQuaternion& q = channel.mRotationKeys[key].mValue;
      local.topLeftCorner<3, 3>() = Eigen::Quaterniond(q.w, q.x, q.y, q.z).toRotationMatrix();
      if (channel.mNumPositionKeys > 1) {
        const aiVector3D& p = channel.mPositionKeys[key].mValue;
        local.topRightCorner<3, 1>() << p.x, p.y, p.z;
      }
    }
    const Matrix4d world = parent * local;
    (*out)[node.mName.C_Str()] = world;
    for (unsigned i = 0; i < node.mNumChildren; ++i) add(*node.mChildren[i], world, key, out);
  }

  nlohmann::json json() const {
    uint32_t length;
    std::memcpy(&length, &bytes_[12], 4);
    return nlohmann::json::parse(bytes_.substr(20, length));
  }

  std::string bytes_;
  Assimp::Importer importer_;
  const aiScene* scene_ = nullptr;
};

Vector3d world(const Matrix4d& node) {
  return {node(2, 3), node(0, 3), node(1, 3)};  // y up, z is the world's x
}

TEST_F(GlbFile, JointsAreWhereTheLinksAre) {
  const PersonMotion recorded = motion(60);
  read(recorded);
  for (const unsigned f : {0u, 17u, 59u}) {
    const auto nodes = nodesAt(f);
    for (const auto& [joint, name] : {std::pair{"Hips", "body"},
                                      {"Spine", "waist"},
                                      {"Head", "head"},
                                      {"LeftHand", "l_wrist"},
                                      {"RightForeArm", "r_elbow"},
                                      {"RightFoot", "r_ankle"},
                                      {"LeftLeg", "l_knee"}})
      EXPECT_LT((world(nodes.at(joint)) - link(recorded.frames[f], name).translation()).norm(),
                1e-5)
          << joint << " in frame " << f;
  }
}

TEST_F(GlbFile, KeysAreAtTheTimesOfTheFrames) {
  std::vector<PersonFrame> all = frames(4);
  all[3].stamp_ns += 7000000;
  read(personMotion(body_, all));
  const aiAnimation& animation = *scene_->mAnimations[0];
  const aiNodeAnim& channel = *animation.mChannels[0];
  ASSERT_EQ(channel.mNumRotationKeys, 4u);
  const double second = animation.mTicksPerSecond;
  EXPECT_NEAR(channel.mRotationKeys[1].mTime / second, 0.04, 1e-6);
  EXPECT_NEAR(channel.mRotationKeys[3].mTime / second, 0.127, 1e-6);
}

// Each vertex, moved by the bones, is near the round cones of the measured body.
TEST_F(GlbFile, SkinFollowsTheBody) {
  const PersonMotion recorded = motion(30);
  read(recorded);
  const auto nodes = nodesAt(29);
  const aiMesh& mesh = *scene_->mMeshes[0];
  std::vector<Vector3d> moved(mesh.mNumVertices, Vector3d::Zero());
  std::vector<double> sums(mesh.mNumVertices, 0.0);
  for (unsigned b = 0; b < mesh.mNumBones; ++b) {
    const aiBone& bone = *mesh.mBones[b];
    const Matrix4d T = nodes.at(bone.mName.C_Str()) * matrixOf(bone.mOffsetMatrix);
    for (unsigned w = 0; w < bone.mNumWeights; ++w) {
      const auto [vertex, weight] = std::pair(bone.mWeights[w].mVertexId, bone.mWeights[w].mWeight);
      const aiVector3D& v = mesh.mVertices[vertex];
      moved[vertex] += weight * (T * Eigen::Vector4d(v.x, v.y, v.z, 1)).head<3>();
      sums[vertex] += weight;
    }
  }
  size_t far = 0;
  for (size_t v = 0; v < moved.size(); ++v) {
    EXPECT_NEAR(sums[v], 1.0, 1e-4);
    const Vector3d place(moved[v].z(), moved[v].x(), moved[v].y());
    double distance = 1e9;
    for (const RoundCone& cone : body_->shape()) {
      const Eigen::Isometry3d& T = recorded.frames[29].T_world_link[size_t(cone.link)];
      const Vector3d a = T * cone.a, d = T * cone.b - a;
      const double along =
          d.squaredNorm() > 0 ? std::clamp(d.dot(place - a) / d.squaredNorm(), 0.0, 1.0) : 0.0;
      distance = std::min(distance, (place - a - along * d).norm() - cone.radius_a);
    }
    far += distance > 0.06;
  }
  EXPECT_GT(moved.size(), 10000u);
  EXPECT_LT(double(far) / double(moved.size()), 0.02);
}

TEST_F(GlbFile, NoVertexNamesAJointTwice) {
  read(motion(2));
  const nlohmann::json file = json();
  const int joints = file["meshes"][0]["primitives"][0]["attributes"]["JOINTS_0"];
  const int weights = file["meshes"][0]["primitives"][0]["attributes"]["WEIGHTS_0"];
  const size_t data = 20 + size_t(file.dump().size() + 3) / 4 * 4 + 8;
  const auto begin = [&](int accessor) {
    const int view = file["accessors"][size_t(accessor)]["bufferView"];
    return data + file["bufferViews"][size_t(view)]["byteOffset"].get<size_t>();
  };
  const size_t count = file["accessors"][size_t(joints)]["count"];
  for (size_t v = 0; v < count; ++v) {
    std::map<int, int> times;
    for (size_t k = 0; k < 4; ++k) {
      float weight;
      std::memcpy(&weight, &bytes_[begin(weights) + 16 * v + 4 * k], 4);
      if (weight > 0) ++times[bytes_[begin(joints) + 4 * v + k]];
    }
    for (const auto& [joint, number] : times) ASSERT_EQ(number, 1) << "joint " << joint;
  }
}

TEST_F(GlbFile, SaysWhereJointsWereNotSeen) {
  std::vector<PersonFrame> all = frames(5);
  hideLeftArm(&all[2]);
  read(personMotion(body_, all));
  const nlohmann::json gaps = json()["asset"]["extras"]["gaps"];
  ASSERT_EQ(gaps.size(), 4u);
  EXPECT_EQ(gaps[2]["joint"], "LeftForeArm");
  EXPECT_NEAR(gaps[2]["from_s"].get<double>(), 0.08, 1e-9);
  EXPECT_EQ(gaps[2]["state"], "not seen, held");
}

}  // namespace
}  // namespace markerless_mocap
