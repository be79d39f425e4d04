#include "ros/lacking_cameras.h"

#include <algorithm>

namespace markerless_mocap {
namespace {

constexpr double kPatience = 2.0;  // s; messages of cameras that start together come within it

}  // namespace

bool LackingCameras::settle(const std::vector<std::string>& lacks, double now,
                            std::vector<std::string>* remarks) {
  const auto known = size_t(std::count(lacks.begin(), lacks.end(), ""));
  if (known < required_) return false;
  if (!waiting_since_) waiting_since_ = now;
  const bool waits = now - *waiting_since_ < kPatience;
  bool changed = false;
  for (size_t i = 0; i < cameras_.size(); ++i) {
    if (is_left_out_[i] && lacks[i].empty()) {
      is_left_out_[i] = false;
      remarks->push_back(cameras_[i] + " is known now and used");
      changed = true;
    }
    if (lacks[i].empty() || waits) continue;
    changed = changed || !is_left_out_[i];
    is_left_out_[i] = true;
    remarks->push_back(lacks[i] + "; the other cameras are used without it");
  }
  return changed;
}

}  // namespace markerless_mocap
