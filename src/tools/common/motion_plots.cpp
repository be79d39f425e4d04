#include <cmath>
#include <map>

#include "evaluation/body_points.h"
#include "evaluation/foot_contact.h"
#include "exports/motion_description.h"
#include "ros/pose_conversions.h"
#include "tools/common/description_text.h"
#include "tools/common/player.h"
#include "tracking/part_of_joint.h"

namespace markerless_mocap {
namespace {

constexpr double kDegrees = 180 / M_PI;
constexpr size_t kParts = 6;

std::vector<PersonFrame> personFrames(const std::vector<ResultFrame>& frames) {
  std::vector<PersonFrame> out;
  for (const ResultFrame& frame : frames)
    out.push_back({frame.stamp_ns, frame.T_world_link, {}, frame.part_sigma_m});
  return out;
}

void addAngles(const BodyModel& body, const std::vector<PersonFrame>& frames, Page* page) {
  std::map<PartLabel, std::vector<PlotLine>> lines;
  for (const BodyJoint& joint : body.joints()) {
    if (joint.angle_index < 0) continue;
    PlotLine line{withoutId(joint.name), {}};
    for (const PersonFrame& frame : frames)
      line.values.push_back(frame.hasPose() ? kDegrees * jointAngle(joint, frame) : NAN);
    lines[partOfJoint(line.name)].push_back(line);
  }
  page->heading("Joint angles");
  page->text("degrees, by the joints of the URDF");
  for (const auto& [part, some] : lines) {
    page->heading(sidedPartName(part), 3);
    page->timeLines(some, "°");
  }
}

/// Points of the body; a frame without a pose has none.
JointTrack trackOf(const BodyModel& body, const std::vector<ResultFrame>& frames) {
  JointTrack track;
  track.names = bodyPointNames();
  for (const ResultFrame& frame : frames)
    track.add(frame.stamp_ns,
              frame.T_world_link.empty()
                  ? Eigen::Matrix3Xd::Constant(3, Eigen::Index(track.names.size()), NAN)
                  : bodyPoints(body, frame.T_world_link));
  return track;
}

/// From the frame before to the frame after, m/s; NaN where one of them is missing.
std::vector<double> speedsOf(const JointTrack& track, const std::string& point) {
  const int column = track.indexOf(point);
  std::vector<double> speeds(track.frames(), NAN);
  for (size_t f = 1; f + 1 < track.frames(); ++f)
    speeds[f] = (track.positions[f + 1].col(column) - track.positions[f - 1].col(column)).norm() /
                (double(track.stamps_ns[f + 1] - track.stamps_ns[f - 1]) * 1e-9);
  return speeds;
}

void addSpeeds(const JointTrack& track, Page* page) {
  page->heading("Speeds");
  page->text("of the body and of the limbs' ends, over two frames");
  std::vector<PlotLine> lines;
  for (const char* point : {"pelvis", "head", "l_wrist", "r_wrist", "l_ankle", "r_ankle"})
    lines.push_back({point, speedsOf(track, point)});
  page->timeLines(lines, "m/s");
}

void addContacts(const JointTrack& track, Page* page) {
  page->heading("Feet on the floor");
  page->text("A foot stands while its ball is low and slow.");
  std::vector<Band> bands;
  for (const std::string side : {"left", "right"}) {
    bands.push_back({side, {}});
    const FootContact contact = footContact(track, track, side.substr(0, 1) + "_foot");
    for (size_t f = 0; f < track.frames(); ++f) {
      const bool known = track.positions[f].col(track.indexOf(contact.name)).allFinite();
      bands.back().cells.push_back({known ? size_t(contact.estimate[f]) : 2, ""});
    }
  }
  page->bands({{"in the air", "#e4e6e8"}, {"stands", "#2a9d5c"}, {"not known", "#b9bec4"}}, bands);
}

void addExpectedErrors(const std::vector<ResultFrame>& frames, Page* page) {
  std::vector<PlotLine> lines;
  bool any = false;
  for (size_t part = 0; part < kParts; ++part) {
    lines.push_back({sidedPartName(PartLabel(part)), {}});
    for (const ResultFrame& frame : frames) {
      const double error = frame.T_world_link.empty() ? NAN : frame.part_sigma_m[part];
      any = any || std::isfinite(error);
      lines.back().values.push_back(100 * error);
    }
  }
  if (!any) return;
  page->heading("Expected errors");
  page->text("of each part's end (neck, head, wrists, ankles), as the tracker estimates them");
  page->timeLines(lines, "cm");
}

void addDescription(const BodyModel& body, std::vector<PersonFrame> frames, Page* page) {
  const std::shared_ptr<const BodyModel> unowned(&body, [](const BodyModel*) {});
  page->heading("Steps and ranges of motion");
  page->text("± is the expected error; describe_motion writes these figures as JSON");
  for (const DescriptionSection& section :
       descriptionSections(describe(personMotion(unowned, std::move(frames))))) {
    page->heading(section.title, 3);
    std::vector<std::vector<std::string>> rows;
    for (const auto& [name, value] : section.rows) rows.push_back({name, value});
    if (!rows.empty()) page->table({"", "#"}, rows);
  }
}

}  // namespace

void addMotionPlots(const BodyModel& body, const std::vector<ResultFrame>& frames, Page* page) {
  const std::vector<PersonFrame> person = personFrames(frames);
  if (std::none_of(person.begin(), person.end(), [](const auto& f) { return f.hasPose(); })) return;
  const JointTrack track = trackOf(body, frames);
  addSpeeds(track, page);
  addContacts(track, page);
  addExpectedErrors(frames, page);
  addAngles(body, person, page);
  addDescription(body, person, page);
}

}  // namespace markerless_mocap
