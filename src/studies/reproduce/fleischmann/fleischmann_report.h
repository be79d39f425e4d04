#pragma once

#include "studies/reproduce/fleischmann/fleischmann_film.h"
#include "studies/reproduce/paper.h"

namespace markerless_mocap {

/// The results of one variant over its seeds.
class VariantResults {
 public:
  VariantResults(const Results& results, const std::string& variant);

  size_t runs() const { return D_.size(); }
  double mean() const;       ///< Eq. 4.5 over all runs, mm
  double max() const;        ///< Eq. 4.6 over all runs, mm
  double medianMax() const;  ///< median over the runs of their maximum, mm
  /// Mean over all runs of the frames in an interval of seconds, mm.
  double meanWithin(double from, double to) const;
  /// D of each frame, mm: mean, maximum over the runs, and of one run.
  std::vector<double> meanOverRuns() const;
  std::vector<double> maxOverRuns() const;
  const std::vector<double>& D(size_t run) const { return D_.at(run); }
  const std::vector<double>& seconds() const { return seconds_; }
  const Json& json(size_t run) const { return *json_.at(run); }

 private:
  std::vector<const Json*> json_;
  std::vector<std::vector<double>> D_;
  std::vector<double> seconds_;
};

/// A length in mm with one decimal; "-" if it is not finite.
std::string mm(double value);

/// What the pictures are made of.
struct FilmSource {
  Capture capture;
  const FilmTruth* truth;
};

/// The tables and error graphs of chapter 6, with the default method beside.
void addFleischmannTables(const Results& results, Page* page);
/// Figures 6.2 to 6.4, 6.6, 6.17 to 6.20 and Table 6.5.
void addFleischmannFigures(const Results& results, const FilmSource& fast, const FilmSource& slow,
                           Page* page);
std::vector<Claim> fleischmannClaims(const Results& results);

/// The standstill of the motion, s.
constexpr double kStandsFrom = 5.8, kStandsTo = 7.3;
/// Frame at 60 fps whose fitness is drawn in Fig. 6.19.
constexpr size_t kCurveFrame = 150;

}  // namespace markerless_mocap
