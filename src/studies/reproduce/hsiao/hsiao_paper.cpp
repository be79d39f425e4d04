#include "studies/reproduce/hsiao/hsiao_paper.h"

#include "files/text_file.h"
#include "ros/package_files.h"
#include "studies/reproduce/hsiao/hsiao_figures.h"
#include "studies/reproduce/hsiao/hsiao_report.h"
#include "studies/reproduce/hsiao/hsiao_run.h"
#include "studies/reproduce/programs.h"

namespace markerless_mocap {
namespace {

/// Temporal swarm off: the last pose is too old in every frame.
const Overrides kBasicOnly = {{"pose_fitting/hsiao/max_pose_age", "0"}};

class HsiaoPaper : public Paper {
 public:
  explicit HsiaoPaper(const ReproduceRequest& request) : request_(request) {}

  std::string title() const override {
    return "Hsiao, Model-Based Pose Estimation for Multi-Camera Motion Capture System, 2008";
  }
  std::vector<Capture> captures() const override { return hsiaoCaptures(request_.quick); }
  std::vector<PaperRun> runs(const std::vector<Capture>& captures) const override;
  std::vector<Claim> report(const Results& results, Page* page) const override {
    addHsiaoTablesAndFigures(results, page);
    return hsiaoClaims(results);
  }

 private:
  ReproduceRequest request_;
};

/// What a result depends on.
Json settingsOf(const Capture& capture, const Overrides& changes) {
  Json settings{{"capture", captureSettings(capture)},
                {"config", readText(packageFile("config/as_published/hsiao.yaml"))}};
  for (const auto& [path, value] : changes) settings["changes"][path] = value;
  return settings;
}

/// The changes of all variants of the segmentation, by path.
Overrides variantChanges() {
  Overrides all;
  for (const PartVariant& variant : partVariants())
    for (const auto& [key, value] : variant.changes)
      all.emplace_back(variant.name + "/" + key, value);
  return all;
}

std::vector<PaperRun> HsiaoPaper::runs(const std::vector<Capture>& captures) const {
  std::vector<PaperRun> runs;
  const auto add = [&](const std::string& name, const Capture& capture, const Overrides& changes,
                       double cost, const std::function<Json()>& work) {
    runs.push_back({name, settingsOf(capture, changes), work, cost});
  };
  const std::string folder = (request_.folder / "cache").string();
  const size_t sequences = hsiaoSequences().size();
  for (size_t s = 0; s < sequences; ++s) {
    const Capture& capture = captures[s];
    for (int seed = 1; seed <= request_.seeds; ++seed) {
      const Overrides changes = {{"pose_fitting/hsiao/seed", std::to_string(seed)}};
      add(capture.name + "_published_seed" + std::to_string(seed), capture, changes, 3.0,
          [capture, changes, seed] { return trackSequence(capture, changes, seed == 1); });
    }
    add(capture.name + "_basic", capture, kBasicOnly, 2.0,
        [capture] { return trackSequence(capture, kBasicOnly, false); });
    add(capture.name + "_parts", capture, variantChanges(), 1.0,
        [capture] { return segmentSequence(capture); });
    runs.push_back(offlineRun(capture, {capture.name + "_default", "", {}}, folder));
  }
  const Capture& wave = captures[0];
  const Capture& overhead = captures[sequences];
  const Capture& laboratory = captures[sequences + 1];
  add("figures", wave, {}, 1.0, [wave] { return hullFigures(wave); });
  add("overhead", overhead, {}, 1.0, [overhead] { return hullVolume(overhead); });
  add("laboratory", laboratory, {}, 1.0, [laboratory] { return laboratoryFigure(laboratory); });
  add("plane", wave, {}, 0.2, [] { return planeFigures(); });
  return runs;
}

}  // namespace

std::unique_ptr<Paper> makeHsiaoPaper(const ReproduceRequest& request) {
  return std::make_unique<HsiaoPaper>(request);
}

}  // namespace markerless_mocap
