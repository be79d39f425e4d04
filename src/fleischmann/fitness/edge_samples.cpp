#include "fleischmann/fitness/edge_samples.h"

#include <algorithm>
#include <cmath>
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

/// As sampleLine(), without the points that are hidden.
void sampleVisible(const cv::Mat& map, const EdgeLine& line, const HiddenPoints::Points& hidden,
                   EdgeSum& out) {
  for (int i = 0; i < line.samples; ++i) {
    if (hidden[size_t(i)]) continue;
    const float x = line.x[0] + line.at(i) * (line.x[1] - line.x[0]) + 0.5f;
    const float y = line.y[0] + line.at(i) * (line.y[1] - line.y[0]) + 0.5f;
    if (!holds(map, x, y)) continue;
    out.sum += map.at<uint8_t>(int(y), int(x));
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
    float turn = 0.0f;  // twice the area
    for (int k = 0; k < 4; ++k) {
      const auto corner = [&](int at) { return Pixel{corners.x[at][i], corners.y[at][i]}; };
      const Pixel here = corner(k), next = corner((k + 1) % 4);
      outline.x[k] = here.x;
      outline.y[k] = here.y;
      turn += (here.x - outline.x[0]) * (next.y - outline.y[0]) -
              (next.x - outline.x[0]) * (here.y - outline.y[0]);
    }
    std::tie(outline.low_x, outline.high_x) = rangeOf(outline.x);
    std::tie(outline.low_y, outline.high_y) = rangeOf(outline.y);
    outline.start_x = (outline.x[0] + outline.x[3]) / 2.0f;
    outline.start_y = (outline.y[0] + outline.y[3]) / 2.0f;
    const float dx = (outline.x[1] + outline.x[2]) / 2.0f - outline.start_x;
    const float dy = (outline.y[1] + outline.y[2]) / 2.0f - outline.start_y;
    const float scale = 1.0f / std::max(dx * dx + dy * dy, 1e-6f);
    outline.axis_x = scale * dx;
    outline.axis_y = scale * dy;
    if (turn < 0.0f) {
      std::swap(outline.x[1], outline.x[3]);
      std::swap(outline.y[1], outline.y[3]);
    }
    const auto distance = [&](const ConeVectors& at) {
      return (Eigen::Vector3f(at[0][size_t(i)], at[1][size_t(i)], at[2][size_t(i)]) - camera)
          .norm();
    };
    outline.near_end = distance(cones.a);
    outline.far_end = distance(cones.b);
  }
}

// Cyrus and Beck's clipping.
std::pair<float, float> HiddenPoints::inside(const Outline& outline, const EdgeLine& line) {
  float from = 0.0f, to = 1.0f;
  for (int k = 0; k < 4 && from <= to; ++k) {
    const int next = (k + 1) % 4;
    const float side_x = outline.x[next] - outline.x[k], side_y = outline.y[next] - outline.y[k];
    const auto height = [&](int end) {
      return side_x * (line.y[end] - outline.y[k]) - side_y * (line.x[end] - outline.x[k]);
    };
    const float start = height(0), end = height(1);
    if (start <= 0.0f && end <= 0.0f) return {1.0f, 0.0f};
    if (start < 0.0f) from = std::max(from, start / (start - end));
    if (end < 0.0f) to = std::min(to, start / (start - end));
  }
  return {from, to};
}

HiddenPoints::Points HiddenPoints::on(const EdgeLine& line, int cone) const {
  Points hidden;
  const Outline& own = outlines_[size_t(cone)];
  const auto distance = [&](float t) {
    const float along = line.along[0] + t * (line.along[1] - line.along[0]);
    return own.near_end + along * (own.far_end - own.near_end);
  };
  const float furthest = std::max(distance(0.0f), distance(1.0f));
  const auto [low_x, high_x] = std::minmax(line.x[0], line.x[1]);
  const auto [low_y, high_y] = std::minmax(line.y[0], line.y[1]);
  for (int i = 0; i < kFleischmannConeCount; ++i) {
    const Outline& other = outlines_[size_t(i)];
    if (i == cone || !other.seen || std::min(other.near_end, other.far_end) >= furthest ||
        high_x < other.low_x || low_x > other.high_x || high_y < other.low_y ||
        low_y > other.high_y)
      continue;
    const auto [from, to] = inside(other, line);
    for (int s = std::max(0, int(std::ceil(from * float(line.samples) - 0.5f)));
         s < line.samples && line.at(s) <= to; ++s) {
      const float t = line.at(s);
      const float x = line.x[0] + t * (line.x[1] - line.x[0]) - other.start_x;
      const float y = line.y[0] + t * (line.y[1] - line.y[0]) - other.start_y;
      const float along = std::clamp(x * other.axis_x + y * other.axis_y, 0.0f, 1.0f);
      if (other.near_end + along * (other.far_end - other.near_end) < distance(t))
        hidden.set(size_t(s));
    }
  }
  return hidden;
}

EdgeSum sampleEdges(const ConeCorners& corners, const cv::Mat& map, const EdgeSelection& choice,
                    int samples, const HiddenPoints* hidden) {
  EdgeSum out;
  for (int cone = 0; cone < kFleischmannConeCount; ++cone) {
    if (!(choice.cones >> cone & 1u) || !corners.seen[cone]) continue;
    const auto corner = [&](int at) { return Pixel{corners.x[at][cone], corners.y[at][cone]}; };
    const auto sample = [&](int from, int to, float along) {
      const Pixel a = corner(from), b = corner(to);
      if (!hidden) return sampleLine(map, a, b, samples, out);
      const EdgeLine line{{a.x, b.x}, {a.y, b.y}, {along, 1.0f}, samples};
      sampleVisible(map, line, hidden->on(line, cone), out);
    };
    sample(0, 1, 0.0f);
    sample(3, 2, 0.0f);
    if (cone == kTorsoCone && choice.torso_top) sample(1, 2, 1.0f);
  }
  return out;
}

}  // namespace markerless_mocap
