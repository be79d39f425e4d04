#include "studies/reproduce/hsiao/hsiao_film.h"

#include <sstream>

#include "capture/ground_truth.h"
#include "capture/virtual_studio.h"
#include "files/text_file.h"
#include "resources/resources.h"
#include "ros/package_files.h"
#include "tools/common/studio_settings.h"

namespace markerless_mocap {
namespace {

constexpr int kTiny = 16;                          // pixels; the images are not used
constexpr int64_t kFirstStamp = 1000'000'000'000;  // of render_capture, nanoseconds
constexpr double kRate = 30.0, kQuickRate = 10.0;  // frames per second
constexpr int kQuickFrames = 24;
constexpr int kBackgroundFrames = 20;

Overrides studioOf(const std::string& motion, const std::string& rig, double start, int frames,
                   double rate) {
  const auto text = [](double value) {
    std::ostringstream out;
    out << value;
    return out.str();
  };
  return {{"motion", motion},
          {"rig", rig},
          {"width", "320"},
          {"height", "240"},
          {"fps", text(rate)},
          {"motion_start", text(start)},
          {"duration", text(frames / rate)},
          {"background_frames", std::to_string(kBackgroundFrames)},
          {"noise_stddev", "2"}};
}

YAML::Node published() {
  return YAML::Load(readText(packageFile("config/as_published/hsiao.yaml")));
}

/// Sets the value at a path such as "a/b/c".
void setAt(YAML::Node node, const std::string& path, const std::string& value) {
  const size_t slash = path.find('/');
  if (slash == std::string::npos)
    node[path] = value;
  else
    setAt(node[path.substr(0, slash)], path.substr(slash + 1), value);
}

}  // namespace

const std::vector<HsiaoSequence>& hsiaoSequences() {
  static const std::string kAround = "ring8", kOverhead = "ring7_overhead";
  static const std::vector<HsiaoSequence> kSequences = {
      {"s1", "Wave_SMG1", 38, kAround, "wave", 1.0},
      {"s2", "swing", 168, kAround, "swing", 1.0},
      {"s3", "ThrowItem", 400, kOverhead, "throw", 2.0},
      {"s4", "MeleeAttack01", 190, kOverhead, "melee", 1.0},
      {"s5", "sitcouch1", 170, kOverhead, "sit_couch", 1.0},
      {"s6", "d1_t03_Tenements_Look_Out_Door_Close", 780, kOverhead, "look_out_door", 2.0},
      {"s7", "luggagepush", 645, kOverhead, "push_luggage", 2.0},
      {"s8", "walk_all", 305, kOverhead, "walk", 1.0},
      {"s9", "d3_c17_03_throw_from_tower", 1110, kOverhead, "lift_drop", 2.0}};
  return kSequences;
}

std::vector<Capture> hsiaoCaptures(bool quick) {
  std::vector<Capture> captures;
  const auto add = [&](const std::string& name, const HsiaoSequence& like, const std::string& rig) {
    captures.push_back(
        {name, studioOf(like.motion, rig, quick ? like.start : 0.0,
                        quick ? kQuickFrames : like.frames, quick ? kQuickRate : kRate)});
  };
  for (const HsiaoSequence& sequence : hsiaoSequences()) add(sequence.id, sequence, sequence.rig);
  const HsiaoSequence& wave = hsiaoSequences().front();
  add("s1_overhead", wave, "ring7_overhead");
  add("laboratory", wave, "ceiling4");
  captures.back().studio.emplace_back("calibration_error_px", "4");
  return captures;
}

HsiaoTruth hsiaoTruth(const Capture& capture) {
  StudioOptions studio = readStudioOptions("", capture.studio);
  studio.width = studio.height = kTiny;
  const VirtualStudio stage(studio, {humanUrdfTemplate(), packageFile("config/motions")},
                            "person1");
  HsiaoTruth truth;
  truth.stature = stage.stature();
  truth.points.names = groundTruthNames();
  for (int i = studio.background_frames; i < stage.frameSetCount(); ++i) {
    const StudioFrameSet now = stage.render(i);
    Eigen::Matrix3Xd points(3, Eigen::Index(now.points.size()));
    for (size_t p = 0; p < now.points.size(); ++p) points.col(Eigen::Index(p)) = now.points[p];
    truth.points.add(kFirstStamp + now.time_ns, points);
  }
  return truth;
}

PipelineOptions publishedHsiao(double stature, const Overrides& changes) {
  YAML::Node root = published();
  root["silhouette"]["background_frames"] = kBackgroundFrames;
  root["pose_fitting"]["stature"] = stature;
  for (const auto& [path, value] : changes) setAt(root, path, value);
  return loadPipelineOptions(root);
}

HsiaoFilm::HsiaoFilm(const Capture& capture, const HsiaoTruth& truth, const Overrides& changes)
    : recording_(capture.bag, RecordingOptions()),
      first_stamp_(truth.points.stamps_ns.front()),
      options_(publishedHsiao(truth.stature, changes)),
      pipeline_(recording_.rig(), PersonResources::standard(), options_) {}

std::optional<PipelineResult> HsiaoFilm::next() {
  while (std::optional<FrameSet> frame_set = recording_.next()) {
    frame_set_ = std::move(*frame_set);
    PipelineResult result = pipeline_.process(frame_set_.stamp_ns, frame_set_.frames);
    if (!result.learning && frame_set_.stamp_ns >= first_stamp_) return result;
  }
  return std::nullopt;
}

}  // namespace markerless_mocap
