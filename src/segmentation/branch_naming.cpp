#include "markerless_mocap/segmentation/branch_naming.h"

#include <algorithm>
#include <limits>

namespace markerless_mocap {
namespace {

constexpr double kClip = 9.0;       // of a squared z-score: one odd measure is not the end
constexpr double kAllowance = 3.0;  // squared z-score up to which a measure speaks for a name

enum Kind { kHeadKind, kArmKind, kLegKind, kKinds };

struct Normal {
  double mean;
  double deviation;
};

// Logarithms as in BranchMeasures, of clothed adults walking and moving their arms. Deviations are
// at least 10 % of a length, 12 % of a thickness and 25 % of a volume, to leave room for other
// bodies and clothes.
constexpr Normal kVolumeShare[kKinds] = {{-2.57, 0.25}, {-3.10, 0.35}, {-1.95, 0.40}};
constexpr Normal kLength[kKinds] = {{-0.04, 0.16}, {0.54, 0.15}, {0.72, 0.20}};
constexpr Normal kThickness[kKinds] = {{-2.71, 0.12}, {-3.03, 0.12}, {-2.76, 0.14}};
constexpr Normal kTipDistance[kKinds][kKinds] = {
    {{0.0, 1.0}, {0.87, 0.09}, {1.41, 0.09}},
    {{0.87, 0.09}, {1.26, 0.10}, {1.53, 0.10}},
    {{1.41, 0.09}, {1.53, 0.10}, {1.30, 0.25}},
};

constexpr PartLabel kRoles[] = {PartLabel::kHead, PartLabel::kLeg1, PartLabel::kLeg2,
                                PartLabel::kArm1, PartLabel::kArm2};
constexpr Kind kKindOfRole[] = {kHeadKind, kLegKind, kLegKind, kArmKind, kArmKind};
constexpr int kRoleCount = 5;

double squaredScore(const Normal& normal, double value) {
  const double z = (value - normal.mean) / normal.deviation;
  return std::min(z * z, kClip);
}

double ownScores(const BranchMeasures::Own& own, Kind kind) {
  return squaredScore(kVolumeShare[kind], own.volume_share) +
         squaredScore(kLength[kind], own.length) + squaredScore(kThickness[kind], own.thickness);
}

/// Depth-first search over the roles; every assignment is scored.
class Assignment {
 public:
  explicit Assignment(const BranchMeasures& measures) : measures_(measures) {
    branch_.fill(-1);
    best_branch_ = branch_;
  }

  BranchNames best() {
    tryRole(0, 0.0, 0);
    BranchNames names;
    names.branch.fill(-1);
    for (int r = 0; r < kRoleCount; ++r) names.branch[size_t(kRoles[r])] = best_branch_[r];
    names.cost = best_terms_ == 0 ? std::numeric_limits<double>::infinity()
                                  : best_ / best_terms_ + kAllowance;
    return names;
  }

 private:
  void tryRole(int role, double score, int terms) {
    if (role == kRoleCount) {
      if (score < best_) {
        best_ = score;
        best_terms_ = terms;
        best_branch_ = branch_;
      }
      return;
    }
    const bool second = role > 0 && kKindOfRole[role] == kKindOfRole[role - 1];
    const int first_branch = second ? branch_[role - 1] + 1 : 0;
    // Without a first arm (leg) there is no second.
    const bool possible = !second || branch_[role - 1] >= 0;
    for (int b = first_branch; possible && b < int(measures_.own.size()); ++b) {
      if (std::find(branch_.begin(), branch_.begin() + role, b) != branch_.begin() + role) continue;
      branch_[role] = b;
      int added = 0;
      const double gain = termsOf(role, b, &added);
      tryRole(role + 1, score + gain, terms + added);
    }
    branch_[role] = -1;
    tryRole(role + 1, score, terms);
  }

  double termsOf(int role, int branch, int* count) const {
    const Kind kind = kKindOfRole[role];
    double sum = ownScores(measures_.own[branch], kind);
    *count = 3;
    for (int r = 0; r < role; ++r) {
      if (branch_[r] < 0) continue;
      sum += squaredScore(kTipDistance[kind][kKindOfRole[r]],
                          measures_.tip_distance(branch, branch_[r]));
      ++*count;
    }
    return sum - kAllowance * *count;
  }

  const BranchMeasures& measures_;
  std::array<int, kRoleCount> branch_;
  std::array<int, kRoleCount> best_branch_;
  double best_ = 0.0;
  int best_terms_ = 0;
};

}  // namespace

BranchNames nameBranches(const BranchMeasures& measures) {
  return Assignment(measures).best();
}

}  // namespace markerless_mocap
