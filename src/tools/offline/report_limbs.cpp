#include <algorithm>
#include <cmath>

#include "numerics/order_statistics.h"
#include "ros/pose_conversions.h"
#include "tools/common/number_format.h"
#include "tools/offline/reason_counts.h"
#include "tools/offline/report_page.h"

namespace markerless_mocap {
namespace {

enum class Sight { kSeen, kNotSeen, kNoPose };
const std::vector<BandState> kSights{
    {"seen", "#2a9d5c"}, {"not seen", "#e0a020"}, {"no pose", "#c0392b"}};

/// What is known of a part in each frame.
std::vector<Sight> sightsOf(const ReportContent& content, size_t part) {
  std::vector<Sight> sights;
  for (size_t f = 0; f < content.rows.size(); ++f)
    sights.push_back(content.frames[f].status == FrameStatus::kLost ? Sight::kNoPose
                     : content.rows[f].part_seen[part]              ? Sight::kSeen
                                                                    : Sight::kNotSeen);
  return sights;
}

Band bandOf(const ReportContent& content, size_t part) {
  Band band{sidedPartName(PartLabel(part)), {}};
  for (const Sight sight : sightsOf(content, part))
    band.cells.push_back(
        {size_t(sight), sight == Sight::kSeen ? "" : content.frames[band.cells.size()].reason});
  return band;
}

/// Median expected error of the part's end over the frames of one kind, cm; empty if no frame has
/// one.
std::string errorCell(const ReportContent& content, size_t part, Sight wanted) {
  const std::vector<Sight> sights = sightsOf(content, part);
  std::vector<double> errors;
  for (size_t f = 0; f < sights.size(); ++f)
    if (sights[f] == wanted && std::isfinite(content.frames[f].part_sigma_m[part]))
      errors.push_back(100 * content.frames[f].part_sigma_m[part]);
  if (errors.empty()) return "";
  return formatNumber("%.1f", medianAmong(errors));
}

std::vector<std::string> tableRow(const ReportContent& content, size_t part) {
  const std::vector<Sight> sights = sightsOf(content, part);
  std::vector<std::string> row{sidedPartName(PartLabel(part))};
  for (const Sight sight : {Sight::kSeen, Sight::kNotSeen, Sight::kNoPose})
    row.push_back(std::to_string(std::count(sights.begin(), sights.end(), sight)));
  for (const Sight sight : {Sight::kSeen, Sight::kNotSeen})
    row.push_back(errorCell(content, part, sight));
  return row;
}

void addReasons(const ReportContent& content, Page* page) {
  ReasonCounts counts;
  for (size_t f = 0; f < content.rows.size(); ++f) {
    const ResultFrame& frame = content.frames[f];
    const auto& seen = content.rows[f].part_seen;
    if (frame.status == FrameStatus::kLost)
      counts.add("no pose: " + frame.reason);
    else if (std::count(seen.begin(), seen.end(), false) > 0)
      counts.add("not all parts seen: " + (frame.reason.empty() ? "no message" : frame.reason));
  }
  std::vector<std::vector<std::string>> rows;
  for (const ReasonCounts::Reason& reason : counts.sorted())
    rows.push_back({std::to_string(reason.count), reason.example});
  if (rows.empty())
    page->text("Every part was seen in every frame set.");
  else
    page->table({"#frames", "reason, with the numbers of the first time"}, rows);
}

}  // namespace

void addParts(const ReportContent& content, Page* page) {
  page->heading("Parts of the body that were not seen");
  page->text(
      "A part is not seen if nothing shows where its end is (neck, head, wrist, ankle): its "
      "expected error is large; or if the masks contradict where it was found: then the expected "
      "error can be small. Expected errors are medians.");
  std::vector<Band> bands;
  std::vector<std::vector<std::string>> rows;
  for (size_t part = 0; part < kPartCount; ++part) {
    bands.push_back(bandOf(content, part));
    rows.push_back(tableRow(content, part));
  }
  page->bands(kSights, bands);
  page->table({"part", "#seen, frames", "#not seen", "#no pose", "#expected error while seen, cm",
               "#while not seen, cm"},
              rows);
  addReasons(content, page);
}

}  // namespace markerless_mocap
