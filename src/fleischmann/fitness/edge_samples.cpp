#include "fleischmann/fitness/edge_samples.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace markerless_mocap {
namespace {

struct Pixel {
  float x, y;
};

std::pair<float, float> rangeOf(const float (&values)[4]) {
  const auto [low, high] = std::minmax_element(values, values + 4);
  return {*low, *high};
}

bool holds(const cv::Mat& map, float x, float y) {
  return x >= 0.0f && x < float(map.cols) && y >= 0.0f && y < float(map.rows);
}

/// As sampleLine(), point by point.
template <class Skip>
void sampleVisible(const cv::Mat& map, const Pixel& from, const Pixel& to, int samples,
                   const Skip& skip, EdgeSum& out) {
  for (int i = 0; i < samples; ++i) {
    const float t = (float(i) + 0.5f) / float(samples);
    const float x = from.x + t * (to.x - from.x), y = from.y + t * (to.y - from.y);
    if (!holds(map, x + 0.5f, y + 0.5f) || skip(t, x, y)) continue;
    out.sum += map.at<uint8_t>(int(y + 0.5f), int(x + 0.5f));
    ++out.points;
  }
}

void sampleLine(const cv::Mat& map, const Pixel& from, const Pixel& to, int samples, EdgeSum& out) {
  const uint8_t* data = map.data;
  const int step = int(map.step[0]);
  const float dx = (to.x - from.x) / float(samples), dy = (to.y - from.y) / float(samples);
  // Plus half a pixel, so that truncation rounds to the nearest pixel.
  const float x0 = from.x + 0.5f * dx + 0.5f, y0 = from.y + 0.5f * dy + 0.5f;
  const auto x = [&](int i) { return x0 + float(i) * dx; };
  const auto y = [&](int i) { return y0 + float(i) * dy; };
  const bool whole = holds(map, x(0), y(0)) && holds(map, x(samples - 1), y(samples - 1));
  int sum = 0, points = 0;
  for (int i = 0; i < samples; ++i) {
    if (!whole && !holds(map, x(i), y(i))) continue;
    sum += data[int(y(i)) * step + int(x(i))];
    ++points;
  }
  out.sum += sum;
  out.points += points;
}

}  // namespace

HiddenPoints::HiddenPoints(const ConeCorners& corners, const FleischmannWorldCones& cones,
                           const Eigen::Vector3f& camera) {
  for (int i = 0; i < kFleischmannConeCount; ++i) {
    Outline& outline = outlines_[size_t(i)];
    outline.seen = corners.seen[size_t(i)] != 0;
    if (!outline.seen) continue;
    for (int k = 0; k < 4; ++k) {
      outline.x[k] = corners.x[size_t(k)][size_t(i)];
      outline.y[k] = corners.y[size_t(k)][size_t(i)];
    }
    std::tie(outline.low_x, outline.high_x) = rangeOf(outline.x);
    std::tie(outline.low_y, outline.high_y) = rangeOf(outline.y);
    const float dx = outline.x[1] + outline.x[2] - outline.x[0] - outline.x[3];
    const float dy = outline.y[1] + outline.y[2] - outline.y[0] - outline.y[3];
    const float scale = 2.0f / std::max(dx * dx + dy * dy, 1e-6f);
    outline.axis_x = scale * dx;
    outline.axis_y = scale * dy;
    const auto distance = [&](const ConeVectors& at) {
      return (Eigen::Vector3f(at[0][size_t(i)], at[1][size_t(i)], at[2][size_t(i)]) - camera)
          .norm();
    };
    outline.near_end = distance(cones.a);
    outline.far_end = distance(cones.b);
  }
}

bool HiddenPoints::contains(const Outline& outline, float x, float y) {
  if (x < outline.low_x || x > outline.high_x || y < outline.low_y || y > outline.high_y)
    return false;
  bool left = false, right = false;
  for (int k = 0; k < 4; ++k) {
    const int next = (k + 1) % 4;
    const float side = (outline.x[next] - outline.x[k]) * (y - outline.y[k]) -
                       (outline.y[next] - outline.y[k]) * (x - outline.x[k]);
    (side > 0.0f ? left : right) = true;
  }
  return left != right;
}

bool HiddenPoints::operator()(int cone, float along, float x, float y) const {
  const Outline& own = outlines_[size_t(cone)];
  const float distance = own.near_end + along * (own.far_end - own.near_end);
  for (int i = 0; i < kFleischmannConeCount; ++i) {
    const Outline& other = outlines_[size_t(i)];
    if (i == cone || !other.seen || !contains(other, x, y)) continue;
    const float from_x = x - (other.x[0] + other.x[3]) / 2.0f;
    const float from_y = y - (other.y[0] + other.y[3]) / 2.0f;
    const float t = std::clamp(from_x * other.axis_x + from_y * other.axis_y, 0.0f, 1.0f);
    if (other.near_end + t * (other.far_end - other.near_end) < distance) return true;
  }
  return false;
}

EdgeSum sampleEdges(const ConeCorners& corners, const cv::Mat& map, const EdgeSelection& choice,
                    int samples, const HiddenPoints* hidden) {
  EdgeSum out;
  for (int cone = 0; cone < kFleischmannConeCount; ++cone) {
    if (!(choice.cones >> cone & 1u) || !corners.seen[cone]) continue;
    const auto corner = [&](int at) { return Pixel{corners.x[at][cone], corners.y[at][cone]}; };
    const auto sample = [&](int from, int to, bool across) {
      if (!hidden) return sampleLine(map, corner(from), corner(to), samples, out);
      const auto skip = [&](float t, float x, float y) {
        return (*hidden)(cone, across ? 1.0f : t, x, y);
      };
      sampleVisible(map, corner(from), corner(to), samples, skip, out);
    };
    sample(0, 1, false);
    sample(3, 2, false);
    if (cone == kTorsoCone && choice.torso_top) sample(1, 2, true);
  }
  return out;
}

}  // namespace markerless_mocap
