#include "tools/evaluate/evaluation_feet_text.h"

#include "tools/common/html_text.h"
#include "tools/common/number_format.h"
#include "tools/common/svg_plot.h"

namespace markerless_mocap {
namespace {

constexpr const char *kBlue = "#1f5fa8", *kOrange = "#e08a2c";
constexpr const char *kBoth = "#2a9d5c", *kTruthOnly = "#e0a020", *kEstimateOnly = "#c0392b",
                     *kNone = "#e4e6e8";
constexpr const char* kSides[] = {"left", "right"};

std::string padded(const std::string& text) {
  return text.size() < 8 ? std::string(8 - text.size(), ' ') + text : text;
}

JsonObject slideObject(const FootContact& contact) {
  JsonObject out;
  out.add("contacts", contact.contacts.size());
  out.add("precision", contact.precision);
  out.add("recall", contact.recall);
  out.add("slide_mm_mean", contact.max_slide_mm.mean);
  out.add("slide_mm_max", contact.max_slide_mm.max);
  out.add("slide_mm_per_s_mean", contact.path_mm_per_s.mean);
  out.add("true_slide_mm_mean", contact.true_max_slide_mm.mean);
  out.add("true_slide_mm_per_s_mean", contact.true_path_mm_per_s.mean);
  std::string list;
  for (const FootSkate& slide : contact.contacts) {
    JsonObject one;
    one.add("first_frame", slide.run.first);
    one.add("frames", slide.run.frames);
    one.add("slide_mm", slide.max_slide_mm);
    one.add("slide_mm_per_s", slide.path_mm_per_s);
    list += (list.empty() ? "" : ", ") + one.text();
  }
  out.addList("each", list);
  return out;
}

std::string cell(const std::string& text) {
  return "<td class=n>" + text + "</td>";
}

std::string slideRow(const std::string& name, const FootContact& contact) {
  return "<tr><td>" + name + "</td>" + cell(std::to_string(contact.contacts.size())) +
         cell(formatPercent(contact.precision)) + cell(formatPercent(contact.recall)) +
         cell(formatNumber("%.0f", contact.max_slide_mm.mean)) +
         cell(formatNumber("%.0f", contact.max_slide_mm.max)) +
         cell(formatNumber("%.0f", contact.path_mm_per_s.mean)) +
         cell(formatNumber("%.0f", contact.true_max_slide_mm.mean)) +
         cell(formatNumber("%.0f", contact.true_path_mm_per_s.mean)) + "</tr>\n";
}

std::string contactBand(const FootContact& contact, const std::vector<double>& seconds) {
  std::vector<BandCell> cells;
  for (size_t f = 0; f < seconds.size(); ++f) {
    const bool real = contact.truth[f], said = contact.estimate[f];
    cells.push_back({real ? (said ? kBoth : kTruthOnly) : (said ? kEstimateOnly : kNone),
                     formatNumber("%.3f s", seconds[f])});
  }
  return timeBand(seconds, cells);
}

std::string soleTable(const FeetEvaluation& feet) {
  std::string out =
      "<table><tr><th>sole</th><th class=n>below the floor by over 10 mm</th>"
      "<th class=n>mean depth</th><th class=n>deepest</th>"
      "<th class=n>height while the foot stands</th></tr>\n";
  for (size_t side = 0; side < 2; ++side) {
    const SoleStatistics& sole = feet[side].sole;
    out += std::string("<tr><td>") + kSides[side] + "</td>" +
           cell(formatPercent(sole.fraction_below)) +
           cell(formatNumber("%.1f", sole.mean_below_mm)) +
           cell(formatNumber("%.0f", sole.deepest_mm)) +
           cell(formatNumber("%.0f", sole.standing_mm.mean)) + "</tr>\n";
  }
  return out + "</table>\n";
}

}  // namespace

void printFeet(const FeetEvaluation& feet, std::ostream& out) {
  out << "Feet on the floor     left   right\n";
  const auto row = [&](const char* name, const auto& text) {
    printRow(out, name, padded(text(feet[0])) + padded(text(feet[1])));
  };
  row("contacts", [](const FootEvaluation& f) { return std::to_string(f.ball.contacts.size()); });
  row("found", [](const FootEvaluation& f) { return formatPercent(f.ball.recall); });
  row("precision", [](const FootEvaluation& f) { return formatPercent(f.ball.precision); });
  row("slide mm",
      [](const FootEvaluation& f) { return formatNumber("%.0f", f.ball.max_slide_mm.mean); });
  row("maximum mm",
      [](const FootEvaluation& f) { return formatNumber("%.0f", f.ball.max_slide_mm.max); });
  row("slide mm/s",
      [](const FootEvaluation& f) { return formatNumber("%.0f", f.ball.path_mm_per_s.mean); });
  row("true",
      [](const FootEvaluation& f) { return formatNumber("%.0f", f.ball.true_path_mm_per_s.mean); });
  row("ankle mm",
      [](const FootEvaluation& f) { return formatNumber("%.0f", f.ankle.max_slide_mm.mean); });
  row("ankle mm/s",
      [](const FootEvaluation& f) { return formatNumber("%.0f", f.ankle.path_mm_per_s.mean); });
  row("> 10 mm below",
      [](const FootEvaluation& f) { return formatPercent(f.sole.fraction_below); });
  row("deepest mm",
      [](const FootEvaluation& f) { return formatNumber("%.0f", f.sole.deepest_mm); });
}

JsonObject feetObject(const FeetEvaluation& feet) {
  JsonObject out;
  for (size_t side = 0; side < 2; ++side) {
    const FootEvaluation& foot = feet[side];
    JsonObject one, sole;
    sole.add("frames", foot.sole.frames);
    sole.add("fraction_below_10_mm", foot.sole.fraction_below);
    sole.add("mean_below_mm", foot.sole.mean_below_mm);
    sole.add("deepest_mm", foot.sole.deepest_mm);
    sole.add("standing_height_mm_mean", foot.sole.standing_mm.mean);
    sole.add("standing_height_mm_std", foot.sole.standing_mm.deviation);
    one.add("ball", slideObject(foot.ball));
    one.add("ankle", slideObject(foot.ankle));
    one.add("sole", sole);
    out.add(kSides[side], one);
  }
  return out;
}

std::string feetSection(const FeetEvaluation& feet, const std::vector<double>& seconds) {
  std::string out =
      "<h2>Feet on the floor</h2>\n<p>A foot stands while its ball is low and slow. Slide: "
      "distance that the estimated point moves along the floor meanwhile, mm per contact and mm/s "
      "along its "
      "path</p>\n<table><tr><th>point</th><th class=n>contacts</th><th class=n>precision</th>"
      "<th class=n>recall</th><th class=n>slide</th><th class=n>maximum</th><th class=n>mm/s</th>"
      "<th class=n>true slide</th><th class=n>mm/s</th></tr>\n";
  for (size_t side = 0; side < 2; ++side) {
    out += slideRow(std::string(kSides[side]) + " ball", feet[side].ball);
    out += slideRow(std::string(kSides[side]) + " ankle", feet[side].ankle);
  }
  out += "</table>\n" + soleTable(feet);
  for (size_t side = 0; side < 2; ++side) {
    const std::vector<PlotSeries> lines{
        {std::string("true height of the ball, ") + kSides[side], kOrange, feet[side].true_ball_mm},
        {"estimated", kBlue, feet[side].ball_mm}};
    out += plotLegend(lines) + linePlot(seconds, lines, 0.0, "mm") +
           contactBand(feet[side].ball, seconds);
  }
  return out + plotLegend({{"stands and is found", kBoth, {}},
                           {"stands", kTruthOnly, {}},
                           {"does not stand but seems to", kEstimateOnly, {}},
                           {"in the air", kNone, {}}});
}

void printLimbs(const std::vector<LimbLoss>& limbs, std::ostream& out) {
  out << "Limbs lost          /min   share  longest   not published\n";
  for (const LimbLoss& limb : limbs)
    printRow(out, limb.limb,
             padded(formatNumber("%.1f", limb.per_minute)) +
                 padded(formatPercent(limb.fraction_lost)) +
                 padded(formatNumber("%.2f s", limb.longest_s)) +
                 padded(std::to_string(limb.not_published)) + " frames");
}

JsonObject limbsObject(const std::vector<LimbLoss>& limbs) {
  JsonObject out;
  for (const LimbLoss& limb : limbs) {
    JsonObject one;
    one.add("frames", limb.frames);
    one.add("losses", limb.losses);
    one.add("per_minute", limb.per_minute);
    one.add("fraction_lost", limb.fraction_lost);
    one.add("frames_far_off", limb.far_off);
    one.add("frames_not_published", limb.not_published);
    one.add("longest_s", limb.longest_s);
    out.add(limb.limb, one);
  }
  return out;
}

std::string limbsSection(const std::vector<LimbLoss>& limbs, const std::vector<double>& seconds) {
  std::string out =
      "<h2>Lost limbs</h2>\n<p>after the first pose: the end is over 150 mm off or not "
      "published</p>\n<table><tr><th>limb</th><th class=n>losses per minute</th>"
      "<th class=n>of the frames</th><th class=n>longest</th><th class=n>frames far off</th>"
      "<th class=n>not published</th></tr>\n";
  for (const LimbLoss& limb : limbs)
    out += "<tr><td>" + limb.limb + "</td>" + cell(formatNumber("%.1f", limb.per_minute)) +
           cell(formatPercent(limb.fraction_lost)) + cell(formatNumber("%.2f s", limb.longest_s)) +
           cell(std::to_string(limb.far_off)) + cell(std::to_string(limb.not_published)) +
           "</tr>\n";
  out += "</table>\n";
  for (const LimbLoss& limb : limbs) {
    if (limb.losses == 0) continue;
    std::vector<BandCell> cells;
    for (size_t f = 0; f < seconds.size(); ++f)
      cells.push_back({limb.lost[f] ? kEstimateOnly : kNone, formatNumber("%.3f s", seconds[f])});
    out += "<p>" + limb.limb + "</p>\n" + timeBand(seconds, cells);
  }
  return out;
}

}  // namespace markerless_mocap
