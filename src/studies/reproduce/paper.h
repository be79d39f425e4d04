#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "pages/page.h"
#include "tools/common/studio_settings.h"

namespace markerless_mocap {

/// What is asked for.
struct ReproduceRequest {
  std::filesystem::path folder;  ///< of index.html; what has been done is kept in its cache/
  bool quick = false;            ///< minutes in place of hours: shorter captures, fewer seeds
  int seeds = 5;                 ///< runs of each random method, with the seeds 1, 2, ...
};

/// A film of the virtual studio, as render_capture makes it: JPEG images, silhouettes with
/// mask_damage, the truth. It is rendered once into the cache.
struct Capture {
  std::string name;      ///< of letters, digits, _ and -
  Overrides studio;      ///< options of the virtual studio
  std::string bag = "";  ///< set before runs() is called
};

/// One piece of work. Its result is kept in the cache and used again as long as the settings are
/// the same.
struct PaperRun {
  std::string name;  ///< unique in the paper; of letters, digits, _ and -
  Json settings;     ///< everything on which the result depends, captures by captureSettings()
  /// Runs share no state but what is constant. Two are executed at the same time, each with one
  /// thread. What is thrown ends the program after the other runs.
  std::function<Json()> work;
  double cost = 1.0;   ///< expected duration relative to other runs, for the remaining time
  bool alone = false;  ///< nothing else is executed at the same time: for durations
};

/// Results by the name of their run.
using Results = std::map<std::string, Json>;

enum class Verdict { kHolds, kHoldsPartly, kDoesNotHold, kNotMeasured };
const char* verdictName(Verdict verdict);

/// A sentence of a paper, and what is measured here.
struct Claim {
  std::string place;     ///< page, table or figure of the paper
  std::string sentence;  ///< what it says, with its figures
  std::string ours;      ///< our figures
  Verdict verdict = Verdict::kNotMeasured;
};

/// The experiments of one paper.
class Paper {
 public:
  virtual ~Paper() = default;
  /// Author, title, year.
  virtual std::string title() const = 0;
  virtual std::vector<Capture> captures() const = 0;
  /// \param captures those of captures(), rendered
  virtual std::vector<PaperRun> runs(const std::vector<Capture>& captures) const = 0;
  /// Adds the paper's tables and figures under its own numbers. \return its claims
  virtual std::vector<Claim> report(const Results& results, Page* page) const = 0;
};

/// The name in a command, and its maker.
using PaperMaker = std::function<std::unique_ptr<Paper>(const ReproduceRequest&)>;
const std::map<std::string, PaperMaker>& papers();

}  // namespace markerless_mocap
