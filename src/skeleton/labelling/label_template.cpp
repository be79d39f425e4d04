#include "skeleton/label_template.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "skeleton/labelling/label_loops.h"
#include "skeleton/labelling/label_proportions.h"
#include "skeleton/labelling/label_weights.h"

namespace markerless_mocap {
namespace {

constexpr size_t kHeads = 4, kHands = 7, kFeet = 6;  // candidates of each kind
constexpr double kShortest = 0.7, kTallest = 2.2;    // mean way from the head to the feet, metres
constexpr double kSpur = 0.03;  // branches shorter than this share of the longest path are none
constexpr size_t kMostEnds = 24;
constexpr double kSame = 0.12;       // metres
constexpr double kMostUnlike = 0.5;  // log ratio of the ways to the feet

double curve(BodyCurve which, double x) {
  return kBodyCurves[size_t(which)](x);
}

struct Heights {
  double lowest, highest;
};

Heights heightsOf(const TreeGraph& graph) {
  Heights h{graph.positions.front().z(), graph.positions.front().z()};
  for (const Eigen::Vector3d& p : graph.positions) {
    h.lowest = std::min(h.lowest, p.z());
    h.highest = std::max(h.highest, p.z());
  }
  return h;
}

/// Ways and log-odds of the ends of one skeleton.
class EndTable {
 public:
  EndTable(const SkeletonEnds& ends, const TreeGraph& graph)
      : ends_(ends.ends), count_(ends_.size()), heights_(heightsOf(graph)) {
    for (const SkeletonEnd& end : ends_) tips_.push_back(end.position + end.extent * end.direction);
    tree_ = withExtents(ends.tree_ways);
    short_ = withExtents(ends.short_ways);
    for (size_t role = 0; role < 3; ++role)
      for (size_t end = 0; end < count_; ++end)
        odds_[role].push_back(oddsOf(role, end, ends.longest));
  }

  double treeWay(int a, int b) const { return tree_[size_t(a) * count_ + size_t(b)]; }
  double way(int a, int b) const { return short_[size_t(a) * count_ + size_t(b)]; }
  double gap(int a, int b) const { return (tips_[size_t(a)] - tips_[size_t(b)]).norm(); }
  double height(int end) const { return tips_[size_t(end)].z(); }
  double lowest() const { return heights_.lowest; }
  const SkeletonEnd& end(int end) const { return ends_[size_t(end)]; }

  /// The most likely ends of a role.
  std::vector<int> best(size_t role, size_t most) const {
    std::vector<int> order(count_);
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(),
                     [&](int a, int b) { return odds_[role][size_t(a)] > odds_[role][size_t(b)]; });
    if (order.size() > most) order.resize(most);
    return order;
  }

 private:
  std::vector<double> withExtents(std::vector<double> ways) const {
    for (size_t a = 0; a < count_; ++a)
      for (size_t b = 0; b < count_; ++b)
        if (a != b) ways[a * count_ + b] += ends_[a].extent + ends_[b].extent;
    return ways;
  }

  double oddsOf(size_t role, size_t at, double longest) const {
    const SkeletonEnd& end = ends_[at];
    double reach = 0.0;
    for (size_t b = 0; b < count_; ++b) reach = std::max(reach, tree_[at * count_ + b]);
    const double x[kEndCurveCount] = {(tips_[at].z() - heights_.lowest) / longest,
                                      (heights_.highest - tips_[at].z()) / longest,
                                      end.direction.z(),
                                      end.extent / longest,
                                      end.tip_radius / longest,
                                      end.limb_radius / longest,
                                      end.branch / longest,
                                      end.cut ? 1.0 : 0.0,
                                      reach / longest};
    double odds = kEndCurves[role].constant;
    for (size_t i = 0; i < kEndCurveCount; ++i) odds += kEndCurves[role].curves[i](x[i]);
    return odds;
  }

  const std::vector<SkeletonEnd>& ends_;
  size_t count_;
  Heights heights_;
  std::vector<Eigen::Vector3d> tips_;
  std::vector<double> tree_, short_;
  std::array<std::vector<double>, 3> odds_;
};

/// A head and two feet, and what they tell.
struct Trunk {
  int head, foot1, foot2;
  double length;  ///< mean way from the head to the feet, metres
  double low;     ///< height of the lower foot
  double score;
};

double footScore(const EndTable& t, int foot, double s) {
  const SkeletonEnd& end = t.end(foot);
  return curve(kFootUp, (t.height(foot) - t.lowest()) / s) +
         curve(kFootTipRadius, end.tip_radius / s) + curve(kFootLimbRadius, end.limb_radius / s) +
         curve(kFootBranch, end.branch / s) + curve(kFootCut, end.cut) +
         curve(kFootExtent, end.extent / s) + curve(kFootDirection, end.direction.z());
}

Trunk trunkOf(const EndTable& t, int head, int foot1, int foot2) {
  Trunk trunk{head, foot1, foot2, 0.5 * (t.way(head, foot1) + t.way(head, foot2)), 0.0, 0.0};
  const double s = trunk.length;
  trunk.low = std::min(t.height(foot1), t.height(foot2));
  const SkeletonEnd& top = t.end(head);
  trunk.score = curve(kFootFootWay, t.way(foot1, foot2) / s) +
                curve(kFootFootTreeWay, t.treeWay(foot1, foot2) / s) + curve(kHeadFeetMetres, s) +
                curve(kFeetUnlike, std::abs(std::log(t.way(head, foot1) / t.way(head, foot2)))) +
                curve(kFootFootGap, t.gap(foot1, foot2) / s) +
                curve(kHeadUp, (t.height(head) - trunk.low) / s) +
                curve(kFeetUnevenness, std::abs(t.height(foot1) - t.height(foot2)) / s) +
                curve(kHeadTipRadius, top.tip_radius / s) +
                curve(kHeadLimbRadius, top.limb_radius / s) + curve(kHeadBranch, top.branch / s) +
                curve(kHeadCut, top.cut) + curve(kHeadExtent, top.extent / s) +
                curve(kHeadDirection, top.direction.z()) + curve(kFeetTogether, foot1 == foot2) +
                footScore(t, foot1, s) + footScore(t, foot2, s);
  return trunk;
}

double handScore(const EndTable& t, const Trunk& trunk, int hand) {
  const double s = trunk.length;
  const SkeletonEnd& end = t.end(hand);
  double score =
      curve(kHeadHandWay, t.way(trunk.head, hand) / s) +
      curve(kHeadHandTreeWay, t.treeWay(trunk.head, hand) / s) +
      curve(kHandUp, (t.height(hand) - trunk.low) / s) + curve(kHandTipRadius, end.tip_radius / s) +
      curve(kHandLimbRadius, end.limb_radius / s) + curve(kHandBranch, end.branch / s) +
      curve(kHandCut, end.cut) + curve(kHandExtent, end.extent / s) +
      curve(kHandDirection, end.direction.z()) + curve(kHeadHandGap, t.gap(trunk.head, hand) / s);
  double way = 1e9, tree_way = 1e9;
  for (const int foot : {trunk.foot1, trunk.foot2}) {
    way = std::min(way, t.way(hand, trunk.head) + t.way(hand, foot) - t.way(trunk.head, foot));
    tree_way = std::min(tree_way, t.treeWay(hand, trunk.head) + t.treeWay(hand, foot) -
                                      t.treeWay(trunk.head, foot));
    score += curve(kHandFootWay, t.way(hand, foot) / s) +
             curve(kHandFootTreeWay, t.treeWay(hand, foot) / s) +
             curve(kHandFootGap, t.gap(hand, foot) / s);
  }
  score += curve(kArmWay, 0.5 * way / s) + curve(kArmTreeWay, 0.5 * tree_way / s);
  return score;
}

double handsScore(const EndTable& t, const Trunk& trunk, int hand1, int hand2) {
  const double s = trunk.length;
  const double to1 = t.treeWay(trunk.head, hand1), to2 = t.treeWay(trunk.head, hand2);
  const double neck = 0.5 * (to1 + to2 - t.treeWay(hand1, hand2));
  const double hips =
      0.5 * (t.treeWay(trunk.head, trunk.foot1) + t.treeWay(trunk.head, trunk.foot2) -
             t.treeWay(trunk.foot1, trunk.foot2));
  return curve(kHandHandWay, t.way(hand1, hand2) / s) +
         curve(kHandHandTreeWay, t.treeWay(hand1, hand2) / s) +
         curve(kHandHandGap, t.gap(hand1, hand2) / s) + curve(kNeckLength, neck / s) +
         curve(kTorsoLength, (hips - neck) / s) + curve(kArmsUnlike, std::abs(std::log(to1 / to2)));
}

std::vector<Trunk> trunksOf(const EndTable& t) {
  std::vector<Trunk> trunks;
  const std::vector<int> feet = t.best(2, kFeet);
  for (const int head : t.best(0, kHeads)) {
    for (size_t i = 0; i < feet.size(); ++i) {
      for (size_t j = i; j < feet.size(); ++j) {
        if (head == feet[i] || head == feet[j]) continue;
        const double first = t.way(head, feet[i]), second = t.way(head, feet[j]);
        const double length = 0.5 * (first + second);
        if (length < kShortest || length > kTallest) continue;
        if (std::abs(std::log(first / second)) > kMostUnlike) continue;
        trunks.push_back(trunkOf(t, head, feet[i], feet[j]));
      }
    }
  }
  return trunks;
}

struct Choice {
  std::array<int, kLimbEndCount> ends;
  double score;
};

void addHands(const EndTable& t, const Trunk& trunk, const std::vector<int>& hands,
              std::vector<Choice>* choices) {
  std::vector<std::pair<int, double>> free;
  for (const int hand : hands)
    if (hand != trunk.head && hand != trunk.foot1 && hand != trunk.foot2)
      free.emplace_back(hand, handScore(t, trunk, hand));
  for (size_t i = 0; i < free.size(); ++i)
    for (size_t j = i + 1; j < free.size(); ++j)
      choices->push_back({{trunk.head, free[i].first, free[j].first, trunk.foot1, trunk.foot2},
                          trunk.score + free[i].second + free[j].second +
                              handsScore(t, trunk, free[i].first, free[j].first)});
}

}  // namespace

EndNames nameEnds(const SkeletonEnds& ends, const TreeGraph& graph, double same) {
  EndNames names;
  if (ends.ends.size() < 4) return names;
  const EndTable table(ends, graph);
  const std::vector<int> hands = table.best(1, kHands);
  std::vector<Choice> choices;
  for (const Trunk& trunk : trunksOf(table)) addHands(table, trunk, hands, &choices);
  if (choices.empty()) return names;
  const Choice& best =
      *std::max_element(choices.begin(), choices.end(),
                        [](const Choice& a, const Choice& b) { return a.score < b.score; });
  names.ends = best.ends;
  const auto alike = [&](const Choice& choice) {
    for (size_t i = 0; i < best.ends.size(); ++i)
      if ((table.end(choice.ends[i]).position - table.end(best.ends[i]).position).norm() >= same)
        return false;
    return true;
  };
  double all = std::exp(kNobodyScore - best.score), good = 0.0;
  for (const Choice& choice : choices) {
    const double odds = std::exp(choice.score - best.score);
    all += odds;
    if (odds > 1e-4 && alike(choice)) good += odds;
  }
  names.probability = good / all;
  return names;
}

SkeletonEnds candidateEnds(const TreeGraph& graph, const TreeVolume& volume) {
  return findEnds(graph, volume, kSpur, kMostEnds);
}

LabelChoice labelByTemplate(const TreeGraph& graph, const TreeVolume& volume, double* probability) {
  LabelChoice choice;
  const SkeletonEnds ends = candidateEnds(graph, volume);
  const EndNames names = nameEnds(ends, graph, kSame);
  *probability = names.probability;
  if (names.ends[0] < 0) {
    choice.reason = "no five ends of the skeleton are as far apart as a body's";
    return choice;
  }
  for (size_t i = 0; i < names.ends.size(); ++i)
    choice.ends[i] = ends.ends[size_t(names.ends[i])].node;
  using namespace label_ratio;
  const auto foot = [&](LimbEnd end) {
    return ends.shortWay(size_t(names.ends[0]), size_t(names.ends[size_t(end)]));
  };
  choice.longest = 0.5 * (foot(LimbEnd::kFoot1) + foot(LimbEnd::kFoot2)) / (kNeck + kTorso + kLeg);
  openLoopsAtHands(graph, &choice);
  choice.status = TreeStatus::kOk;
  return choice;
}

}  // namespace markerless_mocap
