#include "studies/reproduce/fleischmann/fleischmann_paper.h"

#include <mutex>

#include "studies/reproduce/fleischmann/fleischmann_report.h"
#include "studies/reproduce/fleischmann/fleischmann_run.h"
#include "studies/reproduce/programs.h"

namespace markerless_mocap {
namespace {

constexpr double kSeconds = 7.5;  // 450 frames at 60 fps
constexpr double kQuickSeconds = 7.5;

/// Truth of a capture, found when it is first needed.
class SharedTruth {
 public:
  explicit SharedTruth(Capture capture) : capture_(std::move(capture)) {}
  const FilmTruth& get() {
    std::call_once(once_, [&] { truth_ = filmTruth(capture_); });
    return truth_;
  }

 private:
  Capture capture_;
  std::once_flag once_;
  FilmTruth truth_;
};

class FleischmannPaper : public Paper {
 public:
  explicit FleischmannPaper(ReproduceRequest request) : request_(std::move(request)) {}

  std::string title() const override {
    return "Fleischmann 2012: Particle Swarm Optimization with Soft Search Space Partitioning for "
           "Video-Based Markerless 3D Human Pose Tracking";
  }
  std::vector<Capture> captures() const override {
    return fleischmannCaptures(request_.quick ? kQuickSeconds : kSeconds);
  }
  std::vector<PaperRun> runs(const std::vector<Capture>& captures) const override;
  std::vector<Claim> report(const Results& results, Page* page) const override {
    return fleischmannReport(results, page);
  }

 private:
  ReproduceRequest request_;
};

std::vector<PaperRun> FleischmannPaper::runs(const std::vector<Capture>& captures) const {
  const std::string yaml = publishedFleischmannYaml();
  std::map<int, std::shared_ptr<SharedTruth>> truths;
  for (const int at : {0, 1}) truths[at] = std::make_shared<SharedTruth>(captures[size_t(at)]);
  std::vector<PaperRun> runs;
  for (const FleischmannVariant& variant : fleischmannVariants()) {
    const int at = variant.fps == 60 ? 0 : 1;
    const Capture& capture = captures[size_t(at)];
    for (int seed = 1; seed <= std::min(variant.runs, request_.seeds); ++seed) {
      PaperRun run;
      run.name = variant.id + "_seed" + std::to_string(seed);
      run.settings = {{"capture", captureSettings(capture)},
                      {"published", yaml},
                      {"changes", variant.changes},
                      {"exact", variant.exact},
                      {"seed", seed}};
      run.cost = variant.cost();
      run.work = [capture, variant, seed, truth = truths[at]] {
        return trackFilm(capture, truth->get(), variant, seed);
      };
      runs.push_back(std::move(run));
    }
  }
  return runs;
}

}  // namespace

std::vector<Capture> fleischmannCaptures(double seconds) {
  const Overrides common = {{"rig", "ring4"},
                            {"width", "644"},
                            {"height", "484"},
                            {"motion", "walk_in_circle"},
                            {"duration", std::to_string(seconds)},
                            {"background_frames", "0"},
                            {"mask_damage", "0.25"}};
  std::vector<Capture> captures{{"walk60", common}, {"walk20", common}};
  captures[0].studio.emplace_back("fps", "60");
  captures[1].studio.emplace_back("fps", "20");
  return captures;
}

std::unique_ptr<Paper> makeFleischmannPaper(const ReproduceRequest& request) {
  return std::make_unique<FleischmannPaper>(request);
}

}  // namespace markerless_mocap
