#include "tools/evaluate/evaluation_deviation.h"

#include <cmath>

#include "tools/common/number_format.h"

namespace markerless_mocap {
namespace {

std::string binsText(const UncertaintyCalibration& one, const char* between) {
  std::string text;
  for (const UncertaintyBin& bin : one.bins)
    text += (text.empty() ? "" : between) + formatNumber("%.0f:", bin.expected_mm) +
            formatNumber("%.0f", bin.actual_mm);
  return text;
}

}  // namespace

std::vector<UncertaintyCalibration> evaluateDeviations(const JointTrack& truth,
                                                       const ResultRecord& results,
                                                       const std::vector<int>& match) {
  // In the order of BodyPose::part_sigma_m.
  const std::vector<std::string> ends{"thorax", "head", "l_wrist", "r_wrist", "l_ankle", "r_ankle"};
  const JointTrack real = truth.select(ends), found = alignedTo(real, results.joints);
  const auto errors = markerDistances(real, found);
  std::vector<UncertaintyCalibration> out;
  for (size_t part = 0; part < ends.size(); ++part) {
    std::vector<double> expected;
    for (const int frame : match)
      expected.push_back(frame < 0 ? NAN : results.frames[size_t(frame)].part_sigma_m[part]);
    UncertaintyCalibration one = uncertaintyCalibration(ends[part], expected, errors[part]);
    if (one.frames > 0) out.push_back(std::move(one));
  }
  return out;
}

void printDeviations(const std::vector<UncertaintyCalibration>& deviations, std::ostream& out) {
  if (deviations.empty()) return;
  out << "Errors estimated : actual, mm, all and by fifths of the frames\n";
  for (const UncertaintyCalibration& one : deviations)
    printRow(out, one.point,
             formatNumber("%.0f:", one.expected_mm) + formatNumber("%.0f", one.actual_mm) + "   (" +
                 binsText(one, " ") + "), within two sigma " +
                 formatPercent(one.fraction_within_two_sigma) + ", 95 % within " +
                 formatNumber("%.1f sigma", one.normalised_95));
}

Json deviationsJson(const std::vector<UncertaintyCalibration>& deviations) {
  Json out = Json::object();
  for (const UncertaintyCalibration& one : deviations) {
    Json bins = Json::array();
    for (const UncertaintyBin& bin : one.bins)
      bins.push_back({bin.frames, bin.expected_mm, bin.actual_mm});
    out[one.point] = {{"frames", one.frames},
                      {"expected_mm", one.expected_mm},
                      {"actual_mm", one.actual_mm},
                      {"fraction_within_two_sigma", one.fraction_within_two_sigma},
                      {"normalised_95", one.normalised_95},
                      {"fifths_frames_expected_actual", bins}};
  }
  return out;
}

void addDeviations(const std::vector<UncertaintyCalibration>& deviations, Page* page) {
  if (deviations.empty()) return;
  page->heading("Estimated and actual errors");
  page->text("root mean squares, mm; estimated : actual, by fifths of the frames");
  std::vector<std::vector<std::string>> rows;
  for (const UncertaintyCalibration& one : deviations)
    rows.push_back({one.point, formatNumber("%.0f", one.expected_mm),
                    formatNumber("%.0f", one.actual_mm),
                    formatPercent(one.fraction_within_two_sigma),
                    formatNumber("%.1f", one.normalised_95), binsText(one, "  ")});
  page->table(
      {"point", "#estimated", "#actual", "#within two sigma", "#95 % within, sigma", "#by fifths"},
      rows);
}

}  // namespace markerless_mocap
