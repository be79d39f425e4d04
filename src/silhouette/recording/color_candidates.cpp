#include "silhouette/recording/color_candidates.h"

#include <algorithm>

namespace markerless_mocap {
namespace {

constexpr float kRadius = 14;  ///< of a cluster, grey levels
constexpr int kClusters = 3;   ///< of all samples, and of those without motion
constexpr int kFewest = 2;     ///< samples of a cluster

float squared(const cv::Vec3f& v) {
  return v.dot(v);
}

struct Cluster {
  cv::Vec3f mean;
  int count = 0;
};

Cluster meanNear(const std::vector<cv::Vec3f>& samples, const cv::Vec3f& center) {
  Cluster cluster;
  for (const cv::Vec3f& sample : samples) {
    if (squared(sample - center) > kRadius * kRadius) continue;
    cluster.mean += sample;
    ++cluster.count;
  }
  if (cluster.count > 0) cluster.mean *= 1.0f / cluster.count;
  return cluster;
}

/// The densest cluster; its samples are removed.
Cluster takeCluster(std::vector<cv::Vec3f>* samples) {
  cv::Vec3f whole;
  for (const cv::Vec3f& sample : *samples) whole += sample;
  Cluster best = meanNear(*samples, whole * (1.0f / samples->size()));
  if (best.count < int(samples->size()))
    for (const cv::Vec3f& sample : *samples)
      if (const Cluster cluster = meanNear(*samples, sample); cluster.count > best.count)
        best = cluster;
  samples->erase(std::remove_if(samples->begin(), samples->end(),
                                [&](const cv::Vec3f& sample) {
                                  return squared(sample - best.mean) <= kRadius * kRadius;
                                }),
                 samples->end());
  return best;
}

void addClusters(std::vector<cv::Vec3f> samples, PixelCandidates* pixel) {
  const int all = int(samples.size());
  for (int k = 0; k < kClusters && !samples.empty(); ++k) {
    const Cluster cluster = takeCluster(&samples);
    if (cluster.count < std::min(kFewest, all)) return;
    pixel->colors[pixel->count++] = {cluster.mean, float(cluster.count) / all};
  }
}

}  // namespace

std::vector<PixelCandidates> findCandidates(const SceneSamples& samples) {
  std::vector<PixelCandidates> candidates(samples.size.area());
  std::vector<cv::Vec3f> all, still;
  for (int y = 0; y < samples.size.height; ++y)
    for (int x = 0; x < samples.size.width; ++x) {
      all.clear();
      still.clear();
      for (int i = 0; i < samples.count(); ++i) {
        all.push_back(samples.colors[i].at<cv::Vec3b>(y, x));
        if (samples.moving[i].at<uint8_t>(y, x) == 0) still.push_back(all.back());
      }
      PixelCandidates& pixel = candidates[size_t(y) * samples.size.width + x];
      addClusters(all, &pixel);
      if (still.size() < all.size()) addClusters(still, &pixel);
    }
  return candidates;
}

}  // namespace markerless_mocap
