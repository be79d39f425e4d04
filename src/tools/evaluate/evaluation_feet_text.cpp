#include "tools/evaluate/evaluation_feet_text.h"

#include "tools/common/number_format.h"

namespace markerless_mocap {
namespace {

constexpr const char *kBlue = "#1f5fa8", *kOrange = "#e08a2c", *kNone = "#e4e6e8",
                     *kWrong = "#c0392b";
constexpr const char* kSides[] = {"left", "right"};

std::string padded(const std::string& text) {
  return text.size() < 8 ? std::string(8 - text.size(), ' ') + text : text;
}

Json slideJson(const FootContact& contact) {
  Json each = Json::array();
  for (const FootSkate& slide : contact.contacts)
    each.push_back({{"first_frame", slide.run.first},
                    {"frames", slide.run.frames},
                    {"slide_mm", slide.max_slide_mm},
                    {"slide_mm_per_s", slide.path_mm_per_s}});
  return {{"contacts", contact.contacts.size()},
          {"precision", contact.precision},
          {"recall", contact.recall},
          {"slide_mm_mean", contact.max_slide_mm.mean},
          {"slide_mm_max", contact.max_slide_mm.max},
          {"slide_mm_per_s_mean", contact.path_mm_per_s.mean},
          {"true_slide_mm_mean", contact.true_max_slide_mm.mean},
          {"true_slide_mm_per_s_mean", contact.true_path_mm_per_s.mean},
          {"each", each}};
}

std::vector<std::string> slideRow(const std::string& name, const FootContact& contact) {
  return {name,
          std::to_string(contact.contacts.size()),
          formatPercent(contact.precision),
          formatPercent(contact.recall),
          formatNumber("%.0f", contact.max_slide_mm.mean),
          formatNumber("%.0f", contact.max_slide_mm.max),
          formatNumber("%.0f", contact.path_mm_per_s.mean),
          formatNumber("%.0f", contact.true_max_slide_mm.mean),
          formatNumber("%.0f", contact.true_path_mm_per_s.mean)};
}

Band contactBand(const FootContact& contact, const std::string& name) {
  Band band{name, {}};
  for (size_t f = 0; f < contact.truth.size(); ++f)
    band.cells.push_back({size_t(contact.truth[f]) + 2 * size_t(contact.estimate[f]), ""});
  return band;
}

void addSoles(const FeetEvaluation& feet, Page* page) {
  std::vector<std::vector<std::string>> rows;
  for (size_t side = 0; side < 2; ++side) {
    const SoleStatistics& sole = feet[side].sole;
    rows.push_back({kSides[side], formatPercent(sole.fraction_below),
                    formatNumber("%.1f", sole.mean_below_mm), formatNumber("%.0f", sole.deepest_mm),
                    formatNumber("%.0f", sole.standing_mm.mean)});
  }
  page->table({"sole", "#below the floor by over 10 mm", "#mean depth", "#deepest",
               "#height while the foot stands"},
              rows);
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

Json feetJson(const FeetEvaluation& feet) {
  Json out;
  for (size_t side = 0; side < 2; ++side) {
    const FootEvaluation& foot = feet[side];
    out[kSides[side]] = {{"ball", slideJson(foot.ball)},
                         {"ankle", slideJson(foot.ankle)},
                         {"sole",
                          {{"frames", foot.sole.frames},
                           {"fraction_below_10_mm", foot.sole.fraction_below},
                           {"mean_below_mm", foot.sole.mean_below_mm},
                           {"deepest_mm", foot.sole.deepest_mm},
                           {"standing_height_mm_mean", foot.sole.standing_mm.mean},
                           {"standing_height_mm_std", foot.sole.standing_mm.deviation}}}};
  }
  return out;
}

void addFeet(const FeetEvaluation& feet, Page* page) {
  page->heading("Feet and the floor, against the truth");
  page->text(
      "A foot stands while its ball is low and slow. Slide: distance that the estimated point "
      "moves along the floor meanwhile, mm per contact and mm/s along its path");
  std::vector<std::vector<std::string>> rows;
  std::vector<Band> bands;
  for (size_t side = 0; side < 2; ++side) {
    rows.push_back(slideRow(std::string(kSides[side]) + " ball", feet[side].ball));
    rows.push_back(slideRow(std::string(kSides[side]) + " ankle", feet[side].ankle));
    bands.push_back(contactBand(feet[side].ball, kSides[side]));
  }
  page->table({"point", "#contacts", "#precision", "#recall", "#slide", "#maximum", "#mm/s",
               "#true slide", "#mm/s"},
              rows);
  addSoles(feet, page);
  for (size_t side = 0; side < 2; ++side)
    page->timeLines({{std::string("true height of the ball, ") + kSides[side],
                      feet[side].true_ball_mm, kOrange},
                     {"estimated", feet[side].ball_mm, kBlue}},
                    "mm");
  page->bands({{"in the air", kNone},
               {"stands", "#e0a020"},
               {"does not stand but seems to", kWrong},
               {"stands and is found", "#2a9d5c"}},
              bands);
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

Json limbsJson(const std::vector<LimbLoss>& limbs) {
  Json out = Json::object();
  for (const LimbLoss& limb : limbs)
    out[limb.limb] = {
        {"frames", limb.frames},          {"losses", limb.losses},
        {"per_minute", limb.per_minute},  {"fraction_lost", limb.fraction_lost},
        {"frames_far_off", limb.far_off}, {"frames_not_published", limb.not_published},
        {"longest_s", limb.longest_s}};
  return out;
}

void addLimbs(const std::vector<LimbLoss>& limbs, Page* page) {
  page->heading("Lost limbs");
  page->text("after the first pose: the end is over 150 mm off or not published");
  std::vector<std::vector<std::string>> rows;
  std::vector<Band> bands;
  for (const LimbLoss& limb : limbs) {
    rows.push_back({limb.limb, formatNumber("%.1f", limb.per_minute),
                    formatPercent(limb.fraction_lost), formatNumber("%.2f s", limb.longest_s),
                    std::to_string(limb.far_off), std::to_string(limb.not_published)});
    bands.push_back({limb.limb, {}});
    for (const bool lost : limb.lost) bands.back().cells.push_back({size_t(lost), ""});
  }
  page->table({"limb", "#losses per minute", "#of the frames", "#longest", "#frames far off",
               "#not published"},
              rows);
  page->bands({{"right", kNone}, {"lost", kWrong}}, bands);
}

}  // namespace markerless_mocap
