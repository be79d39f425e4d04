#include "tools/common/player.h"

#include <cmath>

#include "ros/pose_conversions.h"
#include "tools/common/number_format.h"

namespace markerless_mocap {
namespace {

constexpr double kSameLoss_s = 0.2;  // losses of a part that are closer count as one
constexpr size_t kMaxEvents = 500;
constexpr size_t kParts = 6;
// In the order of ResultFrame::part_sigma_m.
constexpr const char* kEndLinks[kParts] = {"torso",   "head",    "l_wrist",
                                           "r_wrist", "l_ankle", "r_ankle"};

bool isPose(const ResultFrame& frame) {
  return !frame.T_world_link.empty();
}

/// x y z, then the quaternion x y z w.
void append(const Eigen::Isometry3d& T, std::vector<float>* out) {
  const Eigen::Quaterniond q(T.linear());
  for (const double value : {T(0, 3), T(1, 3), T(2, 3), q.x(), q.y(), q.z(), q.w()})
    out->push_back(float(value));
}

std::string packedPoses(const PlayerContent& content) {
  std::vector<float> poses;
  const size_t links = content.body->links().size();
  for (const ResultFrame& frame : *content.frames)
    if (isPose(frame))
      for (const Eigen::Isometry3d& T : frame.T_world_link) append(T, &poses);
    else
      poses.insert(poses.end(), 7 * links, float(NAN));
  return packed(poses);
}

Json coneJson(const RoundCone& cone) {
  return {{"link", cone.link},
          {"a", {cone.a.x(), cone.a.y(), cone.a.z()}},
          {"b", {cone.b.x(), cone.b.y(), cone.b.z()}},
          {"radii", {cone.radius_a, cone.radius_b}},
          {"color", {cone.rgb.x(), cone.rgb.y(), cone.rgb.z()}}};
}

Json bodyJson(const PlayerContent& content) {
  Json parents = Json::array({-1}), cones = Json::array();
  for (const BodyJoint& joint : content.body->joints()) parents.push_back(joint.parent_link);
  if (content.shape_known)
    for (const RoundCone& cone : content.body->shape()) cones.push_back(coneJson(cone));
  return {{"parents", parents}, {"cones", cones}, {"poses", packedPoses(content)}};
}

Json cameraJson(const Camera& camera) {
  const CameraCalibration& c = camera.calibration();
  std::vector<float> place;
  append(c.T_world_camera, &place);
  return {{"name", camera.name()},
          {"place", place},
          {"tangents", {0.5 * c.width / c.K(0, 0), 0.5 * c.height / c.K(1, 1)}}};
}

Json statusRuns(const std::vector<ResultFrame>& frames) {
  std::vector<BandCell> cells;
  for (const ResultFrame& frame : frames) cells.push_back({size_t(frame.status), frame.reason});
  return joinedCells(cells);
}

/// Runs of frames for which something holds, as events; runs that are close count as one.
template <class Holds>
void addRuns(const std::vector<ResultFrame>& frames, const std::string& what, const Holds& holds,
             std::vector<Json>* events) {
  size_t next = 0;
  bool any = false;
  for (size_t f = 0; f < frames.size(); ++f) {
    if (!holds(frames[f])) continue;
    const bool same =
        any && double(frames[f].stamp_ns - frames[next - 1].stamp_ns) * 1e-9 < kSameLoss_s;
    if (!same) events->push_back({{"frame", f}, {"frames", 0}, {"what", what}, {"why", ""}});
    Json& event = events->back();
    event["frames"] = f + 1 - event["frame"].get<size_t>();
    if (event["why"] == "") event["why"] = frames[f].reason;
    next = f + 1;
    any = true;
  }
}

Json eventsOf(const PlayerContent& content) {
  std::vector<Json> events = content.events;
  const std::vector<ResultFrame>& frames = *content.frames;
  addRuns(
      frames, "no pose", [](const ResultFrame& f) { return !isPose(f); }, &events);
  for (size_t part = 0; part < kParts; ++part) {
    const auto link = size_t(content.body->linkIndex(kEndLinks[part]));
    const auto unseen = [&](const ResultFrame& f) {
      return isPose(f) && !f.T_world_link[link].matrix().allFinite();
    };
    addRuns(frames, std::string(sidedPartName(PartLabel(part))) + " not seen", unseen, &events);
  }
  std::stable_sort(events.begin(), events.end(),
                   [](const Json& a, const Json& b) { return a["frame"] < b["frame"]; });
  if (events.size() > kMaxEvents) events.resize(kMaxEvents);
  return events;
}

/// Pairs of markerNames() and tipNames() with a bone between them.
Json truthJson(const JointTrack& truth) {
  static const std::vector<std::pair<std::string, std::string>> kBones = [] {
    std::vector<std::pair<std::string, std::string>> bones{{"pelvis", "thorax"},
                                                           {"thorax", "head"}};
    bones.push_back({"head", "head_top"});
    for (const std::string side : {"l_", "r_"})
      for (const auto& [from, to] :
           std::vector<std::pair<std::string, std::string>>{{"thorax", side + "shoulder"},
                                                            {side + "shoulder", side + "elbow"},
                                                            {side + "elbow", side + "wrist"},
                                                            {side + "wrist", side + "hand"},
                                                            {"pelvis", side + "hip"},
                                                            {side + "hip", side + "knee"},
                                                            {side + "knee", side + "ankle"},
                                                            {side + "ankle", side + "foot"}})
        bones.push_back({from, to});
    return bones;
  }();
  Json bones = Json::array();
  for (const auto& [from, to] : kBones)
    if (truth.indexOf(from) >= 0 && truth.indexOf(to) >= 0)
      bones.push_back({truth.indexOf(from), truth.indexOf(to)});
  std::vector<float> points;
  for (const Eigen::Matrix3Xd& frame : truth.positions)
    points.insert(points.end(), frame.data(), frame.data() + frame.size());
  return {{"bones", bones}, {"count", truth.names.size()}, {"points", packed(points)}};
}

}  // namespace

const std::vector<BandState>& frameStates() {
  static const std::vector<BandState> states{{toString(FrameStatus::kMissing), "#b9bec4"},
                                             {toString(FrameStatus::kLost), "#c0392b"},
                                             {toString(FrameStatus::kTracked), "#2a9d5c"},
                                             {toString(FrameStatus::kReinitialized), "#e0a020"}};
  return states;
}

std::vector<double> secondsOf(const std::vector<ResultFrame>& frames) {
  std::vector<double> seconds;
  for (const ResultFrame& frame : frames)
    seconds.push_back(double(frame.stamp_ns - frames.front().stamp_ns) * 1e-9);
  return seconds;
}

Json playerPart(const PlayerContent& content) {
  const std::vector<ResultFrame>& frames = *content.frames;
  Json states = Json::array(), cameras = Json::array();
  for (const BandState& state : frameStates())
    states.push_back({{"name", state.name}, {"color", state.color}});
  if (content.rig)
    for (const Camera& camera : *content.rig) cameras.push_back(cameraJson(camera));
  return {{"kind", "player"},
          {"start", frames.empty() ? "" : formatNumber("%.3f", 1e-9 * frames[0].stamp_ns)},
          {"seconds", packed(secondsOf(frames))},
          {"states", states},
          {"status", statusRuns(frames)},
          {"events", eventsOf(content)},
          {"body", bodyJson(content)},
          {"cameras", cameras},
          {"hulls", content.hulls ? content.hulls->json() : Json::array()},
          {"views", content.views ? content.views->json() : Json::array()},
          {"truth", content.truth ? truthJson(*content.truth) : Json()}};
}

}  // namespace markerless_mocap
