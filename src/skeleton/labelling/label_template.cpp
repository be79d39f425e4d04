#include "skeleton/label_template.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "skeleton/labelling/extremity_label_model.h"
#include "skeleton/labelling/label_proportions.h"
#include "skeleton/labelling/loop_opening.h"

namespace markerless_mocap {
namespace {

constexpr size_t kHeads = 4, kHands = 7, kFeet = 6;  // candidates of each kind
constexpr double kMinHeadToFeet = 0.7,
                 kMaxHeadToFeet = 2.2;  // mean path length from the head to the feet, metres
constexpr double kSpur = 0.03;  // branches shorter than this fraction of the longest path are spurs
constexpr size_t kMaxEnds = 24;
constexpr double kSame = 0.12;      // metres
constexpr double kMaxUnlike = 0.5;  // log ratio of the path lengths to the feet

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

/// Path lengths and log-odds of the ends of one skeleton.
class ExtremityTable {
 public:
  ExtremityTable(const ExtremityCandidates& candidates, const TreeGraph& graph,
                 const ExtremityLabelModel& model)
      : model_(model),
        ends_(candidates.extremities),
        count_(ends_.size()),
        heights_(heightsOf(graph)) {
    for (const ExtremityCandidate& end : ends_)
      tips_.push_back(end.position + end.extent * end.direction);
    tree_ = withExtents(candidates.tree_path_lengths);
    short_ = withExtents(candidates.shortest_path_lengths);
    for (size_t role = 0; role < 3; ++role)
      for (size_t end = 0; end < count_; ++end)
        odds_[role].push_back(oddsOf(role, end, candidates.longest));
  }

  double treePathLength(int a, int b) const { return tree_[size_t(a) * count_ + size_t(b)]; }
  double pathLength(int a, int b) const { return short_[size_t(a) * count_ + size_t(b)]; }
  double gap(int a, int b) const { return (tips_[size_t(a)] - tips_[size_t(b)]).norm(); }
  double height(int end) const { return tips_[size_t(end)].z(); }
  double lowest() const { return heights_.lowest; }
  const BodyCurves& curve() const { return model_.body; }
  const ExtremityCandidate& end(int end) const { return ends_[size_t(end)]; }

  /// The most likely ends for a role, up to `max_count`.
  std::vector<int> best(size_t role, size_t max_count) const {
    std::vector<int> order(count_);
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(),
                     [&](int a, int b) { return odds_[role][size_t(a)] > odds_[role][size_t(b)]; });
    if (order.size() > max_count) order.resize(max_count);
    return order;
  }

 private:
  std::vector<double> withExtents(std::vector<double> path_lengths) const {
    for (size_t a = 0; a < count_; ++a)
      for (size_t b = 0; b < count_; ++b)
        if (a != b) path_lengths[a * count_ + b] += ends_[a].extent + ends_[b].extent;
    return path_lengths;
  }

  double oddsOf(size_t role, size_t at, double longest) const {
    const ExtremityCandidate& end = ends_[at];
    double reach = 0.0;
    for (size_t b = 0; b < count_; ++b) reach = std::max(reach, tree_[at * count_ + b]);
    const double x[kExtremityFeatureCount] = {(tips_[at].z() - heights_.lowest) / longest,
                                              (heights_.highest - tips_[at].z()) / longest,
                                              end.direction.z(),
                                              end.extent / longest,
                                              end.end_radius / longest,
                                              end.limb_radius / longest,
                                              end.branch / longest,
                                              end.cut ? 1.0 : 0.0,
                                              reach / longest};
    const ExtremityModel& model = model_.extremities[role];
    double odds = model.constant;
    for (size_t i = 0; i < kExtremityFeatureCount; ++i) odds += model.curves[i](x[i]);
    return odds;
  }

  const ExtremityLabelModel& model_;
  const std::vector<ExtremityCandidate>& ends_;
  size_t count_;
  Heights heights_;
  std::vector<Eigen::Vector3d> tips_;
  std::vector<double> tree_, short_;
  std::array<std::vector<double>, 3> odds_;
};

/// A head and two feet, and the measures that follow from them.
struct Trunk {
  int head, foot1, foot2;
  double length;  ///< mean path length from the head to the feet, metres
  double low;     ///< height of the lower foot
  double score;
};

double footScore(const ExtremityTable& t, int foot, double s) {
  const BodyCurves& curve = t.curve();
  const ExtremityCandidate& end = t.end(foot);
  return curve(kFootUp, (t.height(foot) - t.lowest()) / s) +
         curve(kFootTipRadius, end.end_radius / s) + curve(kFootLimbRadius, end.limb_radius / s) +
         curve(kFootBranch, end.branch / s) + curve(kFootCut, end.cut) +
         curve(kFootExtent, end.extent / s) + curve(kFootDirection, end.direction.z());
}

Trunk trunkOf(const ExtremityTable& t, int head, int foot1, int foot2) {
  Trunk trunk{head, foot1, foot2, 0.5 * (t.pathLength(head, foot1) + t.pathLength(head, foot2)),
              0.0,  0.0};
  const BodyCurves& curve = t.curve();
  const double s = trunk.length;
  trunk.low = std::min(t.height(foot1), t.height(foot2));
  const ExtremityCandidate& top = t.end(head);
  trunk.score =
      curve(kFootFootPath, t.pathLength(foot1, foot2) / s) +
      curve(kFootFootTreePath, t.treePathLength(foot1, foot2) / s) + curve(kHeadFeetMetres, s) +
      curve(kFeetUnlike,
            std::abs(std::log(t.pathLength(head, foot1) / t.pathLength(head, foot2)))) +
      curve(kFootFootGap, t.gap(foot1, foot2) / s) +
      curve(kHeadUp, (t.height(head) - trunk.low) / s) +
      curve(kFeetUnevenness, std::abs(t.height(foot1) - t.height(foot2)) / s) +
      curve(kHeadTipRadius, top.end_radius / s) + curve(kHeadLimbRadius, top.limb_radius / s) +
      curve(kHeadBranch, top.branch / s) + curve(kHeadCut, top.cut) +
      curve(kHeadExtent, top.extent / s) + curve(kHeadDirection, top.direction.z()) +
      curve(kFeetTogether, foot1 == foot2) + footScore(t, foot1, s) + footScore(t, foot2, s);
  return trunk;
}

double handScore(const ExtremityTable& t, const Trunk& trunk, int hand) {
  const BodyCurves& curve = t.curve();
  const double s = trunk.length;
  const ExtremityCandidate& end = t.end(hand);
  double score =
      curve(kHeadHandPath, t.pathLength(trunk.head, hand) / s) +
      curve(kHeadHandTreePath, t.treePathLength(trunk.head, hand) / s) +
      curve(kHandUp, (t.height(hand) - trunk.low) / s) + curve(kHandTipRadius, end.end_radius / s) +
      curve(kHandLimbRadius, end.limb_radius / s) + curve(kHandBranch, end.branch / s) +
      curve(kHandCut, end.cut) + curve(kHandExtent, end.extent / s) +
      curve(kHandDirection, end.direction.z()) + curve(kHeadHandGap, t.gap(trunk.head, hand) / s);
  double path_length = 1e9, tree_path_length = 1e9;
  for (const int foot : {trunk.foot1, trunk.foot2}) {
    path_length = std::min(path_length, t.pathLength(hand, trunk.head) + t.pathLength(hand, foot) -
                                            t.pathLength(trunk.head, foot));
    tree_path_length = std::min(tree_path_length, t.treePathLength(hand, trunk.head) +
                                                      t.treePathLength(hand, foot) -
                                                      t.treePathLength(trunk.head, foot));
    score += curve(kHandFootPath, t.pathLength(hand, foot) / s) +
             curve(kHandFootTreePath, t.treePathLength(hand, foot) / s) +
             curve(kHandFootGap, t.gap(hand, foot) / s);
  }
  score += curve(kArmPath, 0.5 * path_length / s) + curve(kArmTreePath, 0.5 * tree_path_length / s);
  return score;
}

double handsScore(const ExtremityTable& t, const Trunk& trunk, int hand1, int hand2) {
  const BodyCurves& curve = t.curve();
  const double s = trunk.length;
  const double to1 = t.treePathLength(trunk.head, hand1), to2 = t.treePathLength(trunk.head, hand2);
  const double neck = 0.5 * (to1 + to2 - t.treePathLength(hand1, hand2));
  const double hips =
      0.5 * (t.treePathLength(trunk.head, trunk.foot1) + t.treePathLength(trunk.head, trunk.foot2) -
             t.treePathLength(trunk.foot1, trunk.foot2));
  return curve(kHandHandPath, t.pathLength(hand1, hand2) / s) +
         curve(kHandHandTreePath, t.treePathLength(hand1, hand2) / s) +
         curve(kHandHandGap, t.gap(hand1, hand2) / s) + curve(kNeckLength, neck / s) +
         curve(kTorsoLength, (hips - neck) / s) +
         curve(kHandsUnlike, std::abs(std::log(to1 / to2)));
}

std::vector<Trunk> trunksOf(const ExtremityTable& t) {
  std::vector<Trunk> trunks;
  const std::vector<int> feet = t.best(2, kFeet);
  for (const int head : t.best(0, kHeads)) {
    for (size_t i = 0; i < feet.size(); ++i) {
      for (size_t j = i; j < feet.size(); ++j) {
        if (head == feet[i] || head == feet[j]) continue;
        const double first = t.pathLength(head, feet[i]), second = t.pathLength(head, feet[j]);
        const double length = 0.5 * (first + second);
        if (length < kMinHeadToFeet || length > kMaxHeadToFeet) continue;
        if (std::abs(std::log(first / second)) > kMaxUnlike) continue;
        trunks.push_back(trunkOf(t, head, feet[i], feet[j]));
      }
    }
  }
  return trunks;
}

struct Choice {
  std::array<int, kUnsidedExtremityCount> extremities;
  double score;
};

void addHands(const ExtremityTable& t, const Trunk& trunk, const std::vector<int>& hands,
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

ExtremityLabels labelExtremities(const ExtremityCandidates& candidates, const TreeGraph& graph,
                                 const ExtremityLabelModel& model, double same) {
  ExtremityLabels names;
  if (candidates.extremities.size() < 4) return names;
  const ExtremityTable table(candidates, graph, model);
  const std::vector<int> hands = table.best(1, kHands);
  std::vector<Choice> choices;
  for (const Trunk& trunk : trunksOf(table)) addHands(table, trunk, hands, &choices);
  if (choices.empty()) return names;
  const Choice& best =
      *std::max_element(choices.begin(), choices.end(),
                        [](const Choice& a, const Choice& b) { return a.score < b.score; });
  names.extremities = best.extremities;
  const auto alike = [&](const Choice& choice) {
    for (size_t i = 0; i < best.extremities.size(); ++i)
      if ((table.end(choice.extremities[i]).position - table.end(best.extremities[i]).position)
              .norm() >= same)
        return false;
    return true;
  };
  double all = std::exp(model.no_body_log_odds - best.score), good = 0.0;
  for (const Choice& choice : choices) {
    const double odds = std::exp(choice.score - best.score);
    all += odds;
    if (odds > 1e-4 && alike(choice)) good += odds;
  }
  names.probability = good / all;
  return names;
}

ExtremityCandidates extremityCandidates(const TreeGraph& graph, const TreeVolume& volume) {
  return findExtremityCandidates(graph, volume, kSpur, kMaxEnds);
}

LabelChoice labelByTemplate(const TreeGraph& graph, const TreeVolume& volume,
                            const ExtremityLabelModel& model, double* probability) {
  LabelChoice choice;
  const ExtremityCandidates candidates = extremityCandidates(graph, volume);
  const ExtremityLabels names = labelExtremities(candidates, graph, model, kSame);
  *probability = names.probability;
  if (names.extremities[0] < 0) {
    choice.reason = "no five extremities of the skeleton have the distances of a body";
    return choice;
  }
  for (size_t i = 0; i < names.extremities.size(); ++i)
    choice.extremities[i] = candidates.extremities[size_t(names.extremities[i])].node;
  using namespace label_ratio;
  const auto foot = [&](UnsidedExtremity end) {
    return candidates.shortestPathLength(size_t(names.extremities[0]),
                                         size_t(names.extremities[size_t(end)]));
  };
  choice.longest = 0.5 * (foot(UnsidedExtremity::kFoot1) + foot(UnsidedExtremity::kFoot2)) /
                   (kNeck + kTorso + kLeg);
  openLoopsAtHands(graph, &choice);
  choice.status = TreeStatus::kOk;
  return choice;
}

}  // namespace markerless_mocap
