#include "fleischmann/fitness/edge_samples.h"

namespace markerless_mocap {
namespace {

struct Pixel {
  float x, y;
};

bool holds(const cv::Mat& map, float x, float y) {
  return x >= 0.0f && x < float(map.cols) && y >= 0.0f && y < float(map.rows);
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

EdgeSum sampleEdges(const ConeCorners& corners, const cv::Mat& map, const EdgeSelection& choice,
                    int samples) {
  EdgeSum out;
  for (int cone = 0; cone < kFleischmannConeCount; ++cone) {
    if (!(choice.cones >> cone & 1u) || !corners.seen[cone]) continue;
    const auto corner = [&](int at) { return Pixel{corners.x[at][cone], corners.y[at][cone]}; };
    sampleLine(map, corner(0), corner(1), samples, out);
    sampleLine(map, corner(3), corner(2), samples, out);
    if (cone == kTorsoCone && choice.torso_top) sampleLine(map, corner(1), corner(2), samples, out);
  }
  return out;
}

}  // namespace markerless_mocap
