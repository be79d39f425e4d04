#include "segmentation/limbs/part_naming.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <vector>

namespace markerless_mocap {
namespace {

/// Clips squared z-scores, so that one outlier does not exclude an assignment.
constexpr double kClip = 9.0;
constexpr double kAllowance = 3.0;  // up to this squared z-score a measure supports an assignment

constexpr double kNever = 100.0;  // cost of two arms that are the same limb

enum Kind { kHeadKind, kArmKind, kLegKind, kKinds };

struct Normal {
  double mean;
  double deviation;
};

// Logarithms as in ExtremityMeasures, of clothed adults who walk and move their arms. Standard
// deviations are at least 9 % of a length and 15 % of a volume, to allow for other bodies and
// clothes.
constexpr Normal kFullness[kKinds] = {{-2.78, 0.2}, {-4.6, 0.5}, {-3.75, 0.5}};
constexpr Normal kToCore[kKinds] = {{-0.05, 0.16}, {0.4, 0.25}, {0.72, 0.2}};
// For upright people; in other poses the other measures decide.
constexpr Normal kHeight[kKinds] = {{0.95, 0.12}, {0.55, 0.25}, {0.03, 0.12}};
constexpr Normal kDistance[kKinds][kKinds] = {
    {{0.0, 1.0}, {0.86, 0.13}, {1.40, 0.11}},
    {{0.86, 0.13}, {1.10, 0.25}, {1.40, 0.18}},
    {{1.40, 0.11}, {1.40, 0.18}, {1.20, 0.5}},
};

// All lengths of a stout body, or of a hull with arms at its sides, are shorter in cube roots of
// its volume. These offsets of the logarithms are tried.
constexpr double kBuilds[] = {-0.4, -0.35, -0.3, -0.25, -0.2, -0.15, -0.1, -0.05, 0.0, 0.05, 0.1};
constexpr double kBuildDeviation = 0.12;

// Volumes of the branches, also logarithms.
constexpr Normal kVolumeFraction[kKinds] = {{-3.0, 0.3}, {-3.65, 0.4}, {-1.85, 0.35}};
constexpr Normal kThickness[kKinds] = {{-2.72, 0.12}, {-3.2, 0.13}, {-2.72, 0.18}};
constexpr double kMaxLeg = 0.33;  // fraction of the hull's nodes; more are two legs
// Maximum sum of the two squared z-scores of a plausible branch; arms that touch the body are
// shortened.
constexpr double kMaxSquare[kKinds] = {12.0, 25.0, 12.0};

constexpr PartLabel kRoles[] = {PartLabel::kHead, PartLabel::kLeg1, PartLabel::kLeg2,
                                PartLabel::kArm1, PartLabel::kArm2};
constexpr Kind kKindOfRole[] = {kHeadKind, kLegKind, kLegKind, kArmKind, kArmKind};
constexpr int kRoleCount = 5;
constexpr int kOwnTerms = 3;  // number of terms of a single extremity

/// Whether the path from one of two extremities to the core passes the other.
bool onOneLimb(const ExtremityMeasures& measures, int a, int b) {
  return measures.distance(a, b) < std::max(measures.to_core[a], measures.to_core[b]);
}

double squaredScore(const Normal& normal, double value) {
  const double z = (value - normal.mean) / normal.deviation;
  return std::min(z * z, kClip);
}

/// Squared z-scores of each extremity, and each pair, for each kind of part.
class Scores {
 public:
  Scores(const ExtremityMeasures& measures, double build)
      : extremities_(int(measures.to_core.size())) {
    for (int kind = 0; kind < kKinds; ++kind) {
      for (int extremity = 0; extremity < extremities_; ++extremity) {
        own_.push_back(squaredScore(kFullness[kind], measures.fullness[extremity]) +
                       squaredScore(kToCore[kind], measures.to_core[extremity] - build) +
                       squaredScore(kHeight[kind], measures.height[extremity]));
      }
    }
    for (int pair = 0; pair < kKinds * kKinds; ++pair) {
      const Normal& normal = kDistance[pair / kKinds][pair % kKinds];
      for (int a = 0; a < extremities_; ++a) {
        for (int b = 0; b < extremities_; ++b) {
          const bool arms = pair == kArmKind * kKinds + kArmKind;
          distance_.push_back(squaredScore(normal, measures.distance(a, b) - build) +
                              (arms && onOneLimb(measures, a, b) ? kNever : 0.0));
        }
      }
    }
  }

  int extremities() const { return extremities_; }
  double own(Kind kind, int extremity) const { return own_[kind * extremities_ + extremity]; }
  double distance(Kind kind, int extremity, Kind other_kind, int other) const {
    return distance_[((kind * kKinds + other_kind) * extremities_ + extremity) * extremities_ +
                     other];
  }

 private:
  int extremities_;
  std::vector<double> own_;
  std::vector<double> distance_;
};

/// Depth-first search over the parts with branch and bound.
class Assignment {
 public:
  explicit Assignment(const Scores& scores) : scores_(scores) {
    extremity_.fill(-1);
    best_extremity_ = extremity_;
  }

  /// Sum of the terms of the best assignment, each minus the allowance.
  double solve() {
    tryRole(0, 0.0, 0, 0);
    return best_;
  }

  PartNaming names() const {
    PartNaming names;
    names.extremity.fill(-1);
    for (int r = 0; r < kRoleCount; ++r) names.extremity[size_t(kRoles[r])] = best_extremity_[r];
    names.cost = best_terms_ == 0 ? std::numeric_limits<double>::infinity()
                                  : best_ / best_terms_ + kAllowance;
    return names;
  }

 private:
  void tryRole(int role, double score, int terms, int named) {
    if (role == kRoleCount) {
      if (score < best_) {
        best_ = score;
        best_terms_ = terms;
        best_extremity_ = extremity_;
      }
      return;
    }
    if (score - kAllowance * maxTerms(role, named) > best_) return;
    const bool second = role > 0 && kKindOfRole[role] == kKindOfRole[role - 1];
    const int first_extremity = second ? extremity_[role - 1] + 1 : 0;
    // There is no second arm (leg) without a first.
    const bool possible = !second || extremity_[role - 1] >= 0;
    for (int b = first_extremity; possible && b < scores_.extremities(); ++b) {
      if (std::find(extremity_.begin(), extremity_.begin() + role, b) != extremity_.begin() + role)
        continue;
      extremity_[role] = b;
      int added = 0;
      const double gain = termsOf(role, b, &added);
      tryRole(role + 1, score + gain, terms + added, named + 1);
    }
    extremity_[role] = -1;
    tryRole(role + 1, score, terms, named);
  }

  /// Number of terms that the parts from `role` on add if all of them are assigned.
  static int maxTerms(int role, int named) {
    int terms = 0;
    for (; role < kRoleCount; ++role, ++named) terms += kOwnTerms + named;
    return terms;
  }

  double termsOf(int role, int extremity, int* count) const {
    const Kind kind = kKindOfRole[role];
    double sum = scores_.own(kind, extremity);
    *count = kOwnTerms;
    for (int r = 0; r < role; ++r) {
      if (extremity_[r] < 0) continue;
      sum += scores_.distance(kind, extremity, kKindOfRole[r], extremity_[r]);
      ++*count;
    }
    return sum - kAllowance * *count;
  }

  const Scores& scores_;
  std::array<int, kRoleCount> extremity_;
  std::array<int, kRoleCount> best_extremity_;
  double best_ = 0.0;
  int best_terms_ = 0;
};

}  // namespace

PartNaming assignParts(const ExtremityMeasures& measures) {
  PartNaming best;
  double min_score = std::numeric_limits<double>::infinity();
  for (const double build : kBuilds) {
    const Scores scores(measures, build);
    Assignment assignment(scores);
    const double unusual = build / kBuildDeviation;
    const double score = assignment.solve() + unusual * unusual;
    if (score >= min_score) continue;
    min_score = score;
    best = assignment.names();
  }
  return best;
}

bool isPlausible(PartLabel label, double volume_fraction, double thickness) {
  const auto role = std::find(std::begin(kRoles), std::end(kRoles), label);
  const Kind kind = kKindOfRole[role - std::begin(kRoles)];
  if (kind == kLegKind && volume_fraction > kMaxLeg) return false;
  const double volume =
      (std::log(volume_fraction) - kVolumeFraction[kind].mean) / kVolumeFraction[kind].deviation;
  const double depth = (std::log(thickness) - kThickness[kind].mean) / kThickness[kind].deviation;
  return volume * volume + depth * depth <= kMaxSquare[kind];
}

}  // namespace markerless_mocap
