#include "studies/reproduce/run_list.h"

#include <gtest/gtest.h>

#include <atomic>
#include <filesystem>
#include <sstream>

#include "error_text_of.h"
#include "studies/reproduce/reproduce.h"
#include "studies/reproduce/work_progress.h"

namespace markerless_mocap {
namespace {

namespace fs = std::filesystem;

class RunList : public testing::Test {
 protected:
  RunList() : folder_(fs::path(testing::TempDir()) / "mocap_run_list") { fs::remove_all(folder_); }
  ~RunList() override { fs::remove_all(folder_); }

  PaperRun counted(const std::string& name, double value) {
    PaperRun run;
    run.name = name;
    run.settings = {{"value", value}};
    run.work = [this, value] {
      ++executed_;
      return Json{{"twice", 2.0 * value}};
    };
    return run;
  }

  fs::path folder_;
  std::atomic<int> executed_{0};
};

TEST_F(RunList, whatHasBeenDoneWithTheSameSettingsIsNotDoneAgain) {
  const ResultCache cache(folder_);
  std::vector<PaperRun> runs{counted("a", 1.0), counted("b", 2.0), counted("c", 3.0)};
  runs[2].alone = true;
  EXPECT_EQ(executeRuns(runs, cache, {}).at("c")["twice"], 6.0);
  EXPECT_EQ(executed_, 3);
  runs[1] = counted("b", 5.0);
  const Results again = executeRuns(runs, cache, {});
  EXPECT_EQ(executed_, 4);
  EXPECT_EQ(again.at("a")["twice"], 2.0);
  EXPECT_EQ(again.at("b")["twice"], 10.0);
  RunListOptions all;
  all.again = true;
  executeRuns(runs, cache, all);
  EXPECT_EQ(executed_, 7);
}

TEST_F(RunList, aFailureIsToldAfterTheOthersAreDoneAndKept) {
  const ResultCache cache(folder_);
  std::vector<PaperRun> runs{counted("bad", 1.0), counted("b", 2.0), counted("c", 3.0)};
  runs[0].work = []() -> Json { throw std::runtime_error("no film"); };
  EXPECT_EQ(errorTextOf<std::runtime_error>([&] { executeRuns(runs, cache, {}); }), "bad: no film");
  EXPECT_EQ(executed_, 2);
  runs[0] = counted("bad", 1.0);
  executeRuns(runs, cache, {});
  EXPECT_EQ(executed_, 3);
  runs[1].name = "c";
  EXPECT_EQ(errorTextOf([&] { executeRuns(runs, cache, {}); }), "two runs are named c");
}

TEST_F(RunList, aDamagedFileIsDoneAgain) {
  const ResultCache cache(folder_);
  const std::vector<PaperRun> runs{counted("a", 1.0)};
  executeRuns(runs, cache, {});
  fs::resize_file(cache.file("a", runs[0].settings, ".json"), 20);
  EXPECT_EQ(executeRuns(runs, cache, {}).at("a")["twice"], 2.0);
  EXPECT_EQ(executed_, 2);
}

TEST_F(RunList, aPageHasTheClaimsFirst) {
  struct OneClaim : Paper {
    std::string title() const override { return "Nobody 2000"; }
    std::vector<Capture> captures() const override { return {}; }
    std::vector<PaperRun> runs(const std::vector<Capture>&) const override { return own; }
    std::vector<Claim> report(const Results& results, Page* page) const override {
      page->heading("Table 1");
      return {{"p. 3", "it is \"fast\"", results.at("a")["twice"].dump(), Verdict::kHoldsPartly}};
    }
    std::vector<PaperRun> own;
  } paper;
  paper.own = {counted("a", 4.0)};
  ReproduceRequest request;
  request.folder = folder_;
  const std::vector<Claim> claims = reproduce(paper, request, {}, {});
  ASSERT_EQ(claims.size(), 1u);
  EXPECT_EQ(claimsCsv(claims),
            "place,sentence,ours,verdict\n\"p. 3\",\"it is \"\"fast\"\"\",\"8.0\",holds partly\n");
  EXPECT_TRUE(fs::exists(folder_ / "index.html"));
  EXPECT_TRUE(fs::exists(folder_ / "results.json"));
  Page body("");
  body.heading("Table 1");
  const Json parts = paperPage("Nobody 2000", claims, body).content()["parts"];
  ASSERT_EQ(parts.size(), 3u);
  EXPECT_EQ(parts[1]["rows"][0][3], "holds partly");
  EXPECT_EQ(parts[2]["text"], "Table 1");
}

TEST(ResultCache, numbersThatAreNotFiniteComeBackAsNan) {
  const std::vector<double> numbers = numbersOf(Json::parse("[1.5, null]"));
  EXPECT_EQ(numbers[0], 1.5);
  EXPECT_TRUE(std::isnan(numbers[1]));
  EXPECT_EQ(settingsHash({{"a", 1}}).size(), 16u);
  EXPECT_NE(settingsHash({{"a", 1}}), settingsHash({{"a", 2}}));
}

TEST(WorkProgress, tellsWhatIsDoneAndWhatIsLeft) {
  std::ostringstream out;
  WorkProgress progress(4.0, &out, false);
  progress.add("base", 1.0);
  EXPECT_EQ(out.str().substr(0, 12), "25 %, about ");
  EXPECT_NE(out.str().find("left: base\n"), std::string::npos);
  EXPECT_EQ(durationText(20.2), "20 s");
  EXPECT_EQ(durationText(160.0), "3 min");
  EXPECT_EQ(durationText(7500.0), "2 h 5 min");
}

}  // namespace
}  // namespace markerless_mocap
