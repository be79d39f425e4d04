#include "tools/offline/report_limbs.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "ros/pose_conversions.h"
#include "tools/common/html_text.h"
#include "tools/common/svg_plot.h"
#include "tools/offline/reason_counts.h"

namespace markerless_mocap {
namespace {

enum class Sight { kSeen, kNotSeen, kNoPose };

Sight sightOf(const ReportRow& row, size_t part) {
  if (row.status == PoseStatus::kLost) return Sight::kNoPose;
  return row.part_seen[part] ? Sight::kSeen : Sight::kNotSeen;
}

bool anyPartUnseen(const ReportRow& row) {
  return std::count(row.part_seen.begin(), row.part_seen.end(), false) > 0;
}

BandCell cellOf(const ReportRow& row, size_t part) {
  const std::string why = row.reason.empty() ? "" : ": " + row.reason;
  switch (sightOf(row, part)) {
    case Sight::kSeen:
      return {"#2a9d5c", "seen"};
    case Sight::kNotSeen:
      return {"#e0a020", "not seen" + why};
    case Sight::kNoPose:
      break;
  }
  return {"#c0392b", "no pose" + why};
}

std::string nameOf(size_t part) {
  return sidedPartName(static_cast<PartLabel>(part));
}

std::string bands(const std::vector<ReportRow>& rows, const std::vector<double>& seconds) {
  std::vector<NamedBand> bands;
  for (size_t part = 0; part < kPartCount; ++part) {
    bands.push_back({nameOf(part), {}});
    for (const ReportRow& row : rows) bands.back().cells.push_back(cellOf(row, part));
  }
  return timeBands(seconds, bands);
}

/// Median expected error of the part's end over the frames of one kind, as a cell in cm; empty if
/// no frame has one.
std::string errorCell(const std::vector<ReportRow>& rows, size_t part, Sight sight) {
  std::vector<double> errors;
  for (const ReportRow& row : rows)
    if (sightOf(row, part) == sight && std::isfinite(row.part_sigma_m[part]))
      errors.push_back(100 * row.part_sigma_m[part]);
  if (errors.empty()) return "<td class=\"n\"></td>";
  const auto middle = errors.begin() + std::ptrdiff_t(errors.size() / 2);
  std::nth_element(errors.begin(), middle, errors.end());
  char text[48];
  std::snprintf(text, sizeof text, "<td class=\"n\">%.1f</td>", *middle);
  return text;
}

std::string countCell(const std::vector<ReportRow>& rows, size_t part, Sight sight) {
  const auto count = std::count_if(
      rows.begin(), rows.end(), [&](const ReportRow& row) { return sightOf(row, part) == sight; });
  return "<td class=\"n\">" + std::to_string(count) + "</td>";
}

std::string table(const std::vector<ReportRow>& rows) {
  std::string html =
      "<table><tr><th>part</th><th class=\"n\">seen, frames</th><th class=\"n\">not seen</th>"
      "<th class=\"n\">no pose</th><th class=\"n\">expected error while seen, cm</th>"
      "<th class=\"n\">while not seen, cm</th></tr>\n";
  for (size_t part = 0; part < kPartCount; ++part) {
    html += "<tr><td>" + nameOf(part) + "</td>";
    for (const Sight sight : {Sight::kSeen, Sight::kNotSeen, Sight::kNoPose})
      html += countCell(rows, part, sight);
    html +=
        errorCell(rows, part, Sight::kSeen) + errorCell(rows, part, Sight::kNotSeen) + "</tr>\n";
  }
  return html + "</table>\n";
}

std::string reasonTable(const std::vector<ReportRow>& rows) {
  ReasonCounts counts;
  for (const ReportRow& row : rows)
    if (row.status == PoseStatus::kLost)
      counts.add("no pose: " + row.reason);
    else if (anyPartUnseen(row))
      counts.add("not all parts seen: " + (row.reason.empty() ? "no message" : row.reason));
  std::string html;
  for (const ReasonCounts::Reason& reason : counts.sorted())
    html += "<tr><td class=\"n\">" + std::to_string(reason.count) + "</td><td>" +
            escapeHtml(reason.example) + "</td></tr>\n";
  if (html.empty()) return "<p>Every part was seen in every frame set.</p>\n";
  return "<table><tr><th class=\"n\">frames</th><th>reason, with the numbers of the first "
         "time</th></tr>\n" +
         html + "</table>\n";
}

}  // namespace

std::string limbSection(const std::vector<ReportRow>& rows, const std::vector<double>& seconds) {
  return "<h2>Parts of the body that were not seen</h2><p>green: seen; amber: not seen, the rest "
         "of "
         "the body has a pose; red: no pose. A part is not seen if nothing shows where its end is "
         "(neck, head, wrist, ankle): its expected error is large; or if the masks contradict "
         "where "
         "it was found: then the expected error can be small. Expected errors are medians.</p>\n" +
         bands(rows, seconds) + table(rows) + reasonTable(rows);
}

}  // namespace markerless_mocap
