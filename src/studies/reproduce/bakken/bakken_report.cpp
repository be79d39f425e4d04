#include "studies/reproduce/bakken/bakken_report.h"

#include <cmath>

#include "studies/common/bakken_variants.h"
#include "studies/reproduce/bakken/bakken_results.h"
#include "studies/reproduce/result_cache.h"
#include "tools/common/number_format.h"

namespace markerless_mocap {
namespace {

constexpr double kShort = 1e-3;  // seconds

using Row = std::vector<std::string>;
using Rows = std::vector<Row>;

const Rows kPublishedTimes = {
    {"the paper, walk", "64", "9.61 (0.26)", "4.37 (0.28)", "1.44 (0.25)", "15.41 (0.47)", "64.9"},
    {"the paper, walk-spin", "64", "9.63 (0.26)", "4.42 (0.32)", "1.41 (0.30)", "15.46 (0.54)",
     "64.7"},
    {"the paper, run-crouch-jump", "64", "9.69 (0.26)", "4.82 (0.59)", "1.07 (0.27)",
     "15.58 (0.61)", "64.2"},
    {"the paper, walk", "128", "12.25 (0.34)", "49.37 (2.63)", "3.09 (0.33)", "64.71 (2.61)",
     "15.5"},
    {"the paper, walk-spin", "128", "12.28 (0.30)", "52.06 (4.14)", "3.13 (0.46)", "67.46 (4.03)",
     "14.8"},
    {"the paper, run-crouch-jump", "128", "11.94 (0.16)", "51.43 (3.73)", "3.51 (0.58)",
     "66.88 (3.89)", "15.0"}};

/// Share of right frames, error of hands and feet.
const Rows kPublishedLabels = {{"the paper", "64", "97.6 %", "-", "-", "53.2 (15.9)"},
                               {"the paper", "128", "95.8 %", "-", "-", "46.8 (16.6)"}};

/// The values with a NaN, at which curves are interrupted, in each gap between frames.
std::vector<double> withGaps(const std::vector<double>& seconds, const std::vector<double>& values,
                             double at_gap) {
  std::vector<double> out;
  for (size_t f = 0; f < values.size(); ++f) {
    const bool gap = f > 0 && seconds[f] - seconds[f - 1] > 1.5 * (seconds[1] - seconds[0]);
    if (gap) out.push_back(std::isfinite(at_gap) ? seconds[f - 1] + at_gap : NAN);
    out.push_back(values[f]);
  }
  return out;
}

void addErrorCurves(const Results& results, Page* page) {
  page->heading("Figure 4: error of hands and feet over the dance");
  page->text("Frames that are not labelled, or wrongly, are left out.");
  for (const char* variant : {"published", "prune05", "learned"}) {
    std::vector<PlotLine> lines;
    std::vector<double> seconds;
    for (const int edge : {64, 128}) {
      const LabelResult found(results, "whirl", edge, variant);
      if (found.frames() == 0) continue;
      seconds = found.seconds();
      lines.push_back({std::to_string(edge) + " voxels", withGaps(seconds, found.curve(), NAN)});
    }
    if (lines.empty()) continue;
    page->text(bakkenVariant(variant).name + ":");
    page->lines(withGaps(seconds, seconds, kShort), "s", lines, "mm", 150.0);
  }
}

std::vector<std::string> errorRow(const LabelResult& found, const std::string& name, int edge) {
  std::vector<std::string> row{name,
                               std::to_string(edge),
                               formatPercent(found.right()),
                               formatPercent(found.wrongButValid()),
                               formatPercent(found.correct()),
                               meanAndDeviation(summaryStatistics(found.curve()))};
  for (const char* extremity : {"head", "left_hand", "right_hand", "left_foot", "right_foot"})
    row.push_back(meanAndDeviation(found.error(extremity)));
  return row;
}

std::vector<std::string> defaultRow(const Results& results, const std::string& capture) {
  const auto run = results.find("default_" + capture);
  if (run == results.end()) return {};
  const Json& parts = run->second.at("hands_and_feet");
  const double hand = numberOf(parts.at("hand_mean")), foot = numberOf(parts.at("foot_mean"));
  const double right = 0.5 * (numberOf(parts.at("hand_fraction_correct")) +
                              numberOf(parts.at("foot_fraction_correct")));
  return {"the default tracker, from images",
          "",
          formatPercent(right) + " of hands and feet",
          "",
          "",
          formatNumber("%.1f", 0.5 * (hand + foot)),
          "",
          formatNumber("%.1f", hand),
          "",
          formatNumber("%.1f", foot),
          ""};
}

void addCapture(const Results& results, const std::string& capture, Page* page) {
  page->heading(capture + ", " +
                    std::to_string(LabelResult(results, capture, 128, "published").frames()) +
                    " frames",
                3);
  Rows rows;
  if (capture == "whirl") rows = kPublishedLabels;
  for (Row& row : rows) row.resize(11);
  for (const BakkenVariant& variant : bakkenVariants())
    for (const int edge : {64, 128}) {
      const LabelResult found(results, capture, edge, variant.id);
      if (found.frames() > 0) rows.push_back(errorRow(found, variant.name, edge));
    }
  const std::vector<std::string> beside = defaultRow(results, capture);
  if (!beside.empty()) rows.push_back(beside);
  page->table(
      {"", "#voxels", "#labelled right", "#wrong but valid", "#right, valid or not",
       "#hands and feet, mm", "#head", "#left hand", "#right hand", "#left foot", "#right foot"},
      rows);
}

void addTimes(const Results& results, Page* page) {
  page->heading("Table 2: durations, ms");
  page->text("Here by this processor, in the paper by two graphics cards of 2008 and 2011.");
  Rows rows;
  for (const int edge : {64, 128}) {
    for (const auto& published : kPublishedTimes)
      if (published[1] == std::to_string(edge)) rows.push_back(published);
    for (const std::string& capture : capturesIn(results)) {
      const auto time = [&](const char* stage) {
        return meanAndDeviation(stageTime(results, capture, edge, stage), 2);
      };
      const double sum = stageTime(results, capture, edge, "sum").mean;
      rows.push_back({capture, std::to_string(edge), time("hull"), time("thinning"), time("tree"),
                      time("sum"), formatNumber("%.1f", 1e3 / sum)});
    }
  }
  page->table({"", "#voxels", "#visual hull", "#skeletonisation", "#build tree", "#sum",
               "#frames per second"},
              rows);
}

/// Frames labelled right by the least length of a branch.
void addPruningTable(const Results& results, Page* page) {
  Rows rows;
  for (const char* id : {"published", "prune20", "prune16", "prune12", "prune08", "prune05"}) {
    std::vector<std::string> row{bakkenVariant(id).name};
    for (const int edge : {64, 128}) {
      const LabelResult one(results, "whirl", edge, id);
      row.push_back(formatPercent(one.rightWhere(false)));
      row.push_back(formatPercent(one.rightWhere(true)));
    }
    rows.push_back(row);
  }
  page->table({"labelled right", "#64: head on top", "#64: a hand above it", "#128: head on top",
               "#128: a hand above it"},
              rows);
}

/// Why an arm's length prunes too much.
void addPruning(const Results& results, Page* page) {
  page->heading("3.3.3: the length below which branches are pruned");
  const LabelResult found(results, "whirl", 128, "prune08");
  const std::vector<double> arms = found.numbers("arm"), necks = found.numbers("neck");
  if (arms.empty()) return;
  size_t short_arms = 0;
  for (const double arm : arms) short_arms += arm < 0.274;
  page->text(
      "An arm of Table 1 without its shoulder is 0.274 of the longest path. In the frames that are "
      "labelled right with 0.08, a branch of an arm is shorter than that in " +
      formatPercent(double(short_arms) / double(arms.size())) +
      ". The branch of the head always is: it stays only while it is the top-most voxel, the root. "
      "A "
      "hand is above the centre of the head in " +
      formatPercent(found.raised()) + " of the frames.");
  addPruningTable(results, page);
  page->text("Frames by the branch of the shorter arm, as a fraction of the longest path:");
  page->histogram(arms, "");
  page->text("Frames by the branch of the head:");
  page->histogram(necks, "");
}

void addTrees(const Results& results, Page* page) {
  page->heading("Figures 5 and 6: hulls, skeletons and pose trees");
  for (const std::string& capture : capturesIn(results))
    for (const int edge : {64, 128}) {
      const auto run = results.find("trees_" + capture + "_" + std::to_string(edge));
      if (run == results.end()) continue;
      page->add({{"kind", "picture"},
                 {"jpeg", run->second.at("jpeg")},
                 {"caption", capture + ", " + std::to_string(edge) +
                                 " voxels; above as published, below with the learned labelling; "
                                 "left green, right red, invalid grey"}});
    }
}

/// Of the captures in which the labels that follow the last frame go astray.
void addCorrespondence(const Results& results, Page* page) {
  page->heading("Figure 7: labels that follow the last frame, and sides");
  Rows rows;
  for (const std::string& capture : capturesIn(results))
    for (const int edge : {64, 128}) {
      const auto run = results.find("follow_" + capture + "_" + std::to_string(edge));
      if (run == results.end()) continue;
      const Json& found = run->second;
      rows.push_back({capture, std::to_string(edge)});
      for (const Json& every : found["every"])
        rows.back().push_back(std::to_string(every["exchanged"].get<int>()) + " of " +
                              std::to_string(every["pairs"].get<int>()) + "; " +
                              std::to_string(every["astray"].get<int>()));
      if (!found.contains("jpeg")) continue;
      const int frame = found["frame"].get<int>(), step = found["step"].get<int>();
      page->add({{"kind", "picture"},
                 {"jpeg", found["jpeg"]},
                 {"caption", capture + ", " + std::to_string(edge) + " voxels, frames " +
                                 std::to_string(frame) + " and " + std::to_string(frame + step) +
                                 ": limbs by the labels that follow the last frame, first blue, "
                                 "second orange; extremities by side, left green, right red"}});
    }
  page->text(
      "Of pairs of successive frames that are labelled right, those in which the first and the "
      "second arm or leg change places; with all frames, and with fewer, as of a person who moves "
      "faster. After them the longest run of frames that are valid, but labelled wrong: labels "
      "that "
      "follow hand errors on. Pruned below 0.08.");
  page->table({"", "#voxels", "#all frames", "#every second", "#every fourth"}, rows);
}

/// Correct frames, valid or not, by labelling.
void addPeople(const Results& results, Page* page) {
  const std::vector<std::string> people = peopleIn(results);
  if (people.empty()) return;
  page->heading("What the learned labelling is worth");
  page->text(
      "Other people, motions and rigs, to none of which the learned models were fitted: frames "
      "in which all five extremities and the sides are right, valid or not.");
  const std::vector<std::string> variants{"published", "prune08", "alone08", "learned"};
  std::vector<std::string> head{""};
  Rows rows;
  for (const std::string& id : variants)
    head.insert(head.end(), {"#" + bakkenVariant(id).name + ", 64", "#128"});
  std::vector<double> sums(head.size() - 1, 0.0);
  for (const std::string& capture : people) {
    rows.push_back({capture});
    for (size_t column = 0; column < sums.size(); ++column) {
      const LabelResult found(results, capture, column % 2 ? 128 : 64, variants[column / 2]);
      sums[column] += found.correct() / double(people.size());
      rows.back().push_back(formatPercent(found.correct()));
    }
  }
  rows.push_back({"mean"});
  for (const double sum : sums) rows.back().push_back(formatPercent(sum));
  page->table(head, rows);
}

}  // namespace

std::vector<Claim> bakkenReport(const Results& results, Page* page) {
  addErrorCurves(results, page);
  page->heading("Labels and errors");
  page->text(
      "A frame is labelled right if it is valid and head, hands and feet and their sides are "
      "right; errors are those of right "
      "frames, mean (standard deviation), to knuckles, balls of the feet and the head's centre. "
      "Frames in which the person reaches out of the cube are left out, as in the paper. Hands and "
      "feet: of the frames' means.");
  for (const std::string& capture : capturesIn(results)) addCapture(results, capture, page);
  addPeople(results, page);
  addPruning(results, page);
  addTimes(results, page);
  addTrees(results, page);
  addCorrespondence(results, page);
  return bakkenClaims(results);
}

}  // namespace markerless_mocap
