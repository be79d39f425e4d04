#include "silhouette/background.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <fstream>
#include <stdexcept>

namespace markerless_mocap {
namespace {

/// First bytes of a file; numbers follow as the machine has them, little endian on all of ours.
constexpr char kMagic[] = "markerless_mocap background 1\n";
constexpr int kLargestSide = 16384;
/// One pixel in so many is asked for the usual noise.
constexpr size_t kNoiseStep = 61;

struct FileHead {
  char magic[sizeof(kMagic)];
  int32_t width, height, channels, modes;
};

bool isUsable(const FileHead& head) {
  const auto within = [](int value, int most) { return value >= 1 && value <= most; };
  return std::memcmp(head.magic, kMagic, sizeof(kMagic)) == 0 && within(head.width, kLargestSide) &&
         within(head.height, kLargestSide) && (head.channels == 1 || head.channels == 3) &&
         within(head.modes, Background::kMostModes);
}

template <class VectorT>
std::streamsize bytesOf(const VectorT& values) {
  return std::streamsize(values.size() * sizeof(values[0]));
}

}  // namespace

Background::Background(const cv::Size& size, int channels, int modes)
    : size_(size),
      channels_(channels),
      modes_(modes),
      stride_((size.width + 63) / 64 * 64),
      mean_(size_t(modes) * size.height * stride_ * channels, 0),
      sigma_(size_t(modes) * size.height * stride_, 0),
      weight_(sigma_.size(), 0) {}

void Background::setThreshold(double threshold_sigmas, double min_sigma) {
  const double largest = 32767;
  for (int row = 0; row < modes_ * size_.height; ++row)
    for (int x = 0; x < size_.width; ++x) {
      const size_t i = size_t(row) * stride_ + x;
      const double limit = threshold_sigmas * std::max(min_sigma, sigma_[i] / double(kMeanScale));
      weight_[i] = uint16_t(std::min(largest, std::round(kLimit * kWeightScale / limit)));
    }
  std::vector<uint16_t> sample;
  for (size_t i = 0; i < sigma_.size() / modes_; i += kNoiseStep)
    if (weight_[i] > 0) sample.push_back(sigma_[i]);
  std::nth_element(sample.begin(), sample.begin() + sample.size() / 2, sample.end());
  noise_ = std::max(min_sigma, sample[sample.size() / 2] / double(kMeanScale));
}

void Background::save(const std::string& path) const {
  FileHead head{{}, size_.width, size_.height, channels_, modes_};
  std::memcpy(head.magic, kMagic, sizeof(kMagic));
  std::ofstream file(path, std::ios::binary);
  file.write(reinterpret_cast<const char*>(&head), sizeof(head));
  file.write(reinterpret_cast<const char*>(mean_.data()), bytesOf(mean_));
  file.write(reinterpret_cast<const char*>(sigma_.data()), bytesOf(sigma_));
  file.close();
  if (!file) throw std::invalid_argument("the background file " + path + " cannot be written");
}

Background Background::load(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw std::invalid_argument("the background file " + path + " cannot be opened");
  FileHead head;
  if (!file.read(reinterpret_cast<char*>(&head), sizeof(head)) || !isUsable(head))
    throw std::invalid_argument("the file " + path + " holds no background of a silhouette");
  Background background({head.width, head.height}, head.channels, head.modes);
  file.read(reinterpret_cast<char*>(background.mean_.data()), bytesOf(background.mean_));
  file.read(reinterpret_cast<char*>(background.sigma_.data()), bytesOf(background.sigma_));
  if (!file || file.peek() != std::ifstream::traits_type::eof())
    throw std::invalid_argument("the background file " + path +
                                " is shorter or longer than its head says");
  return background;
}

}  // namespace markerless_mocap
