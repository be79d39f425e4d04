#include "studies/reproduce/fleischmann/fleischmann_paper.h"

#include <mutex>

#include "studies/reproduce/fleischmann/fleischmann_report.h"
#include "studies/reproduce/fleischmann/fleischmann_studies.h"
#include "studies/reproduce/programs.h"

namespace markerless_mocap {
namespace {

constexpr double kSeconds = 7.5;  // 450 frames at 60 fps
constexpr int kConvergenceFrames = 50;
constexpr int kQuickSlowRuns = 5;  // at 20 fps, for each one at 60

/// A capture with its truth, found when it is first needed.
class Film {
 public:
  explicit Film(Capture capture) : capture_(std::move(capture)) {}
  const Capture& capture() const { return capture_; }
  const FilmTruth& truth() {
    std::call_once(once_, [&] { truth_ = filmTruth(capture_); });
    return truth_;
  }

 private:
  Capture capture_;
  std::once_flag once_;
  FilmTruth truth_;
};

/// The films at 60 and 20 fps.
struct Films {
  std::shared_ptr<Film> fast, slow;
  const std::shared_ptr<Film>& of(int fps) const { return fps == 60 ? fast : slow; }
};

class FleischmannPaper : public Paper {
 public:
  explicit FleischmannPaper(ReproduceRequest request) : request_(std::move(request)) {}

  std::string title() const override {
    return "Fleischmann 2012: Particle Swarm Optimization with Soft Search Space Partitioning for "
           "Video-Based Markerless 3D Human Pose Tracking";
  }
  std::vector<Capture> captures() const override { return fleischmannCaptures(kSeconds); }
  std::vector<PaperRun> runs(const std::vector<Capture>& captures) const override;
  std::vector<Claim> report(const Results& results, Page* page) const override;

 private:
  int runsOf(const FleischmannVariant& variant) const;
  PaperRun trackRun(const FleischmannVariant& variant, int seed) const;
  PaperRun defaultRun(int fps) const;
  std::vector<PaperRun> studyRuns() const;

  ReproduceRequest request_;
  std::unique_ptr<Films> films_ = std::make_unique<Films>();
};

/// Tracks at 20 fps take a third of the time and differ much more between seeds.
int FleischmannPaper::runsOf(const FleischmannVariant& variant) const {
  const bool several = request_.quick && variant.fps == 20;
  return std::min(variant.runs, several ? kQuickSlowRuns * request_.seeds : request_.seeds);
}

Json settingsOf(const Film& film) {
  return {{"capture", captureSettings(film.capture())}, {"published", publishedFleischmannYaml()}};
}

PaperRun FleischmannPaper::trackRun(const FleischmannVariant& variant, int seed) const {
  const std::shared_ptr<Film> film = films_->of(variant.fps);
  PaperRun run;
  run.name = variant.id + "_seed" + std::to_string(seed);
  run.settings = settingsOf(*film);
  run.settings["changes"] = variant.changes;
  run.settings["exact"] = variant.exact;
  run.settings["seed"] = seed;
  run.cost = variant.cost();
  run.work = [film, variant, seed] {
    return trackFilm(film->capture(), film->truth(), variant, seed);
  };
  return run;
}

/// With the same silhouettes.
PaperRun FleischmannPaper::defaultRun(int fps) const {
  const OfflineStudy study{"default" + std::to_string(fps), "", {"--use-masks"}};
  PaperRun run =
      offlineRun(films_->of(fps)->capture(), study, (request_.folder / "cache").string());
  run.cost = 2000.0 * fps / 20.0;
  return run;
}

std::vector<PaperRun> FleischmannPaper::studyRuns() const {
  const std::shared_ptr<Film> fast = films_->fast, slow = films_->slow;
  std::vector<PaperRun> runs(3);
  runs[0] = {"curves", settingsOf(*fast),
             [fast] { return fitnessCurves(fast->capture(), fast->truth(), kCurveFrame); }, 100.0};
  runs[0].settings["frame"] = kCurveFrame;
  runs[1] = {
      "convergence", settingsOf(*slow),
      [slow] { return swarmConvergence(slow->capture(), slow->truth(), kConvergenceFrames); },
      400.0};
  runs[1].settings["frames"] = kConvergenceFrames;
  runs[2] = {"time", settingsOf(*fast),
             [fast] { return timeByPart(fast->capture(), fast->truth()); }, 200.0, true};
  return runs;
}

std::vector<PaperRun> FleischmannPaper::runs(const std::vector<Capture>& captures) const {
  *films_ = {std::make_shared<Film>(captures.at(0)), std::make_shared<Film>(captures.at(1))};
  std::vector<PaperRun> runs = studyRuns();
  for (const FleischmannVariant& variant : fleischmannVariants())
    for (int seed = 1; seed <= runsOf(variant); ++seed) runs.push_back(trackRun(variant, seed));
  for (const int fps : {60, 20}) runs.push_back(defaultRun(fps));
  return runs;
}

std::vector<Claim> FleischmannPaper::report(const Results& results, Page* page) const {
  page->text(
      "A walk of the virtual studio like the Lee walk: four cameras of 644 x 484, 450 frames "
      "at 60 fps or every third one, a circle, a standstill from 5.8 to 7.3 s; silhouettes "
      "with holes, specks and ragged edges. First pose and limb lengths are known. D is the "
      "mean error of fifteen joints (Eq. 4.4).");
  addFleischmannTables(results, page);
  addFleischmannFigures(results, {films_->fast->capture(), &films_->fast->truth()},
                        {films_->slow->capture(), &films_->slow->truth()}, page);
  return fleischmannClaims(results);
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
