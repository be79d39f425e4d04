#include "tools/offline/report_page.h"

#include <algorithm>
#include <utility>

#include "evaluation/joint_error.h"

namespace markerless_mocap {
namespace {

std::string counts(const std::vector<ResultFrame>& frames) {
  const auto count = [&](FrameStatus status) {
    return std::to_string(std::count_if(frames.begin(), frames.end(),
                                        [&](const ResultFrame& f) { return f.status == status; }));
  };
  return std::to_string(frames.size()) + " frame sets: " + count(FrameStatus::kTracked) +
         " tracked, " + count(FrameStatus::kReinitialized) + " reinitialized, " +
         count(FrameStatus::kLost) + " lost";
}

void addFit(const std::vector<ReportRow>& rows, Page* page) {
  PlotLine overlap{"", {}}, error{"", {}};
  for (const ReportRow& row : rows) {
    overlap.values.push_back(row.mean_iou);
    error.values.push_back(1e3 * row.skeleton_error_m);
  }
  page->heading("Overlap of body and masks");
  page->text("mean intersection over union of the views");
  page->timeLines({overlap}, "", 1.0);
  if (summaryStatistics(error.values).count == 0) return;
  page->heading("Skeleton error");
  page->text("mean distance of part curves to the body");
  page->timeLines({error}, "mm", 200.0);
}

}  // namespace

Page reportPage(const ReportContent& content, Json player, const BodyModel& body) {
  Page page(content.title);
  for (const std::string& remark : content.remarks) page.text(remark);
  page.text(counts(content.frames));
  page.add(std::move(player));
  addFit(content.rows, &page);
  addParts(content, &page);
  addMotionPlots(body, content.frames, &page);
  addCameras(content, &page);
  return page;
}

}  // namespace markerless_mocap
