#include "studies/reproduce/bakken/bakken_paper.h"

#include "studies/reproduce/bakken/bakken_correspondence.h"
#include "studies/reproduce/bakken/bakken_film.h"
#include "studies/reproduce/bakken/bakken_pictures.h"
#include "studies/reproduce/bakken/bakken_report.h"
#include "studies/reproduce/bakken/bakken_run.h"
#include "studies/reproduce/programs.h"

namespace markerless_mocap {
namespace {

/// A capture, the section of the paper that it stands for, and its length.
struct Scene {
  const char *name, *motion, *start, *rig;
  int frames, quick_frames;
  int fps;
};

// The dance has 451 frames in the paper, those of i3DPost 57, 46, 108 and 150.
constexpr Scene kScenes[] = {{"whirl", "whirling_dance", "0", "ring7_overhead", 451, 150, 30},
                             {"walk", "walk", "1", "ring8", 57, 0, 25},
                             {"walk_spin", "walk_spin", "1", "ring8", 46, 46, 25},
                             {"run_crouch_jump", "run_crouch_jump", "0.5", "ring8", 108, 0, 25},
                             {"ballet", "whirling_dance", "2", "ring8", 150, 0, 25}};

/// Other people, motions and rigs, none of which a learned model was fitted to.
struct OtherPerson {
  const char *name, *motion, *rig, *stature, *male, *clothes;
};
constexpr OtherPerson kOthers[] = {
    {"people_walk", "walk", "ring8", "1.79", "1", "loose"},
    {"people_wave", "wave_and_walk", "random8", "1.57", "0", "tight"},
    {"people_hips", "hands_on_hips", "ring7_overhead", "1.70", "0.2", "skirt"},
    {"people_swing", "swing", "ring8", "1.86", "0.9", "tight"},
    {"people_throw", "throw", "ring7_overhead", "1.66", "0.1", "loose"},
    {"people_stroll", "stroll_arms_down", "ring8", "1.74", "0.6", "tight"},
    {"people_circle", "walk_in_circle", "ring4", "1.82", "0.8", "loose"},
    {"people_crouch", "run_crouch_jump", "ring4", "1.61", "0", "tight"}};

bool isOther(const Capture& capture) {
  return capture.name.rfind("people_", 0) == 0;
}

Capture captureOf(const OtherPerson& person) {
  return {person.name,
          {{"motion", person.motion},
           {"rig", person.rig},
           {"stature", person.stature},
           {"male", person.male},
           {"clothes", person.clothes},
           {"appearance_seed", "77"},
           {"fps", "5"},
           {"duration", "8"},
           {"background_frames", "0"}}};
}

class BakkenPaper : public Paper {
 public:
  explicit BakkenPaper(ReproduceRequest request) : request_(std::move(request)) {}

  std::string title() const override {
    return "Bakken and Hilton 2012: Real-time Pose Estimation using Tree Structures Built from "
           "Skeletonised Volume Sequences";
  }
  std::vector<Capture> captures() const override;
  std::vector<PaperRun> runs(const std::vector<Capture>& captures) const override;
  std::vector<Claim> report(const Results& results, Page* page) const override {
    return bakkenReport(results, page);
  }

 private:
  std::vector<PaperRun> runsOf(const Capture& capture, int edge) const;
  ReproduceRequest request_;
};

std::vector<Capture> BakkenPaper::captures() const {
  std::vector<Capture> captures;
  for (const Scene& scene : kScenes) {
    const int frames = request_.quick ? scene.quick_frames : scene.frames;
    if (frames == 0) continue;
    captures.push_back({scene.name,
                        {{"motion", scene.motion},
                         {"motion_start", scene.start},
                         {"rig", scene.rig},
                         {"width", "800"},
                         {"height", "600"},
                         {"fps", std::to_string(scene.fps)},
                         {"duration", std::to_string(double(frames) / scene.fps)},
                         {"background_frames", "30"},
                         {"stature", "1.62"},
                         {"male", "0.1"}}});
  }
  if (!request_.quick)
    for (const OtherPerson& person : kOthers) captures.push_back(captureOf(person));
  return captures;
}

std::vector<PaperRun> BakkenPaper::runsOf(const Capture& capture, int edge) const {
  const std::string suffix = capture.name + "_" + std::to_string(edge);
  Json settings{
      {"capture", captureSettings(capture)}, {"published", publishedBakkenYaml()}, {"edge", edge}};
  const Volume volume = isOther(capture) ? Volume::kStudio : Volume::kCube;
  Json labelling = settings;
  if (volume == Volume::kStudio) labelling["volume"] = "studio";
  for (const BakkenVariant& variant : bakkenVariants())
    labelling["variants"][variant.id] = {variant.changes, variant.product};
  Json following = settings;
  following["measures"] = {"exchanged", "astray"};
  return {{"labels_" + suffix, labelling, [=] { return labelCapture(capture, edge, volume); },
           edge == 64 ? 1.0 : 2.0},
          {"times_" + suffix, settings, [=] { return timeCapture(capture, edge); }, 1.0, true},
          {"trees_" + suffix, settings, [=] { return drawTrees(capture, edge); }, 0.5},
          {"follow_" + suffix, following, [=] { return followLabels(capture, edge); }, 0.5}};
}

std::vector<PaperRun> BakkenPaper::runs(const std::vector<Capture>& captures) const {
  std::vector<PaperRun> runs;
  for (const Capture& capture : captures) {
    const bool other = isOther(capture);
    for (const int edge : {64, 128})
      for (PaperRun& run : runsOf(capture, edge))
        if (!other || run.name.rfind("labels_", 0) == 0) runs.push_back(std::move(run));
    if (other) continue;
    PaperRun beside = offlineRun(capture, {"default_" + capture.name, "", {}},
                                 (request_.folder / "cache").string());
    beside.cost = 4.0;
    runs.push_back(std::move(beside));
  }
  return runs;
}

}  // namespace

std::unique_ptr<Paper> makeBakkenPaper(const ReproduceRequest& request) {
  return std::make_unique<BakkenPaper>(request);
}

}  // namespace markerless_mocap
