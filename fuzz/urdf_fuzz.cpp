#include "fuzz_target.h"
#include "markerless_mocap/body/body_model.h"
#include "markerless_mocap/body/body_urdf.h"
#include "resources/resources.h"

using namespace markerless_mocap;

namespace {

const BodyProportions kAdult = BodyProportions::fromStature(1.75);

void useBody(const std::string& urdf) {
  const BodyModel body = BodyModel::fromUrdf(urdf, "a");
  LinkPoses poses;
  body.forwardKinematics(Eigen::Isometry3d::Identity(), Eigen::VectorXd::Zero(body.angleCount()),
                         poses);
}

// The template with the input in place of one of its expressions: most texts are no URDF at all.
std::string inTemplate(const std::string& text) {
  const std::string replaced = "${0.3 * torso}";
  std::string urdf = humanUrdfTemplate();
  return urdf.replace(urdf.find(replaced), replaced.size(), "${" + text + "}");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const std::string text = textOf(data, size);
  refusesOrReads([&] { useBody(text); });
  refusesOrReads([&] { useBody(fillUrdfTemplate(text, "a", kAdult)); });
  if (size < 200) refusesOrReads([&] { useBody(fillUrdfTemplate(inTemplate(text), "a", kAdult)); });
  return 0;
}
