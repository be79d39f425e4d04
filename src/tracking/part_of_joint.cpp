#include "tracking/part_of_joint.h"

namespace markerless_mocap {
namespace {

bool contains(const std::string& text, const char* word) {
  return text.find(word) != std::string::npos;
}

}  // namespace

PartLabel partOfJoint(const std::string& base_name) {
  if (contains(base_name, "head")) return PartLabel::kHead;
  const bool left = base_name.rfind("l_", 0) == 0;
  for (const char* word : {"clavicle", "shoulder", "elbow", "wrist", "hand"})
    if (contains(base_name, word)) return left ? PartLabel::kArm1 : PartLabel::kArm2;
  for (const char* word : {"hip", "knee", "ankle", "foot"})
    if (contains(base_name, word)) return left ? PartLabel::kLeg1 : PartLabel::kLeg2;
  return PartLabel::kTorso;
}

PartLabel partOfLink(const BodyModel& model, int link) {
  if (link == 0) return PartLabel::kTorso;
  const std::string& joint = model.joints()[size_t(link - 1)].name;
  return partOfJoint(joint.substr(0, joint.size() - model.id().size() - 1));
}

}  // namespace markerless_mocap
