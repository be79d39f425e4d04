#include "exports/skin/person_skin.h"

#include <algorithm>
#include <map>

#include "character/adult_character.h"
#include "evaluation/body_points.h"
#include "exports/skin/measured_bones.h"
#include "numerics/shortest_rotation.h"

namespace markerless_mocap {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;

/// For each bone the motion of its surface from the average adult to the person: its head and
/// direction become those of the person, its length is stretched, its girth stays.
PerBone<Eigen::Affine3d> stretches(const HumanSkeleton& from, const HumanSkeleton& to) {
  PerBone<Eigen::Affine3d> out;
  for (int b = 0; b < kBoneCount; ++b) {
    const Bone bone = Bone(b);
    const Vector3d direction = (from.tailOf(bone) - from.headOf(bone)).normalized();
    const double stretch = to.lengthOf(bone) / from.lengthOf(bone);
    Eigen::Affine3d T = Eigen::Affine3d::Identity();
    T.translate(to.headOf(bone));
    T.rotate(shortestRotation(direction, to.tailOf(bone) - to.headOf(bone)));
    T.linear() *= Eigen::Matrix3d::Identity() + (stretch - 1.0) * direction * direction.transpose();
    T.translate(-from.headOf(bone));
    out[size_t(b)] = T;
  }
  return out;
}

std::vector<Vector3f> stretched(const Character& adult, const PerBone<Eigen::Affine3d>& bones) {
  std::vector<Vector3f> out;
  for (size_t v = 0; v < adult.mesh.vertices.size(); ++v) {
    const VertexWeights& weights = adult.weights[v];
    Vector3d place = Vector3d::Zero();
    for (size_t k = 0; k < 4; ++k)
      place += weights.weights[k] *
               (bones[size_t(weights.bones[k])] * adult.mesh.vertices[v].cast<double>());
    out.push_back(place.cast<float>());
  }
  return out;
}

std::vector<Vector3f> normalsOf(const ColoredMesh& mesh) {
  std::vector<Vector3f> normals(mesh.vertices.size(), Vector3f::Zero());
  for (const std::array<int, 3>& t : mesh.triangles) {
    const Vector3f& a = mesh.vertices[size_t(t[0])];
    const Vector3f area = (mesh.vertices[size_t(t[1])] - a).cross(mesh.vertices[size_t(t[2])] - a);
    for (const int vertex : t) normals[size_t(vertex)] += area;
  }
  for (Vector3f& normal : normals)
    normal = normal.norm() > 0 ? Vector3f(normal.normalized()) : Vector3f(Vector3f::UnitX());
  return normals;
}

/// Several bones may belong to one joint, which a vertex may name only once.
void addWeights(const VertexWeights& weights, const PerBone<size_t>& joint_of, PersonSkin* skin) {
  std::map<size_t, float> by_joint;
  for (size_t k = 0; k < 4; ++k)
    if (weights.weights[k] > 0) by_joint[joint_of[size_t(weights.bones[k])]] += weights.weights[k];
  std::array<uint8_t, 4> joints{};
  std::array<float, 4> values{};
  size_t k = 0;
  for (const auto& [joint, weight] : by_joint) {
    joints[k] = uint8_t(joint);
    values[k++] = weight;
  }
  skin->joints.push_back(joints);
  skin->weights.push_back(values);
}

double statureOf(const BodyModel& body, const ExportSkeleton& skeleton) {
  LinkPoses rest(body.links().size(), Eigen::Isometry3d::Identity());
  for (const ExportJoint& joint : skeleton) {
    rest[size_t(joint.link)].translation() = joint.rest;
    rest[size_t(joint.link)].linear() = joint.R_rest;
  }
  double top = 0.0;
  for (const ExportJoint& joint : skeleton)
    top = std::max(top, joint.has_end ? joint.end.z() : 0.0);
  constexpr double kShortest = 0.5, kTallest = 2.5;  // metres, of HumanSkeleton::adult()
  return std::clamp(top - soleHeights(body, rest).minCoeff(), kShortest, kTallest);
}

}  // namespace

PersonSkin personSkin(const BodyModel& body, const ExportSkeleton& skeleton) {
  CharacterOptions options;
  options.stature = statureOf(body, skeleton);
  options.male = 0.5;
  const Character adult = makeCharacter(options);
  const MeasuredBones measured = measuredBones(skeleton, adult.skeleton);
  PersonSkin skin;
  skin.mesh = adult.mesh;
  skin.mesh.vertices = stretched(adult, stretches(adult.skeleton, measured.skeleton));
  skin.normals = normalsOf(skin.mesh);
  for (const VertexWeights& weights : adult.weights) addWeights(weights, measured.joint, &skin);
  return skin;
}

}  // namespace markerless_mocap
