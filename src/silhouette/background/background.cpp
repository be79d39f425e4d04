#include "silhouette/background/background.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "numerics/order_statistics.h"
#include "silhouette/background/row_kernels.h"

namespace markerless_mocap {
namespace {

/// First bytes of a file. The numbers that follow are in the machine's byte order, little endian on
/// all supported ones.
constexpr char kMagic[] = "markerless_mocap background 1\n";
constexpr int kLargestSide = 16384;
/// The noise is the median over one pixel in this many.
constexpr int kNoiseStep = 61;

struct FileHead {
  char magic[sizeof(kMagic)];
  int32_t width, height, channels, modes;
};

bool isUsable(const FileHead& head) {
  const auto within = [](int value, int max) { return value >= 1 && value <= max; };
  return std::memcmp(head.magic, kMagic, sizeof(kMagic)) == 0 && within(head.width, kLargestSide) &&
         within(head.height, kLargestSide) && (head.channels == 1 || head.channels == 3) &&
         within(head.modes, Background::kMaxModes);
}

[[noreturn]] void throwLength(const std::string& path) {
  throw std::invalid_argument("the background file " + path +
                              " is shorter or longer than its head says");
}

/// Before there is memory for what the head says: gigabytes, where it is damaged.
void checkLength(const std::string& path, const FileHead& head) {
  const uintmax_t least = uintmax_t(head.width) * head.height * head.channels * head.modes;
  std::error_code error;
  if (std::filesystem::file_size(path, error) < least || error) throwLength(path);
}

template <class VectorT>
std::streamsize bytesOf(const VectorT& values) {
  return std::streamsize(values.size() * sizeof(typename VectorT::value_type));
}

}  // namespace

Background::Background(const cv::Size& size, int channels, int modes)
    : size_(size),
      channels_(channels),
      modes_(modes),
      stride_((size.width + 63) / 64 * 64),
      mean_(size_t(modes) * size.height * stride_ * channels, 0),
      sigma_(size_t(modes) * size.height * stride_, 0),
      quantised_(sigma_.size() * (channels + 1), 0) {}

ModeRow Background::quantised(int mode, int y) const {
  const uint8_t* row = &quantised_[quantisedOffset(mode, y)];
  ModeRow quantised{{}, row + size_t(channels_) * stride_, int16_t(weight_unit_)};
  for (int c = 0; c < channels_; ++c) quantised.mean[c] = row + size_t(c) * stride_;
  return quantised;
}

void Background::updateQuantised(int mode, int y) {
  roundMeans(mean(mode, y, 0), channels_ * stride_, &quantised_[quantisedOffset(mode, y)]);
}

void Background::setThreshold(double threshold_sigmas, double min_sigma) {
  const auto weight_of = [&](double sigma) {
    const double limit = threshold_sigmas * std::max(min_sigma, sigma);
    return std::min(32767.0, kLimit * kWeightScale / limit);
  };
  weight_unit_ = int(std::ceil(weight_of(min_sigma) / 255));
  std::vector<uint16_t> sample;
  for (int mode = 0; mode < modes_; ++mode)
    for (int y = 0; y < size_.height; ++y) {
      updateQuantised(mode, y);
      uint8_t* weights = &quantised_[quantisedOffset(mode, y) + size_t(channels_) * stride_];
      for (int x = 0; x < size_.width; ++x)
        weights[x] =
            uint8_t(std::lround(weight_of(sigma(mode, y)[x] / double(kMeanScale)) / weight_unit_));
      for (int x = y % kNoiseStep; x < size_.width; x += kNoiseStep)
        sample.push_back(sigma(mode, y)[x]);
    }
  if (sample.empty()) sample.push_back(0);
  noise_ = std::max(min_sigma, medianAmong(sample) / double(kMeanScale));
}

void Background::save(const std::string& path) const {
  FileHead head{{}, size_.width, size_.height, channels_, modes_};
  std::memcpy(head.magic, kMagic, sizeof(kMagic));
  std::ofstream file(path, std::ios::binary);
  file.write(reinterpret_cast<const char*>(&head), sizeof(head));
  file.write(reinterpret_cast<const char*>(mean_.data()), bytesOf(mean_));
  file.write(reinterpret_cast<const char*>(sigma_.data()), bytesOf(sigma_));
  file.write(reinterpret_cast<const char*>(unknown_.words().data()), bytesOf(unknown_.words()));
  file.close();
  if (!file) throw std::invalid_argument("the background file " + path + " cannot be written");
}

Background Background::load(const std::string& path) {
  if (std::error_code ignored;
      std::filesystem::exists(path, ignored) && !std::filesystem::is_regular_file(path, ignored))
    throw std::invalid_argument("the background file " + path +
                                " is a folder, pipe or device, allowed are files");
  std::ifstream file(path, std::ios::binary);
  if (!file) throw std::invalid_argument("the background file " + path + " cannot be opened");
  FileHead head;
  if (!file.read(reinterpret_cast<char*>(&head), sizeof(head)) || !isUsable(head))
    throw std::invalid_argument("the file " + path + " holds no background of a silhouette");
  checkLength(path, head);
  Background background({head.width, head.height}, head.channels, head.modes);
  file.read(reinterpret_cast<char*>(background.mean_.data()), bytesOf(background.mean_));
  file.read(reinterpret_cast<char*>(background.sigma_.data()), bytesOf(background.sigma_));
  if (file && file.peek() != std::ifstream::traits_type::eof()) {
    background.unknown_.resize(background.size_);
    std::vector<uint64_t>& words = background.unknown_.words();
    file.read(reinterpret_cast<char*>(words.data()), bytesOf(words));
  }
  if (!file || file.peek() != std::ifstream::traits_type::eof()) throwLength(path);
  return background;
}

}  // namespace markerless_mocap
