#include "tools/join_results/join_results.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <set>

#include "files/whole_file.h"
#include "markerless_mocap/ros/messages.h"
#include "ros/camera_conversions.h"
#include "ros/ids_list.h"
#include "tools/common/bag_io.h"
#include "tools/common/result_figures.h"

namespace markerless_mocap {
namespace {

constexpr int64_t kAgreeing = 1000000000;   // ns, at the end of the overlap
constexpr int64_t kUnfinished = 250000000;  // ns, at the end of the earlier part

bool hasPose(const ResultFrame& frame) {
  return frame.status != FrameStatus::kLost;
}

/// Mean distance of the joints that both have at a time, metres; NaN if there are none.
double distanceAt(int64_t stamp_ns, const JointTrack& a, const JointTrack& b) {
  const auto pointsAt = [&](const JointTrack& track) -> const Eigen::Matrix3Xd& {
    const auto found = std::lower_bound(track.stamps_ns.begin(), track.stamps_ns.end(), stamp_ns);
    return track.positions[size_t(found - track.stamps_ns.begin())];
  };
  const Eigen::RowVectorXd distances = (pointsAt(a) - pointsAt(b)).colwise().norm();
  double sum = 0.0;
  int count = 0;
  for (const double distance : distances)
    if (std::isfinite(distance)) {
      sum += distance;
      ++count;
    }
  return sum / count;
}

std::string text(const char* format, double value) {
  char out[64];
  std::snprintf(out, sizeof out, format, value);
  return out;
}

/// Why two frames of the same time differ; empty: they agree.
std::string differenceOf(const ResultFrame& earlier, const ResultFrame& later, double distance,
                         double max_distance_m) {
  if (hasPose(earlier) != hasPose(later))
    return std::string("only the ") + (hasPose(earlier) ? "earlier" : "later") + " one has a pose";
  if (hasPose(earlier) && !(distance <= max_distance_m))
    return std::isfinite(distance) ? "their joints are " + text("%.1f mm apart", 1e3 * distance)
                                   : "they have no joint in common";
  return "";
}

using CommonFrames = std::vector<std::pair<const ResultFrame*, const ResultFrame*>>;

CommonFrames commonFrames(const ResultRecord& earlier, const ResultRecord& later) {
  CommonFrames common;
  if (earlier.frames.empty()) return common;
  const int64_t end_ns = earlier.frames.back().stamp_ns - kUnfinished;
  auto b = later.frames.begin();
  for (const ResultFrame& a : earlier.frames) {
    while (b != later.frames.end() && b->stamp_ns < a.stamp_ns) ++b;
    if (b == later.frames.end() || a.stamp_ns > end_ns) break;
    if (b->stamp_ns == a.stamp_ns) common.emplace_back(&a, &*b);
  }
  // Who is found after the end of the earlier part has been followed back into it.
  while (!common.empty() && !hasPose(*common.back().first) && hasPose(*common.back().second))
    common.pop_back();
  return common;
}

/// Copies messages of one part; remembers what was latched, which is written once.
class Joiner {
 public:
  explicit Joiner(const std::string& output) : bag_(output) {}

  /// \param after_ns, until_ns stamps of the frame sets: later than the first, not later than the
  ///   second
  void add(const std::string& path, int64_t after_ns, int64_t until_ns) {
    rosbag::Bag part;
    openForReading(path, part);
    std::set<std::string> latched;
    for (const rosbag::MessageInstance& message : rosbag::View(part)) {
      const auto header = message.getConnectionHeader();
      const auto latching = header->find("latching");
      // The bodies that are tracked are latched, too, but change.
      const bool is_latched = latching != header->end() && latching->second == "1" &&
                              message.getTopic() != kTrackedBodies;
      if (is_latched) {
        latched.insert(message.getTopic());
        if (latched_.count(message.getTopic()) > 0) continue;
      } else if (const int64_t stamp = nanosecondsOf(message.getTime());
                 stamp <= after_ns || stamp > until_ns) {
        continue;
      }
      bag_.copy(message);
      if (message.getTopic() == "/pose") count(message);
    }
    latched_.merge(latched);
  }

  void commit() { bag_.commit(); }
  const ResultFigures& figures() const { return figures_; }

 private:
  void count(const rosbag::MessageInstance& message) {
    const auto pose = messageOf<BodyPoseMsg>(message);
    if (!pose) return;
    const PoseStatus status = pose->status == BodyPoseMsg::TRACKED ? PoseStatus::kTracked
                              : pose->status == BodyPoseMsg::REINITIALIZED
                                  ? PoseStatus::kReinitialized
                                  : PoseStatus::kLost;
    std::array<double, kPartCount> sigma_m;
    std::copy(pose->part_deviation.begin(), pose->part_deviation.end(), sigma_m.begin());
    figures_.add(nanosecondsOf(pose->header.stamp), status, pose->silhouette_overlap, sigma_m);
  }

  BagWriter bag_;
  std::set<std::string> latched_;
  ResultFigures figures_;
};

std::vector<Seam> findSeams(const JoinOptions& options) {
  std::vector<Seam> seams;
  ResultRecord earlier = readResults(options.parts.front(), "");
  for (size_t i = 1; i < options.parts.size(); ++i) {
    ResultRecord later = readResults(options.parts[i], "");
    try {
      seams.push_back(findSeam(earlier, later, options.max_distance_m));
    } catch (const Disagreement& error) {
      Disagreement named("parts " + std::to_string(i) + " and " + std::to_string(i + 1) +
                         " do not agree: " + error.what());
      named.later_part = i;
      throw named;
    }
    earlier = std::move(later);
  }
  return seams;
}

}  // namespace

Seam findSeam(const ResultRecord& earlier, const ResultRecord& later, double max_distance_m) {
  const CommonFrames common = commonFrames(earlier, later);
  if (common.empty()) throw Disagreement("they have no frame sets in common");
  Seam seam;
  seam.stamp_ns = common.back().first->stamp_ns;
  for (auto pair = common.rbegin(); pair != common.rend(); ++pair) {
    const auto& [a, b] = *pair;
    const int64_t before_ns = seam.stamp_ns - a->stamp_ns;
    if (before_ns > kAgreeing) return seam;
    const bool both = hasPose(*a) && hasPose(*b);
    const double distance = both ? distanceAt(a->stamp_ns, earlier.joints, later.joints) : 0.0;
    const std::string difference = differenceOf(*a, *b, distance, max_distance_m);
    if (!difference.empty())
      throw Disagreement(
          text("%.2f s before the end of their overlap, ", 1e-9 * double(before_ns)) + difference);
    ++seam.frame_sets;
    seam.largest_distance_m = std::max(seam.largest_distance_m, distance);
  }
  throw Disagreement(text("their overlap of %.2f s is too short",
                          1e-9 * double(seam.stamp_ns - common.front().first->stamp_ns)));
}

std::vector<Seam> joinResults(const JoinOptions& options) {
  const std::vector<Seam> seams = findSeams(options);
  Joiner joiner(options.output);
  int64_t after_ns = std::numeric_limits<int64_t>::min();
  for (size_t i = 0; i < options.parts.size(); ++i) {
    const bool is_last = i == seams.size();
    const int64_t until_ns = is_last ? std::numeric_limits<int64_t>::max() : seams[i].stamp_ns;
    joiner.add(options.parts[i], after_ns, until_ns);
    after_ns = until_ns;
  }
  joiner.commit();
  if (!options.figures.empty()) writeWholeFile(options.figures, joiner.figures().json());
  return seams;
}

}  // namespace markerless_mocap
