#include "tools/evaluate/evaluation_deviation.h"

#include <cmath>

#include "tools/common/figure_text.h"

namespace markerless_mocap {
namespace {

std::string binsText(const DeviationError& one, const char* between) {
  std::string text;
  for (const DeviationBin& bin : one.bins)
    text += (text.empty() ? "" : between) + figureText("%.0f:", bin.expected_mm) +
            figureText("%.0f", bin.actual_mm);
  return text;
}

}  // namespace

std::vector<DeviationError> judgeDeviations(const JointTrack& truth, const ResultRecord& results,
                                            const std::vector<int>& match) {
  // In the order of BodyPose's part_deviation.
  const std::vector<std::string> ends{"thorax", "head", "l_wrist", "r_wrist", "l_ankle", "r_ankle"};
  const JointTrack real = truth.select(ends), found = alignedTo(real, results.joints);
  const auto errors = markerDistances(real, found);
  std::vector<DeviationError> out;
  for (size_t part = 0; part < ends.size(); ++part) {
    std::vector<double> expected;
    for (const int frame : match)
      expected.push_back(frame < 0 ? NAN : results.frames[size_t(frame)].part_deviation_m[part]);
    DeviationError one = deviationError(ends[part], expected, errors[part]);
    if (one.frames > 0) out.push_back(std::move(one));
  }
  return out;
}

void printDeviations(const std::vector<DeviationError>& deviations, std::ostream& out) {
  if (deviations.empty()) return;
  out << "Errors expected : made, mm, all and by fifths of the frames\n";
  for (const DeviationError& one : deviations)
    printRow(out, one.point,
             figureText("%.0f:", one.expected_mm) + figureText("%.0f", one.actual_mm) + "   (" +
                 binsText(one, " ") + "), within two deviations " +
                 percentText(one.share_within_two));
}

JsonObject deviationsObject(const std::vector<DeviationError>& deviations) {
  JsonObject out;
  for (const DeviationError& one : deviations) {
    JsonObject point;
    point.add("frames", one.frames);
    point.add("expected_mm", one.expected_mm);
    point.add("actual_mm", one.actual_mm);
    point.add("share_within_two", one.share_within_two);
    std::string bins;
    for (const DeviationBin& bin : one.bins)
      bins += (bins.empty() ? "[" : ", [") + JsonObject::number(double(bin.frames)) + ", " +
              JsonObject::number(bin.expected_mm) + ", " + JsonObject::number(bin.actual_mm) + "]";
    point.addList("fifths_frames_expected_actual", bins);
    out.add(one.point, point);
  }
  return out;
}

std::string deviationsSection(const std::vector<DeviationError>& deviations) {
  if (deviations.empty()) return "";
  std::string out =
      "<h2>Errors that were expected</h2>\n<p>root mean squares, mm; expected : made, by fifths of "
      "the frames</p>\n<table><tr><th>point</th><th class=n>expected</th><th class=n>made</th>"
      "<th class=n>within two deviations</th><th class=n>by fifths</th></tr>\n";
  for (const DeviationError& one : deviations)
    out += "<tr><td>" + one.point + "</td><td class=n>" + figureText("%.0f", one.expected_mm) +
           "</td><td class=n>" + figureText("%.0f", one.actual_mm) + "</td><td class=n>" +
           percentText(one.share_within_two) + "</td><td class=n>" + binsText(one, " &nbsp; ") +
           "</td></tr>\n";
  return out + "</table>\n";
}

}  // namespace markerless_mocap
