#include "studies/reproduce/bakken/bakken_film.h"

#include <algorithm>
#include <cmath>

#include "evaluation/label_error.h"
#include "studies/common/bakken_variants.h"
#include "tools/common/recording.h"
#include "tools/common/truth_record.h"

namespace markerless_mocap {
namespace {

RecordingOptions withMasks() {
  RecordingOptions options;
  options.use_masks = true;
  return options;
}

}  // namespace

JointTrack labelTruth(const Capture& capture) {
  return readTruth(capture.bag).joints.select(labelTruthNames());
}

JointTrack frameOf(const JointTrack& truth, size_t frame) {
  JointTrack one;
  one.names = truth.names;
  one.add(truth.stamps_ns[frame], truth.positions[frame]);
  return one;
}

PipelineOptions publishedBakkenOptions(int edge) {
  YAML::Node root = YAML::Load(publishedBakkenYaml());
  root["visual_hull"]["pitch"] = 2.0 / edge;
  return loadPipelineOptions(root);
}

HullOptions cubeAround(const JointTrack& truth, HullOptions options) {
  Eigen::Vector3d low = Eigen::Vector3d::Constant(1e9), high = -low;
  for (const Eigen::Matrix3Xd& points : truth.positions) {
    low = low.cwiseMin(points.rowwise().minCoeff());
    high = high.cwiseMax(points.rowwise().maxCoeff());
  }
  Eigen::Vector3d middle = 0.5 * (low + high);
  middle.z() = 0.0;
  options.volume_min += middle;
  options.volume_max += middle;
  return options;
}

CameraRig rigOf(const Capture& capture) {
  return Recording(capture.bag, withMasks()).rig();
}

void forEachFrame(const Capture& capture, const JointTrack& truth,
                  const std::function<void(size_t, const std::vector<HullView>&)>& visit) {
  Recording recording(capture.bag, withMasks());
  while (const std::optional<FrameSet> frame_set = recording.next()) {
    const auto stamp =
        std::lower_bound(truth.stamps_ns.begin(), truth.stamps_ns.end(), frame_set->stamp_ns);
    if (stamp == truth.stamps_ns.end() || *stamp != frame_set->stamp_ns) continue;
    std::vector<HullView> views;
    for (const CameraFrame& frame : frame_set->frames) views.push_back({frame.mask, {}});
    visit(size_t(stamp - truth.stamps_ns.begin()), views);
  }
}

}  // namespace markerless_mocap
