#pragma once

#include <algorithm>
#include <functional>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "nodes/common/hull_grids.h"
#include "nodes/common/live_options.h"
#include "nodes/common/stage_inputs.h"
#include "ros/parameters.h"

namespace markerless_mocap {

/// What stages have in common that make something of each hull: their options, which may change
/// between hulls, and that they rest while nobody listens. Declare it last in its owner, so that it
/// is destroyed first.
template <class OptionsT>
class HullFollower {
 public:
  /// Loads the options; throws std::invalid_argument if they are wrong.
  /// \param private_handle, live_handle private to the node; the last one of several threads
  /// \param name of the node \param stage its name for people
  HullFollower(const ros::NodeHandle& handle, const ros::NodeHandle& private_handle,
               const ros::NodeHandle& live_handle, const std::string& name,
               const std::string& stage)
      : handle_(handle),
        live_handle_(live_handle),
        options_(loaded(private_handle, name)),
        status_(handle, private_handle, stage) {}

  /// Those that were loaded.
  const OptionsT& options() const { return options_; }
  StageStatus& status() { return status_; }

  /// Before follow(): the stage rests while nobody listens to any of these topics.
  template <class MessageT>
  ros::Publisher advertise(const std::string& topic, uint32_t queue) {
    publishers_.push_back(handle_.advertise<MessageT>(topic, queue));
    return publishers_.back();
  }

  using Process = std::function<void(const sensor_msgs::PointCloud2& hull, const HullGrids& grids)>;
  /// Calls `take` when the options change and `process` for each hull, one at a time.
  /// \param products what the stage makes, such as "trees"
  void follow(const std::string& products, std::function<void(const OptionsT&)> take,
              Process process) {
    inputs_.emplace(handle_, &status_);
    inputs_->template listenToLatched<VoxelGrid>(
        "hull/grid", StageInputs::kOptional, [this](const VoxelGridConstPtr& grid) {
          const std::lock_guard<std::mutex> lock(mutex_);
          if (const std::string fault = grids_.add(grid); !fault.empty()) status_.remark(fault);
        });
    inputs_->template listen<sensor_msgs::PointCloud2>(
        "hull/points", 2, StageInputs::kRequired,
        [this, products, process](const sensor_msgs::PointCloud2ConstPtr& hull) {
          const std::lock_guard<std::mutex> lock(mutex_);
          if (!isWanted()) return status_.ok("it rests, nobody asks for " + products);
          process(*hull, grids_);
        });
    live_.emplace(live_handle_, options_, std::set<std::string>(),
                  [this, take](const OptionsT& changed) {
                    const std::lock_guard<std::mutex> lock(mutex_);
                    take(changed);
                  });
  }

 private:
  static OptionsT loaded(const ros::NodeHandle& private_handle, const std::string& name) {
    OptionsT options;
    loadOptionsTogether(parametersOf(private_handle), name, options);
    return options;
  }
  bool isWanted() const {
    return std::any_of(publishers_.begin(), publishers_.end(),
                       [](const ros::Publisher& one) { return one.getNumSubscribers() > 0; });
  }

  ros::NodeHandle handle_, live_handle_;
  OptionsT options_;
  std::mutex mutex_;  ///< settings change between hulls
  HullGrids grids_;
  StageStatus status_;
  std::vector<ros::Publisher> publishers_;
  std::optional<StageInputs> inputs_;
  std::optional<LiveOptions<OptionsT>> live_;
};

}  // namespace markerless_mocap
