#include "evaluation/joint_error.h"
#include "tools/common/number_format.h"
#include "tools/offline/report_page.h"

namespace markerless_mocap {
namespace {

constexpr const char *kUnknownLine = "#e0a020", *kOverlapLine = "#1f5fa8";

void addBackground(const ReportCamera& camera, Page* page) {
  const std::string source = "Background: " + camera.background_source;
  if (camera.background.empty()) {
    page->text(source);
    return;
  }
  page->picture(camera.background,
                source + (camera.background_unknown > 0
                              ? "; blue: never seen without the person, " +
                                    formatPercent(camera.background_unknown) + " of the image"
                              : "; all of it is known"));
}

void addConfidence(const ReportCamera& camera, Page* page) {
  const double unknown = summaryStatistics(camera.unknown_of_row).mean;
  if (std::isnan(unknown)) {
    page->text("This camera gave no mask.");
    return;
  }
  page->text("Of its masks, " + formatPercent(unknown) + " is unknown on average.");
  page->timeLines({{"share of the mask that is unknown", camera.unknown_of_row, kUnknownLine},
                   {"overlap of body and mask (IoU), where the mask is known", camera.iou_of_row,
                    kOverlapLine}},
                  "", 1.0);
}

}  // namespace

void addCameras(const ReportContent& content, Page* page) {
  page->heading("What each camera saw");
  page->text(
      "Where the outlines of mask and body run together in the views, the silhouette holds the "
      "body. Where the mask is unknown there is no silhouette: there the body follows from the "
      "other cameras and, with colour images, from the person's colours.");
  std::vector<std::vector<std::string>> rows;
  for (const ReportCamera& camera : content.cameras)
    rows.push_back({camera.name, formatNumber("%.3f", summaryStatistics(camera.iou_of_row).mean)});
  page->table({"camera", "#mean IoU"}, rows);
  for (const ReportCamera& camera : content.cameras) {
    page->heading(camera.name, 3);
    addBackground(camera, page);
    addConfidence(camera, page);
  }
}

}  // namespace markerless_mocap
