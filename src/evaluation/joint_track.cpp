#include "evaluation/joint_track.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <stdexcept>
#include <utility>

#include "numerics/order_statistics.h"

namespace markerless_mocap {

int JointTrack::indexOf(const std::string& name) const {
  const auto found = std::find(names.begin(), names.end(), name);
  return found == names.end() ? -1 : int(found - names.begin());
}

void JointTrack::add(int64_t stamp_ns, Eigen::Matrix3Xd points) {
  if (points.cols() != Eigen::Index(names.size()))
    throw std::invalid_argument("a frame has " + std::to_string(points.cols()) + " points for " +
                                std::to_string(names.size()) + " names");
  if (!stamps_ns.empty() && stamp_ns <= stamps_ns.back())
    throw std::invalid_argument("stamps of a track must be ascending");
  stamps_ns.push_back(stamp_ns);
  positions.push_back(std::move(points));
}

JointTrack JointTrack::select(const std::vector<std::string>& wanted) const {
  JointTrack out;
  out.names = wanted;
  out.stamps_ns = stamps_ns;
  for (const Eigen::Matrix3Xd& points : positions) {
    Eigen::Matrix3Xd& some =
        out.positions.emplace_back(Eigen::Matrix3Xd::Constant(3, wanted.size(), NAN));
    for (size_t i = 0; i < wanted.size(); ++i)
      if (const int from = indexOf(wanted[i]); from >= 0) some.col(i) = points.col(from);
  }
  return out;
}

std::string otherSide(const std::string& name) {
  if (name.rfind("l_", 0) == 0) return "r_" + name.substr(2);
  if (name.rfind("r_", 0) == 0) return "l_" + name.substr(2);
  return name;
}

int64_t frameTime(const std::vector<int64_t>& stamps_ns) {
  if (stamps_ns.size() < 2) return 0;
  std::vector<int64_t> steps;
  for (size_t i = 1; i < stamps_ns.size(); ++i) steps.push_back(stamps_ns[i] - stamps_ns[i - 1]);
  return medianAmong(steps);
}

std::vector<int> matchStamps(const std::vector<int64_t>& wanted_ns,
                             const std::vector<int64_t>& given_ns, int64_t tolerance_ns) {
  std::vector<int> match(wanted_ns.size(), -1);
  for (size_t g = 0; g < given_ns.size() && !wanted_ns.empty(); ++g) {
    const auto after = std::lower_bound(wanted_ns.begin(), wanted_ns.end(), given_ns[g]);
    const auto gap = [&](int64_t wanted) { return std::llabs(wanted - given_ns[g]); };
    auto nearest = after == wanted_ns.end() ? after - 1 : after;
    if (nearest != wanted_ns.begin() && gap(*(nearest - 1)) <= gap(*nearest)) --nearest;
    if (gap(*nearest) > tolerance_ns) continue;
    int& best = match[nearest - wanted_ns.begin()];
    if (best < 0 || gap(*nearest) < std::llabs(*nearest - given_ns[best])) best = int(g);
  }
  return match;
}

JointTrack alignedTo(const JointTrack& truth, const JointTrack& estimate) {
  const JointTrack named = estimate.select(truth.names);
  const auto tolerance = int64_t(kStampTolerance * double(frameTime(truth.stamps_ns)));
  const std::vector<int> match = matchStamps(truth.stamps_ns, named.stamps_ns, tolerance);
  JointTrack out;
  out.names = truth.names;
  out.stamps_ns = truth.stamps_ns;
  for (const int from : match)
    out.positions.push_back(from < 0 ? Eigen::Matrix3Xd::Constant(3, truth.names.size(), NAN)
                                     : named.positions[from]);
  return out;
}

}  // namespace markerless_mocap
