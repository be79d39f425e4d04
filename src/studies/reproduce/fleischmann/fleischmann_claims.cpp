#include <algorithm>
#include <cmath>

#include "studies/reproduce/fleischmann/fleischmann_report.h"
#include "studies/reproduce/result_cache.h"
#include "tools/common/number_format.h"

namespace markerless_mocap {
namespace {

// Means that differ by less than this fraction are called equal; "much worse" is twice as much.
constexpr double kEqual = 0.1, kMuch = 0.2;

std::string meanAndMax(const VariantResults& found) {
  return "mean " + mm(found.mean()) + ", maximum " + mm(found.max());
}

Verdict verdictOf(bool all, bool some) {
  return all ? Verdict::kHolds : some ? Verdict::kHoldsPartly : Verdict::kDoesNotHold;
}

bool equalMeans(const VariantResults& a, const VariantResults& b) {
  return std::abs(a.mean() - b.mean()) < kEqual * b.mean();
}

bool worse(const VariantResults& a, const VariantResults& b, double by = 0.0) {
  return a.mean() > (1.0 + by) * b.mean();
}

/// Numbers of two variants.
std::string against(const char* first, const VariantResults& a, const char* second,
                    const VariantResults& b) {
  return std::string(first) + " " + meanAndMax(a) + "; " + second + " " + meanAndMax(b);
}

/// Largest error of a marker in the first run, mm.
double markerMax(const VariantResults& found, const char* marker) {
  const std::vector<double> errors = numbersOf(found.json(0)["markers"][marker]);
  return *std::max_element(errors.begin(), errors.end());
}

int peaks(const std::vector<double>& values) {
  int count = 0;
  for (size_t i = 1; i + 1 < values.size(); ++i)
    count += values[i] > values[i - 1] && values[i] >= values[i + 1];
  return count;
}

/// Claims about one kind of variants, made by name.
class Claims {
 public:
  explicit Claims(const Results& results) : results_(results) {}

  void accuracy() {
    for (const bool fast : {true, false}) {
      const VariantResults found = of(fast ? "base60" : "base20");
      const double mean = fast ? 38.0 : 46.3, most = fast ? 86.4 : 129.4;
      add(fast ? "Fig. 6.5(a), p. 49" : "Fig. 6.5(b), p. 49",
          std::string(fast ? "60 fps" : "20 fps") + ": mean " + mm(mean) + " mm, maximum " +
              mm(most) + " mm",
          meanAndMax(found), found.mean() <= mean && found.max() <= most,
          found.mean() <= mean || found.max() <= most);
    }
    const VariantResults fast = of("base60"), slow = of("base20");
    add("6.3, p. 49", "the mean error is a little smaller at 60 fps, the tracking more stable",
        against("60 fps", fast, "20 fps", slow),
        fast.mean() < slow.mean() && fast.max() < slow.max(), fast.mean() < slow.mean());
    const double still = slow.meanWithin(kStandsFrom, kStandsTo);
    add("6.3, p. 49", "the tracking is always very good in the standstill",
        mm(still) + " mm while standing, " + mm(slow.mean()) + " over all, 20 fps",
        still < (1.0 - kMuch) * slow.mean(), still < slow.mean());
    const double last = slow.D(0).back();
    add("6.3, p. 49", "limbs are lost at 20 fps, and found again",
        "up to " + mm(slow.max()) + " mm, " + mm(last) + " at the end", last < slow.mean() * 1.5,
        last < slow.max());
  }

  void evaluations() {
    const VariantResults base = of("base60"), two = of("eval2000"), four = of("eval4000");
    add("Table 6.2, p. 50",
        "1000, 2000, 4000 evaluations: mean 38.0, 37.3, 35.7, hardly less; maximum 86.4, 82.3, "
        "56.7",
        "mean " + mm(base.mean()) + ", " + mm(two.mean()) + ", " + mm(four.mean()) + "; maximum " +
            mm(base.max()) + ", " + mm(two.max()) + ", " + mm(four.max()),
        four.mean() <= base.mean() && equalMeans(four, base) && four.max() < base.max(),
        four.mean() <= base.mean() || four.max() < base.max());
  }

  void filters() {
    const VariantResults slow = of("base20"), slow_filter = of("apf20"), fast = of("base60"),
                         fast_filter = of("apf60");
    add("6.5, p. 51", "the swarm is better than the annealed particle filter at 20 fps",
        against("swarm", slow, "filter", slow_filter),
        worse(slow_filter, slow) && slow_filter.max() > slow.max(), worse(slow_filter, slow));
    add("6.5, p. 51", "and equal at 60 fps", against("swarm", fast, "filter", fast_filter),
        equalMeans(fast_filter, fast), false);
  }

  void partitions() {
    const VariantResults slow = of("base20"), fast = of("base60"), global20 = of("global20"),
                         global60 = of("global60"), three = of("three20");
    better("6.6, p. 53", "two hard stages are much worse than two soft ones, 20 fps", "hard20",
           slow, kMuch);
    better("6.6, p. 54", "one global stage is much worse, 20 fps", "global20", slow, kMuch);
    const double gap60 = global60.mean() / fast.mean(), gap20 = global20.mean() / slow.mean();
    add("6.6, p. 54", "the difference is less pronounced at 60 fps",
        formatNumber("%.2f", gap60) + " times the mean at 60 fps, " + formatNumber("%.2f", gap20) +
            " at 20 fps",
        gap60 < gap20 && gap20 > 1.0, gap60 < gap20);
    add("6.6, p. 55", "three soft stages: the same mean, a lower maximum",
        against("three", three, "two", slow), equalMeans(three, slow) && three.max() < slow.max(),
        equalMeans(three, slow) || three.max() < slow.max());
    better("6.6, p. 56", "twelve hard stages are worse with 7200 evaluations, 60 fps", "twelve60",
           fast, 0.0);
  }

  void markers() {
    const VariantResults slow = of("base20");
    const double pelvis = markerMax(slow, "pelvis");
    double limb = 0.0;
    for (const char* name : {"l_wrist", "r_wrist", "l_ankle", "r_ankle"})
      limb = std::max(limb, markerMax(slow, name));
    add("6.7, p. 57", "the pelvis is always tracked, lower limbs are lost at 20 fps",
        "largest error of the pelvis " + mm(pelvis) + ", of a wrist or ankle " + mm(limb),
        pelvis < 100.0 && limb > 3.0 * pelvis, limb > 2.0 * pelvis);
  }

  void swarmSizes() {
    const VariantResults base = of("base20"), p2 = of("p2"), p10 = of("p10"), p40 = of("p40"),
                         p400 = of("p400");
    const bool middle = equalMeans(p10, base) && equalMeans(p40, base);
    const bool ends = worse(p2, base, kEqual) && worse(p400, base, kEqual);
    add("6.8, p. 58", "10 to 40 particles do equally well, 2 and 400 do not",
        "mean of 2, 10, 20, 40, 400: " + mm(p2.mean()) + ", " + mm(p10.mean()) + ", " +
            mm(base.mean()) + ", " + mm(p40.mean()) + ", " + mm(p400.mean()),
        middle && ends, middle || worse(p2, base, kEqual) || worse(p400, base, kEqual));
  }

  void convergence() {
    const Json& spread = results_.at("convergence")["spread"];
    double left = 0.0;
    for (const char* name : {"pelvis_x", "pelvis_y", "pelvis_z"})
      left = std::max(left, numberOf(spread[name].at(19)));  // last iteration of the first stage
    add("6.9, p. 60", "the first stage reduces the spread of the position to about a tenth",
        "to " + formatNumber("%.2f", left) + " of it at most", left < 0.2, left < 0.5);
  }

  void terms() {
    const VariantResults base = of("base20"), alone = of("silhouettes20");
    const Json& curves = results_.at("curves");
    const int smooth = peaks(numbersOf(curves["silhouette"]));
    const int rough = peaks(numbersOf(curves["edge"]));
    add("6.10, Fig. 6.19", "the silhouette term is smoother than the edge term",
        std::to_string(smooth) + " and " + std::to_string(rough) + " local maxima", smooth < rough,
        smooth <= rough);
    const double with = base.meanWithin(kStandsFrom, kStandsTo),
                 without = alone.meanWithin(kStandsFrom, kStandsTo);
    add("6.10, Fig. 6.21", "silhouettes alone: a lower maximum, worse in the standstill",
        "maximum " + mm(alone.max()) + " against " + mm(base.max()) + "; standing " + mm(without) +
            " against " + mm(with),
        alone.max() < base.max() && without > with, alone.max() < base.max() || without > with);
    better("6.10, Fig. 6.22", "without the upper edge of the torso it is much worse, 20 fps",
           "notop20", base, kMuch);
  }

  void time() {
    const Json& time = results_.at("time");
    double total = 0.0;
    for (const auto& part : time) total += part.get<double>();
    const double drawing = time["drawing_and_silhouette"].get<double>() / total;
    add("Table 6.5, p. 64", "drawing and silhouettes take most of the time, 65 %",
        formatPercent(drawing) + " of " + formatNumber("%.0f", 1e3 * total) + " ms", drawing > 0.5,
        drawing > 0.3);
  }

  std::vector<Claim> all;

 private:
  VariantResults of(const char* variant) const { return {results_, variant}; }
  void add(std::string place, std::string sentence, std::string ours, bool holds, bool partly) {
    all.push_back(
        {std::move(place), std::move(sentence), std::move(ours), verdictOf(holds, partly)});
  }
  /// A variant is worse than another one, by a fraction of the mean.
  void better(const char* place, const char* sentence, const char* variant,
              const VariantResults& than, double by) {
    const VariantResults found = of(variant);
    add(place, sentence, against("it", found, "base", than), worse(found, than, by),
        worse(found, than) || found.max() > than.max());
  }

  const Results& results_;
};

}  // namespace

std::vector<Claim> fleischmannClaims(const Results& results) {
  Claims claims(results);
  claims.accuracy();
  claims.evaluations();
  claims.filters();
  claims.partitions();
  claims.markers();
  claims.swarmSizes();
  claims.convergence();
  claims.terms();
  claims.time();
  return claims.all;
}

}  // namespace markerless_mocap
