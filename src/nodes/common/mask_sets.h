#pragma once

#include <sensor_msgs/Image.h>

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "markerless_mocap/camera/frame_set_assembler.h"
#include "nodes/common/holding_queue.h"

namespace markerless_mocap {

/// The silhouettes of all cameras at one time; null where missing.
using MaskSet = FrameSetAssembler<sensor_msgs::ImageConstPtr>::FrameSet;

/// Number of silhouettes that a set has.
size_t countOf(const MaskSet& set);
/// Why a set is not used.
std::string lackOfMasks(size_t present, size_t cameras, size_t required);

/// Joins silhouettes into sets. Whoever joins the same silhouettes by the same rules gets sets with
/// the same stamps. A set whose images may still arrive waits, and so do those behind it.
class MaskSets {
 public:
  struct Rules {
    size_t cameras;
    size_t required;              ///< a set of fewer silhouettes is not used
    double tolerance, deadline;   ///< s, see AssemblerOptions
    std::vector<double> offsets;  ///< of the cameras' clocks, s; empty: they agree
  };
  /// \param must_wait whether images of a set may still arrive
  /// \param sink receives the sets, oldest first
  MaskSets(const Rules& rules, std::function<bool(const MaskSet&)> must_wait,
           std::function<void(const MaskSet&)> sink);

  /// Adds a silhouette and passes on the sets that are ready.
  void add(size_t camera, const sensor_msgs::ImageConstPtr& mask);
  /// Passes on the sets that need not wait any more.
  void passOn();

  /// Whether this is a lone silhouette between sets that have enough of them.
  bool isStray(const MaskSet& set) const;
  /// Notes that a set had enough silhouettes.
  void noteUsed(const MaskSet& set) { last_used_ns_ = set.stamp_ns; }

  const AssemblerOptions& options() const { return options_; }
  const AssemblerCounts& counts() const { return assembler_.counts(); }
  /// Silhouettes closer than this are one set, s; see FrameSetAssembler::tolerance().
  double tolerance() const { return assembler_.tolerance(); }
  StreamTiming timing(size_t camera) const { return assembler_.timing(camera); }

 private:
  size_t required_;
  AssemblerOptions options_;
  FrameSetAssembler<sensor_msgs::ImageConstPtr> assembler_;
  HoldingQueue<MaskSet> waiting_;  ///< joined, but without images
  std::function<bool(const MaskSet&)> must_wait_;
  std::function<void(const MaskSet&)> sink_;
  std::optional<int64_t> last_used_ns_;  ///< stamp of the last set with enough silhouettes
};

}  // namespace markerless_mocap
