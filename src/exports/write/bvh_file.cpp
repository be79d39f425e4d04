#include <limits>

#include "body/davenport_angles.h"
#include "exports/export_formats.h"
#include "exports/write/axes.h"
#include "exports/write/number_text.h"

namespace markerless_mocap {
namespace {

using Eigen::Vector3d;

constexpr double kDegrees = 180.0 / M_PI;

std::string vectorText(const Vector3d& v, int decimals) {
  return numberText(v.x(), decimals) + ' ' + numberText(v.y(), decimals) + ' ' +
         numberText(v.z(), decimals);
}

class Hierarchy {
 public:
  Hierarchy(const ExportSkeleton& skeleton, double units_per_metre)
      : skeleton_(skeleton), scale_(units_per_metre) {}

  std::string text() {
    out_ = "HIERARCHY\n";
    addJoint(0, "");
    return out_;
  }

 private:
  std::string offsetText(const Vector3d& offset) const {
    return "OFFSET " + vectorText(animationFromWorld() * offset * scale_, 6) + '\n';
  }

  void addJoint(size_t index, const std::string& indent) {
    const ExportJoint& joint = skeleton_[index];
    const bool root = joint.parent < 0;
    const Vector3d parent = root ? joint.rest : skeleton_[size_t(joint.parent)].rest;
    out_ += indent + (root ? "ROOT " : "JOINT ") + joint.name + '\n' + indent + "{\n";
    out_ += indent + '\t' + offsetText(joint.rest - parent);
    out_ += indent + "\tCHANNELS " + (root ? "6 Xposition Yposition Zposition" : "3") +
            " Yrotation Xrotation Zrotation\n";
    for (size_t child = index + 1; child < skeleton_.size(); ++child)
      if (skeleton_[child].parent == int(index)) addJoint(child, indent + '\t');
    if (joint.has_end)
      out_ += indent + "\tEnd Site\n" + indent + "\t{\n" + indent + "\t\t" +
              offsetText(joint.end - joint.rest) + indent + "\t}\n";
    out_ += indent + "}\n";
  }

  const ExportSkeleton& skeleton_;
  double scale_;
  std::string out_;
};

/// Joints in the order of the hierarchy: each after its parent, before its siblings.
void addInOrder(const ExportSkeleton& skeleton, size_t joint, std::vector<size_t>* order) {
  order->push_back(joint);
  for (size_t child = joint + 1; child < skeleton.size(); ++child)
    if (skeleton[child].parent == int(joint)) addInOrder(skeleton, child, order);
}

/// Angles about y, x and z in radians. Of the two solutions the one nearest to the last frame's:
/// programs interpolate angles.
Vector3d eulerAngles(const Eigen::Quaterniond& rotation, const Vector3d& last) {
  constexpr double kFree = std::numeric_limits<double>::max();
  const Eigen::Matrix3d R = turned(animationFromWorld(), rotation).toRotationMatrix();
  return davenportAngles(R, {Vector3d::UnitY(), Vector3d::UnitX(), Vector3d::UnitZ()}, last, -kFree,
                         kFree);
}

}  // namespace

std::string bvhOf(const PersonMotion& motion, const ExportSkeleton& skeleton,
                  double units_per_metre) {
  const std::vector<JointRotations> frames = jointRotations(motion, skeleton);
  std::string out = Hierarchy(skeleton, units_per_metre).text();
  out += "MOTION\nFrames: " + std::to_string(frames.size()) +
         "\nFrame Time: " + numberText(motion.frameTime(), 8) + '\n';
  std::vector<size_t> order;
  addInOrder(skeleton, 0, &order);
  std::vector<Vector3d> angles(skeleton.size(), Vector3d::Zero());
  for (const JointRotations& frame : frames) {
    out += vectorText(animationFromWorld() * frame.root * units_per_metre, 5);
    for (const size_t joint : order) {
      angles[joint] = eulerAngles(frame.R_parent[joint], angles[joint]);
      out += ' ' + vectorText(angles[joint] * kDegrees, 5);
    }
    out += '\n';
  }
  return out;
}

}  // namespace markerless_mocap
