#include <sstream>

#include "fuzz_target.h"
#include "motion/bvh.h"
#include "motion/motion_script.h"
#include "motion/retarget.h"

using namespace markerless_mocap;

namespace {

constexpr size_t kMaxValues = 20000;  // of a BVH file: longer ones are slow, not different
constexpr double kMaxSeconds = 20.0;  // of a script

const HumanSkeleton& adult() {
  static const HumanSkeleton skeleton = HumanSkeleton::adult(1.75, 0.5);
  return skeleton;
}

void readBvhText(const std::string& text) {
  std::istringstream stream(text);
  const BvhMotion motion = readBvh(stream, "fuzz");
  if (motion.frames.size() * motion.joints.size() < kMaxValues) retarget(motion, adult(), "fuzz");
}

void readScript(const std::string& text) {
  const MotionScript script = parseMotionScript(text, "fuzz");
  if (script.seconds < kMaxSeconds) performMotion(script, adult(), 10.0);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const std::string text = textOf(data, size);
  refusesOrReads([&] { readBvhText(text); });
  refusesOrReads([&] { readScript(text); });
  return 0;
}
