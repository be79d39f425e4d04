#include "studies/reproduce/hsiao/hsiao_report.h"
#include "studies/reproduce/hsiao/hsiao_totals.h"
#include "studies/reproduce/result_cache.h"
#include "tools/common/number_format.h"

namespace markerless_mocap {
namespace {

constexpr double kAtLeastAsGood = 0.01;  // shares that differ by less are equal

Verdict better(double ours, double other, double slack) {
  if (ours > other + slack) return Verdict::kHolds;
  return ours < other - slack ? Verdict::kDoesNotHold : Verdict::kHoldsPartly;
}

std::vector<Claim> hullClaims(const Results& results) {
  const double eight = numberOf(results.at("figures")["litres_8"]);
  const double four = numberOf(results.at("figures")["litres_4"]);
  const double top = numberOf(results.at("overhead")["litres"]);
  return {{"3.1.3, Figure 3-8", "four of eight cameras leave ghost legs and artifacts",
           formatNumber("hulls of four cameras are %.0f %% larger", 100 * (four / eight - 1)),
           four > 1.1 * eight ? Verdict::kHolds : Verdict::kDoesNotHold},
          {"ch. 4, Figure 4-1", "one camera above gives fewer artifacts than eight in a circle",
           formatNumber("mean hull %.1f l", top) + formatNumber(" against %.1f l", eight),
           top < eight ? Verdict::kHolds : Verdict::kDoesNotHold}};
}

std::vector<Claim> partClaims(const Results& results) {
  const PartTotals published = partsOf(results, "published");
  const PartTotals original = partsOf(results, "original");
  const PartTotals no_color = partsOf(results, "no_colour");
  const PartTotals combined = partsOf(results, "site_values_combined");
  const Json& head = results.at("plane")["head"];
  const bool kept = head["modified, colours"].get<bool>(), lost = !head["modified"].get<bool>();
  return {
      {"3.1.4.2, Figures 3-12, 3-14", "in the image, shrinking loses the head and colours keep it",
       std::string("the head has a branch ") +
           (lost ? "only with colours" : "without colours, too") +
           (kept ? "" : "; with colours it has none"),
       kept && lost ? Verdict::kHolds
       : kept       ? Verdict::kHoldsPartly
                    : Verdict::kDoesNotHold},
      {"3.1.4.2, Figure 3-15", "the modified Laplacian makes the segmentation better",
       "voxels right " + wholePercent(published.correct) + " against " +
           wholePercent(original.correct) + ", torso found " + wholePercent(published.found[0]) +
           " against " + wholePercent(original.found[0]),
       better(published.correct, original.correct, kAtLeastAsGood)},
      {"3.1.4.2", "colour votes keep the head from being drawn to the torso",
       "head found " + wholePercent(published.found[1]) + " with, " +
           wholePercent(no_color.found[1]) + " without; arms " +
           wholePercent((published.found[2] + published.found[3]) / 2) + " and " +
           wholePercent((no_color.found[2] + no_color.found[3]) / 2),
       better(published.found[1], no_color.found[1], kAtLeastAsGood)},
      {"3.1.5.2", "one dimension gives a curve for any part, however thick",
       "torso " + wholeMillimetres(published.curve[0]) + " from its axis, limbs " +
           wholeMillimetres((published.curve[2] + published.curve[3]) / 2) +
           "; with several modes combined " + wholeMillimetres(combined.curve[0]) + " and " +
           wholeMillimetres((combined.curve[2] + combined.curve[3]) / 2),
       published.curve[0] <= combined.curve[0] + 5.0 ? Verdict::kHolds : Verdict::kHoldsPartly}};
}

std::vector<Claim> poseClaims(const Results& results) {
  const HsiaoTotals totals = totalsOf(results);
  const Tracked published = trackedOf(totals.published), basic = trackedOf(totals.basic);
  const double ours = summaryStatistics(totals.ours).mean;
  const double good = shareWithin(totals.published, 100.0);
  const bool smoother = published.jitter < basic.jitter;
  const bool nearer = published.D.mean < basic.D.mean;
  return {
      {"3.2.1.2, Figure 3-20", "with self spin the model turns to the right orientation",
       "left and right exchanged in " + wholePercent(published.swaps) + " of the frames",
       published.swaps < 0.05   ? Verdict::kHolds
       : published.swaps < 0.25 ? Verdict::kHoldsPartly
                                : Verdict::kDoesNotHold},
      {"3.2.2.5", "the temporal swarm makes poses consistent in time, and errors do not propagate",
       "jitter " + wholeMillimetres(published.jitter) + " against " +
           wholeMillimetres(basic.jitter) + " of the basic " + "swarm alone; D " +
           wholeMillimetres(published.D.mean) + " against " + wholeMillimetres(basic.D.mean),
       smoother && nearer   ? Verdict::kHolds
       : smoother || nearer ? Verdict::kHoldsPartly
                            : Verdict::kDoesNotHold},
      {"ch. 4", "the system handles nine kinds of motion",
       "D " + wholeMillimetres(published.D.mean) + " (median " +
           wholeMillimetres(published.D.median) + "), at most " + "100 mm in " +
           wholePercent(good) + " of the frames; " + wholeMillimetres(published.D_of_six.mean) +
           " in the " + wholePercent(published.six) +
           " whose segmentation has six parts; no pose in " + wholePercent(published.lost) +
           "; this package's default " + wholeMillimetres(ours) + ", no pose in " +
           wholePercent(summaryStatistics(totals.ours_lost).mean),
       good >= 0.9   ? Verdict::kHolds
       : good >= 0.5 ? Verdict::kHoldsPartly
                     : Verdict::kDoesNotHold}};
}

}  // namespace

std::vector<Claim> hsiaoClaims(const Results& results) {
  std::vector<Claim> claims = hullClaims(results);
  for (const auto& more : {partClaims(results), poseClaims(results)})
    claims.insert(claims.end(), more.begin(), more.end());
  return claims;
}

}  // namespace markerless_mocap
