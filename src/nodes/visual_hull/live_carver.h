#pragma once

#include <future>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "markerless_mocap/hull/hull_carver.h"

namespace markerless_mocap {

/// The carver of a stage whose rig and settings may change. Making one takes as long as several
/// frame sets, so that of new settings is made while the old one works.
class LiveCarver {
 public:
  explicit LiveCarver(const HullOptions& options) : options_(options) {}

  /// Makes new settings ready. The only function for other threads. Throws std::invalid_argument as
  /// HullCarver if they are not for the rig that is used; then the old ones stay.
  void prepare(const HullOptions& options);

  /// Takes over settings, and the carver of a rig that has changed, if they are ready. Returns
  /// whether there is a new carver. Throws std::invalid_argument as HullCarver if there can be none
  /// for the new rig.
  bool takeNew();
  /// The rig has changed: the old carver works until that of the new rig is made. Nothing happens
  /// if there is none, as the next one is made then.
  void changeRig(const CameraRig& rig);
  /// The rig that a carver is being made of while the old one works; null: none.
  const CameraRig* nextRig() const { return next_rig_.get(); }
  /// The rig has changed, and nothing is known of the new one.
  void forgetRig();
  /// Makes a carver. Throws std::invalid_argument as HullCarver; so does every later call until the
  /// rig or the settings change.
  void make(CameraRig rig);
  /// The volume of the carver, m in world: as set, or that of an automatic one's lattice.
  Eigen::AlignedBox3d volume() const;
  /// Why a carver could not be made; empty: none was tried.
  const std::string& error() const { return error_; }

  explicit operator bool() const { return carver_.has_value(); }
  HullCarver* operator->() { return &*carver_; }
  const HullCarver* operator->() const { return &*carver_; }

 private:
  using RigPointer = std::shared_ptr<const CameraRig>;
  struct Ready {
    HullOptions options;
    RigPointer rig;  ///< that the carver is for; null: it is not known yet
    std::optional<HullCarver> carver;
  };
  bool takeSettings();
  bool takeRig();
  void makeNext();
  void use(std::optional<HullCarver> carver, RigPointer rig);

  HullOptions options_;
  std::optional<HullCarver> carver_;
  std::string error_;
  RigPointer next_rig_;           ///< the next carver's; null: none is wanted
  RigPointer making_rig_;         ///< next_'s; not next_rig_: it is too late
  std::future<HullCarver> next_;  ///< valid while it is made
  std::mutex mutex_;
  RigPointer rig_;  ///< of carver_
  std::optional<Ready> ready_;
};

}  // namespace markerless_mocap
