#include <algorithm>
#include <cmath>
#include <optional>

#include "evaluation/body_points.h"
#include "evaluation/foot_contact.h"
#include "exports/motion_description.h"

namespace markerless_mocap {
namespace {

using Eigen::Vector2d;

constexpr double kMaxFlicker_s = 0.1;  // shorter breaks of a contact are none
constexpr double kStill_m = 0.01;      // a point that has moved less has not moved
const Measure kUnknown{NAN, NAN};

/// A foot on the floor.
struct Contact {
  bool left = false;
  size_t first = 0, last = 0;         ///< frames
  bool lands = false, lifts = false;  ///< the frame before, and that after, are seen
  Vector2d place;                     ///< under the ankle, m
  double sigma_m = NAN;               ///< of the place along an axis
};

/// A deviation of a point, as the result has it, has three axes.
double sigmaAlongAxis(const PersonMotion& motion, size_t frame, bool left) {
  return motion.frames[frame].part_sigma_m[left ? 4 : 5] / std::sqrt(3.0);
}

/// The middle of the heel's round end in its link's frame: what the foot rolls on when it lands.
Eigen::Vector3d heelOf(const BodyModel& body, int link) {
  Eigen::Vector3d heel(HUGE_VAL, 0.0, 0.0);
  for (const RoundCone& cone : body.shape()) {
    if (cone.link != link) continue;
    for (const Eigen::Vector3d& end : {cone.a, cone.b})
      if (end.x() < heel.x()) heel = end;
  }
  return heel;
}

/// Ankles, heels and balls of the feet.
JointTrack footTrack(const PersonMotion& motion) {
  JointTrack track;
  track.names = bodyPointNames();
  track.names.insert(track.names.end(), {"l_heel", "r_heel"});
  for (const PersonFrame& frame : motion.frames) {
    const Eigen::Matrix3Xd body = bodyPoints(*motion.body, frame.T_world_link);
    Eigen::Matrix3Xd points(3, body.cols() + 2);
    points.leftCols(body.cols()) = body;
    for (const bool left : {true, false}) {
      const int link = motion.body->linkIndex(left ? "l_ankle" : "r_ankle");
      points.col(points.cols() - (left ? 2 : 1)) =
          frame.T_world_link[size_t(link)] * heelOf(*motion.body, link);
    }
    track.add(frame.stamp_ns, points);
  }
  return track;
}

/// One foot: it is on the floor while its heel or its ball rests there.
class Foot {
 public:
  Foot(const PersonMotion& motion, const JointTrack& track, bool left)
      : motion_(motion),
        left_(left),
        ankle_(track.select({left ? "l_ankle" : "r_ankle"})),
        heel_(track, left ? "l_heel" : "r_heel"),
        ball_(track, left ? "l_foot" : "r_foot") {}

  std::vector<Contact> contacts() const {
    std::vector<Contact> out;
    for (size_t f = 0; f < ankle_.frames(); ++f) {
      if (!heel_.rests[f] && !ball_.rests[f]) continue;
      if (!out.empty() && (out.back().last + 1 == f || isFlicker(out.back().last, f)))
        out.back().last = f;
      else
        out.push_back({left_, f, f, false, false, Vector2d::Zero(), NAN});
    }
    for (Contact& contact : out) complete(&contact);
    return out;
  }

 private:
  struct Point {
    Point(const JointTrack& all, const std::string& name)
        : track(all.select({name})), rests(footContact(all, all, name).truth) {}
    JointTrack track;
    std::vector<bool> rests;
  };

  bool isSeen(size_t frame) const { return ankle_.positions[frame].col(0).allFinite(); }

  bool isFlicker(size_t from, size_t to) const {
    for (size_t f = from; f <= to; ++f)
      if (!isSeen(f)) return false;
    return motion_.seconds(to) - motion_.seconds(from) < kMaxFlicker_s;
  }

  /// The speed that tells rest is measured over kContactSpan_s, so a point has rested for up to
  /// half of it before the first frame and after the last one that say so.
  size_t outermost(size_t frame, int step) const {
    const Point& point = heel_.rests[frame] ? heel_ : ball_;
    const Eigen::Vector3d place = point.track.positions[frame].col(0);
    size_t out = frame;
    while (out + size_t(step) < ankle_.frames() && isSeen(out + size_t(step)) &&
           std::abs(motion_.seconds(out + size_t(step)) - motion_.seconds(frame)) <=
               0.5 * kContactSpan_s + 1e-6 &&
           (point.track.positions[out + size_t(step)].col(0) - place).norm() < kStill_m)
      out += size_t(step);
    return out;
  }

  /// Places where the whole foot rests; where there are none, all of the contact.
  std::vector<size_t> restingFrames(const Contact& contact) const {
    std::vector<size_t> flat, all;
    for (size_t f = contact.first; f <= contact.last; ++f) {
      if (!isSeen(f)) continue;
      all.push_back(f);
      if (heel_.rests[f] && ball_.rests[f]) flat.push_back(f);
    }
    return flat.empty() ? all : flat;
  }

  void complete(Contact* contact) const {
    const std::vector<size_t> resting = restingFrames(*contact);
    contact->sigma_m = 0.0;
    for (const size_t f : resting) {
      contact->place += ankle_.positions[f].col(0).head<2>() / double(resting.size());
      contact->sigma_m += sigmaAlongAxis(motion_, f, left_) / double(resting.size());
    }
    contact->first = outermost(contact->first, -1);
    contact->last = outermost(contact->last, 1);
    contact->lands = contact->first > 0 && isSeen(contact->first - 1);
    contact->lifts = contact->last + 1 < ankle_.frames() && isSeen(contact->last + 1);
  }

  const PersonMotion& motion_;
  bool left_;
  JointTrack ankle_;
  Point heel_, ball_;
};

/// A contact begins or ends between two frames, when the foot is slower than kContactSpeed_m_s: it
/// is missed by as long as the foot takes for the error of its place.
double timeError(const PersonMotion& motion, size_t frame, bool left) {
  return std::hypot(motion.frameTime() / std::sqrt(12.0),
                    sigmaAlongAxis(motion, frame, left) / kContactSpeed_m_s);
}

Measure contactTime(const PersonMotion& motion, const Contact& contact) {
  if (!contact.lifts) return kUnknown;
  return {motion.seconds(contact.last + 1) - motion.seconds(contact.first),
          std::hypot(timeError(motion, contact.first, contact.left),
                     timeError(motion, contact.last, contact.left))};
}

Measure stepTime(const PersonMotion& motion, const Contact& other, const Contact& contact) {
  const double seconds = motion.seconds(contact.first) - motion.seconds(other.first);
  if (!other.lands || seconds > kMaxStep_s) return kUnknown;
  return {seconds, std::hypot(timeError(motion, other.first, other.left),
                              timeError(motion, contact.first, contact.left))};
}

std::optional<Step> stepTo(const PersonMotion& motion, const Contact& before, const Contact& other,
                           const Contact& contact) {
  const Vector2d stride = contact.place - before.place;
  if (!contact.lands || stride.norm() < kMinStride_m) return std::nullopt;
  const Vector2d along = stride.normalized(), offset = contact.place - other.place;
  const Vector2d to_own_side =
      contact.left ? Vector2d(-along.y(), along.x()) : Vector2d(along.y(), -along.x());
  const double error = std::hypot(contact.sigma_m, other.sigma_m);
  Step step;
  step.left = contact.left;
  step.seconds = motion.seconds(contact.first);
  step.length_m = {along.dot(offset), error};
  step.width_m = {to_own_side.dot(offset), error};
  step.step_s = stepTime(motion, other, contact);
  step.contact_s = contactTime(motion, contact);
  return step;
}

}  // namespace

std::vector<Step> stepsOf(const PersonMotion& motion) {
  const JointTrack track = footTrack(motion);
  std::vector<Contact> contacts = Foot(motion, track, true).contacts();
  const std::vector<Contact> right = Foot(motion, track, false).contacts();
  contacts.insert(contacts.end(), right.begin(), right.end());
  std::stable_sort(contacts.begin(), contacts.end(),
                   [](const Contact& a, const Contact& b) { return a.first < b.first; });
  std::vector<Step> steps;
  const Contact* last[2] = {nullptr, nullptr};  // of each foot
  for (const Contact& contact : contacts) {
    const Contact *before = last[contact.left], *other = last[!contact.left];
    if (before && other)
      if (const auto step = stepTo(motion, *before, *other, contact)) steps.push_back(*step);
    last[contact.left] = &contact;
  }
  return steps;
}

}  // namespace markerless_mocap
