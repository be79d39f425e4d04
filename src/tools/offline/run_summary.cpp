#include "tools/offline/run_summary.h"

#include <algorithm>
#include <iomanip>

namespace markerless_mocap {
namespace {

constexpr size_t kReasonsShown = 3;
constexpr double kBelievable = 0.5;  // mean IoU; right poses in a room that is unknown have 0.65

double secondsBetween(std::chrono::steady_clock::time_point a,
                      std::chrono::steady_clock::time_point b) {
  return std::chrono::duration<double>(b - a).count();
}

}  // namespace

RunSummary::RunSummary(bool with_trees)
    : started_(Clock::now()), prepared_(started_), with_trees_(with_trees) {
  for (const char* step :
       {kReading, SilhouetteOptions::kStage, HullOptions::kStage, SegmentationOptions::kStage,
        PoseTreeOptions::kStage, TrackerOptions::kStage, kWriting})
    times_.push_back({step, 0.0, 0});
}

void RunSummary::timed(const std::string& step, const std::function<void()>& work) {
  const Clock::time_point start = Clock::now();
  work();
  const double seconds = secondsBetween(start, Clock::now());
  const std::lock_guard<std::mutex> lock(*times_mutex_);
  for (Time& time : times_)
    if (time.step == step) {
      time.seconds += seconds;
      ++time.runs;
    }
}

void RunSummary::add(const PipelineResult& result) {
  ++frame_sets_;
  if (result.learning) {
    ++learning_;
    return;
  }
  empty_hulls_ += result.hull.status != HullStatus::kOk;
  valid_trees_ += result.tree.valid();
  switch (result.pose.status) {
    case PoseStatus::kTracked:
      ++tracked_;
      break;
    case PoseStatus::kReinitialized:
      ++reinitialized_;
      break;
    case PoseStatus::kLost:
      ++lost_;
      reasons_.add(result.pose.reason);
  }
}

void RunSummary::addOverlaps(const std::vector<double>& overlaps) {
  for (const double iou : overlaps) iou_sum_ += iou;
  views_ += int(overlaps.size());
}

void RunSummary::print(std::ostream& out) const {
  out << "frame sets     " << frame_sets_ << ", " << learning_
      << " of them for learning the background\n"
      << "poses          " << tracked_ << " tracked, " << reinitialized_ << " reinitialized, "
      << lost_ << " lost\n";
  printReasons(out);
  if (with_trees_) out << "pose trees     " << valid_trees_ << " valid of " << processed() << '\n';
  if (views_ > 0)
    out << "overlap        " << std::setprecision(3) << meanIou()
        << " mean IoU of the body's silhouettes and the masks, " << views_ << " views\n";
  printTimes(out);
  if (!calibration_finding_.empty()) out << calibration_finding_ << '\n';
  if (poses() > 0 && views_ > 0 && meanIou() < kBelievable)
    out << "The body and the silhouettes hardly overlap: these poses are probably wrong. Look at "
           "the "
           "pictures of --report before you use them.\n";
  if (processed() == 0 || poses() > 0) return;
  out << "No frame has a pose: all poses in the bag are LOST.\n";
  if (empty_hulls_ > processed() / 2)
    out << "In " << empty_hulls_ << " of " << processed()
        << " frame sets the silhouettes show nobody. Whoever keeps still in a whole recording is "
           "taken for the room:\nfilm the empty room, too (import_recording --background), or "
           "somebody who moves.\n";
  out << "check_recording tells what may be wrong with the recording, the pictures of --report "
         "show "
         "what the cameras saw:\nthe person must be seen from head to foot by most of them.\n";
}

void RunSummary::printReasons(std::ostream& out) const {
  const std::vector<ReasonCounts::Reason> reasons = reasons_.sorted();
  for (size_t i = 0; i < std::min(reasons.size(), kReasonsShown); ++i)
    out << "  lost " << std::setw(6) << reasons[i].count << " times: " << reasons[i].example
        << '\n';
}

void RunSummary::printTimes(std::ostream& out) const {
  const Clock::time_point now = Clock::now();
  const double seconds = secondsBetween(prepared_, now);
  out << std::fixed << std::setprecision(1);
  for (const Time& time : times_)
    out << "  " << std::left << std::setw(18) << time.step << std::right << std::setw(8)
        << 1e3 * time.seconds / std::max(time.runs, 1) << " ms per frame set\n";
  out << "speed          " << frame_sets_ / std::max(seconds, 1e-9) << " frame sets per second for "
      << seconds << " s; " << secondsBetween(started_, now)
      << " s in all, with what had to be prepared\n"
      << std::defaultfloat << std::setprecision(6);
}

}  // namespace markerless_mocap
