#include "silhouette/recording/inward_flood.h"

#include <algorithm>
#include <cmath>

namespace markerless_mocap {
namespace {

constexpr int kReach = 4;  ///< known colours this near count, px
constexpr float kMaxDistance = 22, kMaxCost = 7, kMinShare = 0.04f;
constexpr float kShareWeight = 4, kUsualShare = 0.5f, kPersonWeight = 3, kMaxLogRatio = 3;

constexpr float kMinShade = 0.6f, kMaxShade = 0.95f, kMaxResidual = 10, kMinLitShare = 0.06f;
constexpr float kMaxLitDistance = 14, kMaxLitRatio = 0;

bool isShadeOf(const cv::Vec3f& dark, const cv::Vec3f& bright) {
  const float ratio = dark.dot(bright) / bright.dot(bright);
  return ratio > kMinShade && ratio < kMaxShade && cv::norm(dark - bright * ratio) < kMaxResidual;
}

class Flood {
 public:
  Flood(const std::vector<PixelCandidates>& candidates, const PersonColors& person,
        SceneColors* scene)
      : candidates_(candidates), person_(person), scene_(*scene), queued_(candidates.size(), 0) {}

  void run() {
    std::vector<cv::Point> frontier;
    for (int y = 0; y < scene_.known.rows; ++y)
      for (int x = 0; x < scene_.known.cols; ++x)
        if (scene_.known.at<uint8_t>(y, x)) enqueueAround({x, y}, &frontier);
    while (!frontier.empty()) frontier = advance(frontier);
  }

 private:
  size_t indexOf(const cv::Point& p) const { return size_t(p.y) * scene_.known.cols + p.x; }

  void enqueueAround(const cv::Point& p, std::vector<cv::Point>* frontier) {
    for (const cv::Point step : {cv::Point(1, 0), {-1, 0}, {0, 1}, {0, -1}}) {
      const cv::Point q = p + step;
      if (!cv::Rect({}, scene_.known.size()).contains(q) || scene_.known.at<uint8_t>(q)) continue;
      uint8_t& queued = queued_[indexOf(q)];
      if (queued) continue;
      queued = 1;
      frontier->push_back(q);
    }
  }

  /// All pixels of the frontier are decided by what was known before; returns the next frontier.
  std::vector<cv::Point> advance(const std::vector<cv::Point>& frontier) {
    std::vector<std::pair<cv::Point, const ColorCandidate*>> accepted;
    for (const cv::Point& p : frontier) {
      queued_[indexOf(p)] = 0;
      if (const ColorCandidate* best = bestCandidate(p)) accepted.emplace_back(p, best);
    }
    for (const auto& [p, best] : accepted) {
      scene_.known.at<uint8_t>(p) = 255;
      scene_.color.at<cv::Vec3f>(p) = best->color;
    }
    std::vector<cv::Point> next;
    for (const auto& entry : accepted) enqueueAround(entry.first, &next);
    return next;
  }

  const ColorCandidate* bestCandidate(const cv::Point& p) const {
    const ColorCandidate* best = nullptr;
    float best_cost = kMaxCost;
    for (const ColorCandidate& candidate : candidates_[indexOf(p)]) {
      if (candidate.share < kMinShare) continue;
      const float distance = distanceToKnown(p, candidate.color);
      if (distance > kMaxDistance) continue;
      const float ratio =
          std::clamp(person_.logRatio(candidate.color), -kMaxLogRatio, kMaxLogRatio);
      const float cost =
          distance - kShareWeight * std::log(candidate.share / kUsualShare) + kPersonWeight * ratio;
      if (cost >= best_cost) continue;
      best_cost = cost;
      best = &candidate;
    }
    return best ? lit(p, best) : nullptr;
  }

  /// Where a pixel is often in shadow, its background is the brighter colour.
  const ColorCandidate* lit(const cv::Point& p, const ColorCandidate* chosen) const {
    const ColorCandidate* brightest = chosen;
    for (const ColorCandidate& candidate : candidates_[indexOf(p)])
      if (candidate.share >= kMinLitShare && isShadeOf(chosen->color, candidate.color) &&
          cv::norm(candidate.color) > cv::norm(brightest->color) &&
          person_.logRatio(candidate.color) <= kMaxLitRatio &&
          distanceToKnown(p, candidate.color) <= kMaxLitDistance)
        brightest = &candidate;
    return brightest;
  }

  float distanceToKnown(const cv::Point& p, const cv::Vec3f& color) const {
    float nearest = 1e9f;
    const cv::Rect around = cv::Rect(p.x - kReach, p.y - kReach, 2 * kReach + 1, 2 * kReach + 1) &
                            cv::Rect({}, scene_.known.size());
    for (int y = around.y; y < around.br().y; ++y)
      for (int x = around.x; x < around.br().x; ++x)
        if (scene_.known.at<uint8_t>(y, x)) {
          const cv::Vec3f difference = scene_.color.at<cv::Vec3f>(y, x) - color;
          nearest = std::min(nearest, difference.dot(difference));
        }
    return std::sqrt(nearest);
  }

  const std::vector<PixelCandidates>& candidates_;
  const PersonColors& person_;
  SceneColors& scene_;
  std::vector<uint8_t> queued_;
};

}  // namespace

void floodInward(const std::vector<PixelCandidates>& candidates, const PersonColors& person,
                 SceneColors* scene) {
  Flood(candidates, person, scene).run();
}

}  // namespace markerless_mocap
