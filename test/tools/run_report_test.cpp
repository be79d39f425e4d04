#include "tools/offline/run_report.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "body/body_fixture.h"
#include "pages/page_reader.h"
#include "tools/tool_fixture.h"

namespace markerless_mocap {
namespace {

using RunReportTest = ToolTest;

TEST_F(RunReportTest, OfALongRunItShowsOneFrameSetInFour) {
  constexpr int64_t kPeriod_ns = 1000000000;
  constexpr size_t kMost = 4, kFrameSets = 11;
  const BodyModel model = human();
  CameraRig rig;
  for (const CameraCalibration& camera : ringOfFour()) rig.emplace_back(camera);
  RunReport report(path("report"), model, rig, std::nullopt, false, kMost);
  PipelineResult nobody;
  nobody.masks.resize(rig.size());
  for (size_t i = 0; i < kFrameSets; ++i)
    report.add({int64_t(i) * kPeriod_ns, std::vector<CameraFrame>(rig.size()), {}}, nobody);
  report.write("a run");
  const Json content = contentOf(bytesOf("report/report.html"));
  const Json player = partsUnder(content, "", "player").at(0);
  EXPECT_EQ(floatsOf(player["seconds"]), (std::vector<float>{0, 4, 8}));
  const std::vector<Json> texts = partsUnder(content, "", "text");
  EXPECT_TRUE(std::any_of(texts.begin(), texts.end(), [](const Json& text) {
    return text["text"].get<std::string>().find("one in 4 of 11 frame sets") != std::string::npos;
  }));
}

}  // namespace
}  // namespace markerless_mocap
