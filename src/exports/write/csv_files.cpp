#include <array>

#include "exports/export_formats.h"
#include "exports/write/number_text.h"

namespace markerless_mocap {
namespace {

constexpr double kDegrees = 180.0 / M_PI;

/// "12.345000000"
std::string stampText(int64_t ns) {
  char text[64];
  std::snprintf(text, sizeof text, "%lld.%09lld", static_cast<long long>(ns / 1000000000),
                static_cast<long long>(ns % 1000000000));
  return text;
}

std::string beginOfRow(const PersonMotion& motion, size_t frame) {
  return stampText(motion.frames[frame].stamp_ns) + ',' + numberText(motion.seconds(frame), 6) +
         ',' + std::to_string(frame + 1) + ',';
}

std::string placeText(const Eigen::Vector3d& place, const Eigen::Quaterniond& turn) {
  std::string text;
  for (int axis = 0; axis < 3; ++axis) text += ',' + numberOrNothing(place[axis], 6);
  for (const double value : {turn.x(), turn.y(), turn.z(), turn.w()})
    text += ',' + numberOrNothing(value, 7);
  return text;
}

const char* stateText(const PersonFrame& frame, int link) {
  if (link < 0 || !frame.isKnown(link)) return "not seen";
  return frame.filled[size_t(link)] ? "filled" : "seen";
}

std::string secondsText(const PersonMotion& motion, size_t frame) {
  return numberText(motion.seconds(frame), 6);
}

}  // namespace

std::string pointsCsvOf(const PersonMotion& motion, const std::vector<NamedPoint>& points) {
  std::string out = "stamp_s,time_s,frame,joint,x_m,y_m,z_m,qx,qy,qz,qw,expected_error_m,state\n";
  for (size_t f = 0; f < motion.frames.size(); ++f) {
    const PersonFrame& frame = motion.frames[f];
    const Eigen::Matrix3Xd places = placesOf(points, *motion.body, frame);
    for (size_t i = 0; i < points.size(); ++i) {
      const int link = linkOf(points[i], *motion.body);
      Eigen::Quaterniond turn(NAN, NAN, NAN, NAN);
      if (link >= 0 && frame.isKnown(link))
        turn = Eigen::Quaterniond(frame.T_world_link[size_t(link)].linear());
      const double error =
          places.col(Eigen::Index(i)).allFinite() ? expectedError(points[i], frame) : double(NAN);
      out += beginOfRow(motion, f) + points[i].name + placeText(places.col(Eigen::Index(i)), turn) +
             ',' + numberOrNothing(error, 6) + ',' + stateText(frame, link) + '\n';
    }
  }
  return out;
}

std::string anglesCsvOf(const PersonMotion& motion) {
  const std::string suffix = "_" + motion.body->id();
  std::string out = "stamp_s,time_s,frame,joint,angle_deg,state\n";
  for (size_t f = 0; f < motion.frames.size(); ++f)
    for (const BodyJoint& joint : motion.body->joints()) {
      if (joint.angle_index < 0) continue;
      const PersonFrame& frame = motion.frames[f];
      out += beginOfRow(motion, f) + joint.name.substr(0, joint.name.size() - suffix.size()) + ',' +
             numberOrNothing(jointAngle(joint, frame) * kDegrees, 5) + ',' +
             stateText(frame, joint.child_link) + '\n';
    }
  return out;
}

std::string gapsCsvOf(const PersonMotion& motion, const ExportSkeleton& skeleton) {
  std::string out = "joint,from_s,to_s,state\n";
  for (const JointGap& gap : jointGaps(motion, skeleton))
    out += gap.joint + ',' + secondsText(motion, gap.first) + ',' + secondsText(motion, gap.last) +
           ',' + (gap.filled ? "filled" : "not seen") + '\n';
  return out;
}

}  // namespace markerless_mocap
