#include "silhouette/recording/color_candidates.h"

#include <algorithm>
#include <array>

#include "numerics/simd_clones.h"

namespace markerless_mocap {
namespace {

constexpr float kRadius = 14;  ///< of a cluster, grey levels
constexpr int kClusters = 3;   ///< of all samples, and of those without motion
constexpr int kFewest = 2;     ///< samples of a cluster

struct Cluster {
  cv::Vec3f mean;
  int count = 0;
};

MOCAP_VECTORISED int countNear(const float* blue, const float* green, const float* red, int samples,
                               const float* center) {
  int near = 0;
  for (int i = 0; i < samples; ++i) {
    const float b = blue[i] - center[0], g = green[i] - center[1], r = red[i] - center[2];
    near += b * b + g * g + r * r <= kRadius * kRadius;
  }
  return near;
}

/// What one pixel shows, channel by channel: each sample is compared with all others.
class PixelSamples {
 public:
  void clear() {
    for (std::vector<float>& channel : channels_) channel.clear();
  }
  void add(const cv::Vec3f& color) {
    for (int c = 0; c < 3; ++c) channels_[c].push_back(color[c]);
  }
  int count() const { return int(channels_[0].size()); }
  cv::Vec3f at(int i) const { return {channels_[0][i], channels_[1][i], channels_[2][i]}; }

  /// The densest cluster; its samples are removed.
  Cluster takeCluster() {
    cv::Vec3f center = mean();
    int most = near(center);
    for (int i = 0; i < count() && most < count(); ++i)
      if (const int found = near(at(i)); found > most) {
        most = found;
        center = at(i);
      }
    Cluster cluster = clusterAt(center);
    removeNear(cluster.mean);
    return cluster;
  }

 private:
  static bool isNear(const cv::Vec3f& a, const cv::Vec3f& b) {
    return (a - b).dot(a - b) <= kRadius * kRadius;
  }

  int near(const cv::Vec3f& center) const {
    return countNear(channels_[0].data(), channels_[1].data(), channels_[2].data(), count(),
                     center.val);
  }

  cv::Vec3f mean() const {
    cv::Vec3f sum;
    for (int i = 0; i < count(); ++i) sum += at(i);
    return sum * (1.0f / count());
  }

  Cluster clusterAt(const cv::Vec3f& center) const {
    Cluster cluster;
    for (int i = 0; i < count(); ++i) {
      if (!isNear(at(i), center)) continue;
      cluster.mean += at(i);
      ++cluster.count;
    }
    if (cluster.count > 0) cluster.mean *= 1.0f / cluster.count;
    return cluster;
  }

  void removeNear(const cv::Vec3f& center) {
    int kept = 0;
    for (int i = 0; i < count(); ++i) {
      const cv::Vec3f color = at(i);
      if (isNear(color, center)) continue;
      for (int c = 0; c < 3; ++c) channels_[c][kept] = color[c];
      ++kept;
    }
    for (std::vector<float>& channel : channels_) channel.resize(kept);
  }

  std::array<std::vector<float>, 3> channels_;
};

void addClusters(PixelSamples& samples, PixelCandidates* pixel) {
  const int all = samples.count();
  for (int k = 0; k < kClusters && samples.count() > 0; ++k) {
    const Cluster cluster = samples.takeCluster();
    if (cluster.count < std::min(kFewest, all)) return;
    pixel->colors[pixel->count++] = {cluster.mean, float(cluster.count) / all};
  }
}

}  // namespace

std::vector<PixelCandidates> findCandidates(const SceneSamples& samples) {
  std::vector<PixelCandidates> candidates(samples.size.area());
  PixelSamples all, still;
  for (int y = 0; y < samples.size.height; ++y)
    for (int x = 0; x < samples.size.width; ++x) {
      all.clear();
      still.clear();
      for (int i = 0; i < samples.count(); ++i) {
        const cv::Vec3f color = samples.colors[i].at<cv::Vec3b>(y, x);
        all.add(color);
        if (samples.moving[i].at<uint8_t>(y, x) == 0) still.add(color);
      }
      PixelCandidates& pixel = candidates[size_t(y) * samples.size.width + x];
      const bool moves = still.count() < all.count();
      addClusters(all, &pixel);
      if (moves) addClusters(still, &pixel);
    }
  return candidates;
}

}  // namespace markerless_mocap
