#include "studies/reproduce/bakken/bakken_report.h"

#include <gtest/gtest.h>

#include <cmath>

#include "ros/package_files.h"
#include "studies/common/bakken_variants.h"
#include "studies/reproduce/bakken/bakken_results.h"

namespace markerless_mocap {
namespace {

/// Four frames of which the third is wrong but valid and the last is invalid; a hand is raised in
/// the last two.
Json labels(double error_mm) {
  Json film{{"seconds", {0.0, 0.1, 0.2, 0.3}}, {"raised", {0, 0, 1, 1}}};
  for (const BakkenVariant& variant : bakkenVariants()) {
    Json one{{"right", {1, 1, 0, 0}},      {"correct", {1, 1, 0, 1}}, {"valid", {1, 1, 1, 0}},
             {"rank", {0.1, 0.1, 0.1, 0}}, {"arm", {0.3, 0.2}},       {"neck", {0.1, 0.1}}};
    for (const char* extremity : {"head", "left_hand", "right_hand", "left_foot", "right_foot"})
      one[extremity] = {error_mm, error_mm + 10.0, 500.0, nullptr};
    film[variant.id] = one;
  }
  return film;
}

Json follows(int step, int pairs, int exchanged, int astray = 0) {
  return {{"step", step}, {"pairs", pairs}, {"exchanged", exchanged}, {"astray", astray}};
}

Results results(double error_mm) {
  Results results;
  for (const char* edge : {"64", "128"}) {
    results["labels_whirl_" + std::string(edge)] = labels(error_mm);
    results["times_whirl_" + std::string(edge)] = {
        {"hull", {4.0, 6.0}}, {"thinning", {2.0, 2.0}}, {"tree", {1.0, 1.0}}};
    results["follow_whirl_" + std::string(edge)] = {{"every", {follows(1, 20, 0)}}};
  }
  return results;
}

Verdict verdictOf(const std::vector<Claim>& claims, const std::string& start) {
  for (const Claim& claim : claims)
    if (claim.sentence.compare(0, start.size(), start) == 0) return claim.verdict;
  ADD_FAILURE() << "no claim " << start;
  return Verdict::kNotMeasured;
}

TEST(BakkenReport, ErrorsAreOfRightFramesAndSharesOfAll) {
  const Results all = results(30.0);
  const LabelResult found(all, "whirl", 128, "published");
  EXPECT_DOUBLE_EQ(found.right(), 0.5);
  EXPECT_DOUBLE_EQ(found.correct(), 0.75);
  EXPECT_DOUBLE_EQ(found.wrongButValid(), 0.25);
  EXPECT_DOUBLE_EQ(found.rightWhere(false), 1.0);
  EXPECT_DOUBLE_EQ(found.rightWhere(true), 0.0);
  EXPECT_DOUBLE_EQ(summaryStatistics(found.curve()).mean, 35.0);
  EXPECT_TRUE(std::isnan(found.curve()[2]));
  EXPECT_EQ(meanAndDeviation(found.error("head")).substr(0, 6), "35.0 (");
}

TEST(BakkenReport, DurationsAreSummedFrameByFrame) {
  const SummaryStatistics sum = stageTime(results(30.0), "whirl", 64, "sum");
  EXPECT_DOUBLE_EQ(sum.mean, 8.0);
  EXPECT_GT(sum.deviation, 0.9);
  EXPECT_EQ(stageTime(results(30.0), "walk", 64, "sum").count, 0u);
}

TEST(BakkenReport, VerdictsFollowThePapersFigures) {
  Page page("");
  const std::vector<Claim> good = bakkenReport(results(30.0), &page),
                           bad = bakkenClaims(results(60.0));
  EXPECT_EQ(verdictOf(good, "128 voxels: hands and feet"), Verdict::kHolds);
  EXPECT_EQ(verdictOf(bad, "128 voxels: hands and feet"), Verdict::kDoesNotHold);
  EXPECT_EQ(verdictOf(good, "128 voxels: 95.8 %"), Verdict::kDoesNotHold);
  EXPECT_EQ(verdictOf(good, "walk: 100 %"), Verdict::kNotMeasured);
  EXPECT_EQ(verdictOf(good, "the tree is built"), Verdict::kHolds);
}

TEST(BakkenReport, LabelsThatGoAstrayAreCountedOverAllCaptures) {
  Results all = results(30.0);
  const char* sentence = "labels that follow the last frame";
  EXPECT_EQ(verdictOf(bakkenClaims(all), sentence), Verdict::kNotMeasured);
  all["labels_ballet_128"] = labels(30.0);
  all["follow_ballet_128"] = {
      {"every", {follows(1, 9, 0), follows(2, 5, 2)}}, {"jpeg", "AA=="}, {"frame", 7}, {"step", 2}};
  EXPECT_EQ(verdictOf(bakkenClaims(all), sentence), Verdict::kHolds);
  Page page("");
  bakkenReport(all, &page);
  EXPECT_NE(page.html().find("frames 7 and 9"), std::string::npos);
}

TEST(BakkenReport, LabelsThatStayWrongAreNoRecovery) {
  Results all = results(30.0);
  const char* sentence = "the approach recovers";
  EXPECT_EQ(verdictOf(bakkenClaims(all), sentence), Verdict::kHolds);
  all["labels_walk_128"] = labels(30.0);
  all["follow_walk_128"] = {{"every", {follows(1, 9, 0, 3), follows(2, 5, 0, 40)}}};
  EXPECT_EQ(verdictOf(bakkenClaims(all), sentence), Verdict::kHoldsPartly);
  all["follow_walk_128"] = {{"every", {follows(1, 9, 0, 40)}}};
  EXPECT_EQ(verdictOf(bakkenClaims(all), sentence), Verdict::kDoesNotHold);
}

TEST(BakkenReport, EveryVariantHasOptions) {
  const std::string published = readText(MOCAP_SOURCE_DIR "/config/as_published/bakken.yaml");
  for (const BakkenVariant& variant : bakkenVariants())
    EXPECT_EQ(optionsOf(variant, published).labelling, variant.product ? "template" : "ranking")
        << variant.id;
  EXPECT_DOUBLE_EQ(optionsOf(bakkenVariants().front(), published).prune_ratio, 0.274);
}

}  // namespace
}  // namespace markerless_mocap
