#include "nodes/visual_hull/live_carver.h"

#include <chrono>
#include <stdexcept>
#include <utility>

namespace markerless_mocap {

void LiveCarver::prepare(const HullOptions& options) {
  Ready ready{options, {}, {}};
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    ready.rig = rig_;
  }
  if (ready.rig) ready.carver.emplace(*ready.rig, options);
  const std::lock_guard<std::mutex> lock(mutex_);
  ready_ = std::move(ready);
}

bool LiveCarver::takeNew() {
  const bool has_settings = takeSettings();
  return takeRig() || has_settings;
}

void LiveCarver::changeRig(const CameraRig& rig) {
  error_.clear();
  if (!carver_) return;
  next_rig_ = std::make_shared<const CameraRig>(rig);
  if (!next_.valid()) makeNext();  // else takeRig() does, when that is done
}

void LiveCarver::makeNext() {
  making_rig_ = next_rig_;
  next_ = std::async(std::launch::async,
                     [rig = next_rig_, options = options_] { return HullCarver(*rig, options); });
}

bool LiveCarver::takeRig() {
  if (!next_.valid() || next_.wait_for(std::chrono::seconds(0)) != std::future_status::ready)
    return false;
  std::future<HullCarver> made = std::move(next_);
  if (making_rig_ != next_rig_) {  // another one is wanted by now, or none
    if (next_rig_) makeNext();
    return false;
  }
  const RigPointer rig = std::exchange(next_rig_, nullptr);
  try {
    use(made.get(), rig);
  } catch (const std::invalid_argument& error) {
    use(std::nullopt, nullptr);
    error_ = error.what();
    throw;
  }
  return true;
}

bool LiveCarver::takeSettings() {
  std::optional<Ready> ready;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    ready.swap(ready_);
  }
  if (!ready) return false;
  options_ = ready->options;
  error_.clear();
  const bool is_usable = ready->carver && ready->rig == rig_;
  use(is_usable ? std::move(ready->carver) : std::nullopt, is_usable ? ready->rig : nullptr);
  if (next_rig_)
    changeRig(*std::exchange(next_rig_, nullptr));  // it was made with the old settings
  return is_usable;
}

void LiveCarver::forgetRig() {
  error_.clear();
  next_rig_.reset();
  use(std::nullopt, nullptr);
}

void LiveCarver::make(CameraRig rig) {
  if (!error_.empty()) throw std::invalid_argument(error_);
  try {
    const auto shared = std::make_shared<const CameraRig>(rig);
    use(HullCarver(std::move(rig), options_), shared);
  } catch (const std::invalid_argument& error) {
    error_ = error.what();
    throw;
  }
}

Eigen::AlignedBox3d LiveCarver::volume() const {
  if (options_.volume == "explicit") return {options_.volume_min, options_.volume_max};
  const VoxelLattice& lattice = carver_->lattice();
  return {lattice.origin, lattice.origin + lattice.pitch * lattice.size.cast<double>()};
}

void LiveCarver::use(std::optional<HullCarver> carver, RigPointer rig) {
  carver_ = std::move(carver);
  const std::lock_guard<std::mutex> lock(mutex_);
  rig_ = std::move(rig);
}

}  // namespace markerless_mocap
