#pragma once

#include <algorithm>
#include <cstring>
#include <string>
#include <vector>

namespace markerless_mocap {

/// Takes values from the bytes of an input, one after another; zeros after its end.
class ByteSource {
 public:
  ByteSource(const uint8_t* data, size_t size) : at_(data), end_(data + size) {}

  template <class T>
  T number() {
    T value{};
    const size_t bytes = std::min(sizeof(T), left());
    std::memcpy(&value, at_, bytes);
    at_ += bytes;
    return value;
  }
  size_t left() const { return size_t(end_ - at_); }
  /// A length of at most `max`, and of no more than the bytes that are left.
  size_t length(size_t max) { return std::min({size_t(number<uint8_t>()), max, left()}); }
  std::string text() {
    const size_t size = length(40);
    at_ += size;
    return std::string(at_ - size, at_);
  }
  std::vector<uint8_t> rest() {
    const uint8_t* from = at_;
    at_ = end_;
    return std::vector<uint8_t>(from, end_);
  }

 private:
  const uint8_t *at_, *end_;
};

}  // namespace markerless_mocap
