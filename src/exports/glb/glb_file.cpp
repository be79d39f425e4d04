#include <cmath>

#include "exports/export_formats.h"
#include "exports/glb/glb_buffer.h"
#include "exports/skin/person_skin.h"
#include "exports/write/axes.h"

namespace markerless_mocap {
namespace {

using nlohmann::json;

constexpr int kVertices = 34962, kIndices = 34963;  // targets of buffer views

void appendVector(const Eigen::Vector3d& v, std::vector<float>* values) {
  for (int axis = 0; axis < 3; ++axis) values->push_back(float(v[axis]));
}

/// Nodes 0 to n-1 are the joints, n the mesh.
json nodesOf(const ExportSkeleton& skeleton, const std::string& id) {
  json nodes = json::array();
  for (size_t j = 0; j < skeleton.size(); ++j) {
    const ExportJoint& joint = skeleton[j];
    const Eigen::Vector3d parent =
        joint.parent < 0 ? Eigen::Vector3d::Zero() : skeleton[size_t(joint.parent)].rest;
    const Eigen::Vector3d offset = animationFromWorld() * (joint.rest - parent);
    nodes.push_back(
        {{"name", joint.name}, {"translation", json::array({offset.x(), offset.y(), offset.z()})}});
    if (joint.parent >= 0) nodes[size_t(joint.parent)]["children"].push_back(j);
  }
  nodes.push_back({{"name", id}, {"mesh", 0}, {"skin", 0}});
  return nodes;
}

json skinOf(const ExportSkeleton& skeleton, GlbBuffer* buffer) {
  json skin{{"skeleton", 0}};
  std::vector<float> matrices;
  for (size_t j = 0; j < skeleton.size(); ++j) {
    skin["joints"].push_back(j);
    Eigen::Matrix4f inverse = Eigen::Matrix4f::Identity();
    inverse.topRightCorner<3, 1>() = -(animationFromWorld() * skeleton[j].rest).cast<float>();
    matrices.insert(matrices.end(), inverse.data(), inverse.data() + 16);
  }
  skin["inverseBindMatrices"] = buffer->addFloats(matrices, 16, "MAT4");
  return skin;
}

/// glTF's colours of vertices are linear, ours are those of a screen.
float linear(float screen) {
  return screen <= 0.04045f ? screen / 12.92f : std::pow((screen + 0.055f) / 1.055f, 2.4f);
}

json meshOf(const PersonSkin& skin, GlbBuffer* buffer) {
  std::vector<float> places, normals, colors;
  for (size_t v = 0; v < skin.mesh.vertices.size(); ++v) {
    appendVector(animationFromWorld() * skin.mesh.vertices[v].cast<double>(), &places);
    appendVector(animationFromWorld() * skin.normals[v].cast<double>(), &normals);
    appendVector(skin.mesh.colors[v].unaryExpr(&linear).cast<double>(), &colors);
  }
  const size_t count = skin.mesh.vertices.size();
  const json attributes{{"POSITION", buffer->addBounded(places, 3, "VEC3", kVertices)},
                        {"NORMAL", buffer->addFloats(normals, 3, "VEC3", kVertices)},
                        {"COLOR_0", buffer->addFloats(colors, 3, "VEC3", kVertices)},
                        {"JOINTS_0", buffer->add(skin.joints.data(), 4 * count, count,
                                                 GlbBuffer::kByte, "VEC4", kVertices)},
                        {"WEIGHTS_0", buffer->add(skin.weights.data(), 16 * count, count,
                                                  GlbBuffer::kFloat, "VEC4", kVertices)}};
  const auto& triangles = skin.mesh.triangles;  // the axes are turned, not mirrored
  const int indices = buffer->add(triangles.data(), 12 * triangles.size(), 3 * triangles.size(),
                                  GlbBuffer::kUint, "SCALAR", kIndices);
  const json primitive{{"attributes", attributes}, {"indices", indices}, {"material", 0}};
  return {{"primitives", json::array({primitive})}};
}

class Animation {
 public:
  Animation(const PersonMotion& motion, GlbBuffer* buffer) : buffer_(buffer) {
    std::vector<float> times;
    for (size_t f = 0; f < motion.frames.size(); ++f) times.push_back(float(motion.seconds(f)));
    times_ = buffer->addBounded(times, 1, "SCALAR");
  }
  void add(size_t node, const char* path, int values) {
    json_["channels"].push_back(
        {{"sampler", json_["samplers"].size()}, {"target", {{"node", node}, {"path", path}}}});
    json_["samplers"].push_back({{"input", times_}, {"output", values}});
  }
  json all(const std::vector<JointRotations>& frames) {
    std::vector<float> roots;
    for (const JointRotations& frame : frames)
      appendVector(animationFromWorld() * frame.root, &roots);
    add(0, "translation", buffer_->addFloats(roots, 3, "VEC3"));
    for (size_t j = 0; j < frames[0].R_parent.size(); ++j) {
      std::vector<float> turns;
      Eigen::Quaterniond last = Eigen::Quaterniond::Identity();
      for (const JointRotations& frame : frames) {
        Eigen::Quaterniond turn = turned(animationFromWorld(), frame.R_parent[j]).normalized();
        if (turn.dot(last) < 0) turn.coeffs() = -turn.coeffs();
        last = turn;
        for (const double value : turn.coeffs()) turns.push_back(float(value));
      }
      add(j, "rotation", buffer_->addFloats(turns, 4, "VEC4"));
    }
    return json_;
  }

 private:
  GlbBuffer* buffer_;
  json json_{{"name", "motion"}, {"samplers", json::array()}, {"channels", json::array()}};
  int times_ = 0;
};

/// What glTF has no place for: where joints were not seen.
json extrasOf(const PersonMotion& motion, const ExportSkeleton& skeleton) {
  json gaps = json::array();
  for (const JointGap& gap : jointGaps(motion, skeleton))
    gaps.push_back({{"joint", gap.joint},
                    {"from_s", motion.seconds(gap.first)},
                    {"to_s", motion.seconds(gap.last)},
                    {"state", gap.filled ? "filled" : "not seen, held"}});
  return {{"gaps", gaps}, {"filled_up_to_s", motion.fill_s}};
}

}  // namespace

std::string glbOf(const PersonMotion& motion, const ExportSkeleton& skeleton) {
  GlbBuffer buffer;
  json out{{"asset", {{"version", "2.0"}, {"generator", "markerless_mocap"}}}, {"scene", 0}};
  out["asset"]["extras"] = extrasOf(motion, skeleton);
  out["scenes"] = json::array({json{{"nodes", json::array({0, skeleton.size()})}}});
  out["nodes"] = nodesOf(skeleton, motion.body->id());
  out["skins"] = json::array({skinOf(skeleton, &buffer)});
  out["meshes"] = json::array({meshOf(personSkin(*motion.body, skeleton), &buffer)});
  const json cloth{{"metallicFactor", 0}, {"roughnessFactor", 0.9}};
  out["materials"] = json::array({json{{"name", "clothes"}, {"pbrMetallicRoughness", cloth}}});
  const json animation = Animation(motion, &buffer).all(jointRotations(motion, skeleton));
  out["animations"] = json::array({animation});
  return buffer.file(out);
}

}  // namespace markerless_mocap
