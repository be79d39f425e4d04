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
                 formatPercent(one.fraction_within_two_sigma));
}

JsonObject deviationsObject(const std::vector<UncertaintyCalibration>& deviations) {
  JsonObject out;
  for (const UncertaintyCalibration& one : deviations) {
    JsonObject point;
    point.add("frames", one.frames);
    point.add("expected_mm", one.expected_mm);
    point.add("actual_mm", one.actual_mm);
    point.add("fraction_within_two_sigma", one.fraction_within_two_sigma);
    std::string bins;
    for (const UncertaintyBin& bin : one.bins)
      bins += (bins.empty() ? "[" : ", [") + JsonObject::number(double(bin.frames)) + ", " +
              JsonObject::number(bin.expected_mm) + ", " + JsonObject::number(bin.actual_mm) + "]";
    point.addList("fifths_frames_expected_actual", bins);
    out.add(one.point, point);
  }
  return out;
}

std::string deviationsSection(const std::vector<UncertaintyCalibration>& deviations) {
  if (deviations.empty()) return "";
  std::string out =
      "<h2>Estimated and actual errors</h2>\n<p>root mean squares, mm; estimated : actual, by "
      "fifths of "
      "the frames</p>\n<table><tr><th>point</th><th class=n>estimated</th><th class=n>actual</th>"
      "<th class=n>within two sigma</th><th class=n>by fifths</th></tr>\n";
  for (const UncertaintyCalibration& one : deviations)
    out += "<tr><td>" + one.point + "</td><td class=n>" + formatNumber("%.0f", one.expected_mm) +
           "</td><td class=n>" + formatNumber("%.0f", one.actual_mm) + "</td><td class=n>" +
           formatPercent(one.fraction_within_two_sigma) + "</td><td class=n>" +
           binsText(one, " &nbsp; ") + "</td></tr>\n";
  return out + "</table>\n";
}

}  // namespace markerless_mocap
