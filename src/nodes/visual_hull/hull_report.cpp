// What HullStage says of the hulls and cameras.
#include <algorithm>

#include "camera/timing_remarks.h"
#include "nodes/visual_hull/hull_stage.h"
#include "ros/image_conversions.h"

namespace markerless_mocap {
namespace {

/// For example "hull of 2000 voxels without camera 'a': its mask is full; 2 components are suspect
/// ghosts".
std::string messageFor(const VisualHull& hull) {
  std::string message = "hull of " + std::to_string(hull.voxels.size()) + " voxels";
  for (const LeftOutCamera& camera : hull.cameras_left_out)
    message += " without camera '" + camera.name + "': " + camera.reason + ";";
  if (!hull.cameras_left_out.empty()) message.pop_back();
  const auto ghosts = std::count_if(hull.components.begin(), hull.components.end(),
                                    [](const HullComponent& c) { return c.suspect_ghost; });
  if (ghosts > 0) message += "; " + std::to_string(ghosts) + " components are suspect ghosts";
  return message;
}

}  // namespace

void HullStage::publishCameras(const MaskSet& frame_set, const VisualHull& hull,
                               const std_msgs::Header& header) {
  HullCameras message;
  message.header = header;
  message.cameras = node_options_.cameras;
  for (size_t i = 0; i < message.cameras.size(); ++i) {
    const bool present = frame_set.present[i];
    message.usable.push_back(true);  // others may have got its mask
    message.reasons.push_back(present ? "" : missRemark(message.cameras[i], mask_sets_.timing(i)));
  }
  for (const LeftOutCamera& camera : hull.cameras_left_out) {
    const auto at = std::find(message.cameras.begin(), message.cameras.end(), camera.name) -
                    message.cameras.begin();
    // Where too little is known, fitting goes by the colours.
    const sensor_msgs::ImageConstPtr& mask = frame_set.items[size_t(at)];
    const bool by_color = mask && hasUnknownBackground(*mask) && doubtOf(size_t(at)).empty();
    if (!by_color) message.usable[size_t(at)] = false;
    message.reasons[size_t(at)] = camera.reason;
    if (by_color && node_options_.privacy)
      message.reasons[size_t(at)] +=
          "; with privacy its colours are not read, and only what its mask knows is used";
  }
  cameras_.publish(message);
  display_.note(message, frame_set.present);
}

std::string HullStage::stepOfCameras() const {
  return stepRemark(mask_sets_.tolerance(), node_options_.stamp_tolerance);
}

std::string HullStage::timingRemarks(const MaskSet& frame_set) const {
  const bool in_step = stepOfCameras().empty();
  std::string remarks;
  for (size_t i = 0; i < frame_set.present.size(); ++i) {
    const std::string& camera = node_options_.cameras[i];
    const StreamTiming timing = mask_sets_.timing(i);
    std::string remark;
    if (!frame_set.present[i])
      remark = missRemark(camera, timing);
    else if (in_step)
      remark = lagRemark(camera, timing, mask_sets_.options());
    if (!remark.empty()) remarks += "; " + remark;
  }
  return remarks;
}

void HullStage::reportHull(const VisualHull& hull, const std::string& timing) {
  const bool in_step = stepOfCameras().empty();
  for (const LeftOutCamera& camera : hull.cameras_left_out)
    status_.count("frame sets without camera " + camera.name);
  if (hull.status != HullStatus::kOk)
    status_.problem(hull.reason);
  else if (hull.cameras_left_out.empty() && !hull.components[0].suspect_ghost && timing.empty())
    status_.ok(messageFor(hull) + (in_step ? "" : "; " + stepOfCameras()));
  else
    status_.waiting(messageFor(hull) + timing);
}

void HullStage::reportCounts() {
  const AssemblerCounts& counts = mask_sets_.counts();
  status_.set("complete frame sets", counts.complete);
  status_.set("incomplete frame sets", counts.incomplete);
  status_.set("abandoned frame sets", counts.abandoned);
  status_.set("duplicate masks", counts.duplicate);
  status_.set("late masks", counts.late);
  status_.set("masks far in the future", counts.far_future);
  status_.set("frame sets closed early, as too many waited", counts.overflow);
  status_.set("time went back", counts.time_jumps_back);
  for (size_t i = 0; i < node_options_.cameras.size(); ++i)
    status_.set("frame sets without the mask of " + node_options_.cameras[i],
                mask_sets_.timing(i).left_out);
}

}  // namespace markerless_mocap
