#include "region/colors/part_colors.h"

#include <algorithm>
#include <cmath>

namespace markerless_mocap {
namespace {

// A sample of the core is deeper inside a part than this fraction of its largest depth.
constexpr float kCoreDepth = 0.5f;
// The ring of the surroundings: from these multiples of sigma outside the body, plus samples.
constexpr float kRingStart_sigmas = 0.5f, kRingStart = 0.5f;
constexpr float kRingEnd_sigmas = 2.f, kRingEnd = 7.f;

// A colour is the person's if it is this many times as frequent in the person as in the
// surroundings.
constexpr float kMinRatio = 6.f;

// Parts further from a sample than this are not mixed in: multiples of sigma, plus samples.
constexpr float kReach_sigmas = 2.5f, kReach = 2.f;
constexpr int kWeightsPerSample = 4;

constexpr float kFloor = 1e-4f;     // of a probability
constexpr float kMaxLogOdds = 4.f;  // colour alone never decides more than this

/// Weight of a part by the distance of a sample outside it, in steps of 1 / kWeightsPerSample.
std::vector<float> weightsByDistance(float sigma, float reach) {
  std::vector<float> weights(size_t(kWeightsPerSample * reach) + 2);
  for (size_t i = 0; i < weights.size(); ++i) {
    const float sigmas = float(i) / kWeightsPerSample / sigma;
    weights[i] = std::exp(-0.5f * sigmas * sigmas);
  }
  return weights;
}

void count(const cv::Mat& bins, const BodyDrawing& drawing, size_t index, float sigma,
           std::vector<uint32_t>& person, std::vector<uint32_t>& surroundings) {
  const PartDistance& part = drawing.parts[index];
  const float core = -kCoreDepth * part.depth_inside;
  const float ring_start = kRingStart_sigmas * sigma + kRingStart;
  const float ring_end = kRingEnd_sigmas * sigma + kRingEnd;
  for (int y = 0; y < part.box.height; ++y) {
    const float* own = part.distance.ptr<float>(y);
    const int row = y + part.box.y - drawing.box.y, shift = part.box.x - drawing.box.x;
    const float* body = drawing.distance.ptr<float>(row) + shift;
    const uchar* label = drawing.part.ptr<uchar>(row) + shift;
    const uint16_t* bin = bins.ptr<uint16_t>(row) + shift;
    for (int x = 0; x < part.box.width; ++x) {
      if (own[x] <= core && label[x] == index) ++person[bin[x]];
      if (own[x] < ring_end && body[x] > ring_start) ++surroundings[bin[x]];
    }
  }
}

}  // namespace

void learnColors(const cv::Mat& bins, const BodyDrawing& drawing, float sigma, float person_rate,
                 float surroundings_rate, std::vector<PartColors>& colors) {
  std::vector<uint32_t> person(ColorBins::kCount), surroundings(ColorBins::kCount);
  for (size_t i = 0; i < drawing.parts.size(); ++i) {
    if (drawing.parts[i].box.area() == 0) continue;
    std::fill(person.begin(), person.end(), 0);
    std::fill(surroundings.begin(), surroundings.end(), 0);
    count(bins, drawing, i, sigma, person, surroundings);
    colors[i].person.learn(person, person_rate);
    colors[i].surroundings.learn(surroundings, surroundings_rate);
  }
}

cv::Mat colorLogOdds(const cv::Mat& bins, const BodyDrawing& drawing, float sigma,
                     const std::vector<PartColors>& colors) {
  cv::Mat person = cv::Mat::zeros(drawing.box.size(), CV_32FC1), other = person.clone();
  const float reach = kReach_sigmas * sigma + kReach;
  const std::vector<float> weights = weightsByDistance(sigma, reach);
  for (size_t i = 0; i < drawing.parts.size(); ++i) {
    const PartDistance& part = drawing.parts[i];
    if (part.box.area() == 0 || colors[i].person.empty() || colors[i].surroundings.empty())
      continue;
    const float *of_person = colors[i].person.data(), *of_other = colors[i].surroundings.data();
    for (int y = 0; y < part.box.height; ++y) {
      const float* own = part.distance.ptr<float>(y);
      const int row = y + part.box.y - drawing.box.y, shift = part.box.x - drawing.box.x;
      const uint16_t* bin = bins.ptr<uint16_t>(row) + shift;
      float *to_person = person.ptr<float>(row) + shift, *to_other = other.ptr<float>(row) + shift;
      for (int x = 0; x < part.box.width; ++x) {
        if (own[x] > reach) continue;
        const float weight = weights[size_t(kWeightsPerSample * std::max(own[x], 0.f))];
        to_person[x] += weight * (of_person[bin[x]] + kFloor);
        to_other[x] += weight * (of_other[bin[x]] + kFloor);
      }
    }
  }
  for (int y = 0; y < person.rows; ++y) {
    float *p = person.ptr<float>(y), *o = other.ptr<float>(y);
    for (int x = 0; x < person.cols; ++x)
      p[x] = o[x] > 0 ? std::clamp(std::log(p[x] / o[x]), -kMaxLogOdds, kMaxLogOdds) : 0.f;
  }
  return person;
}

cv::Mat personColored(const cv::Mat& bins, const std::vector<PartColors>& colors) {
  std::vector<float> person(ColorBins::kCount), surroundings(ColorBins::kCount);
  int parts = 0;
  for (const PartColors& part : colors) {
    if (part.person.empty() || part.surroundings.empty()) continue;
    ++parts;
    for (size_t bin = 0; bin < person.size(); ++bin) {
      person[bin] += part.person.data()[bin];
      surroundings[bin] += part.surroundings.data()[bin];
    }
  }
  std::vector<uchar> is_person(ColorBins::kCount);
  for (size_t bin = 0; bin < person.size(); ++bin)
    is_person[bin] =
        person[bin] > kMinRatio * (surroundings[bin] + kFloor * float(parts)) ? 255 : 0;
  cv::Mat out(bins.size(), CV_8UC1);
  for (int y = 0; y < bins.rows; ++y)
    for (int x = 0; x < bins.cols; ++x) out.at<uchar>(y, x) = is_person[bins.at<uint16_t>(y, x)];
  return out;
}

}  // namespace markerless_mocap
