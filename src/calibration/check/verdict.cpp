#include <algorithm>
#include <cmath>
#include <cstdio>

#include "calibration/check/findings.h"
#include "numerics/order_statistics.h"

namespace markerless_mocap {
namespace {

template <class... Args>
std::string text(const char* format, Args... args) {
  char buffer[400];
  std::snprintf(buffer, sizeof buffer, format, args...);
  return buffer;
}

std::string clockTime(double seconds) {
  const int whole = int(std::floor(seconds));
  if (whole < 60) return text("%.1f s", seconds);
  return text("%d:%02d", whole / 60, whole % 60);
}

std::string looseSentence(const CalibratedCamera& camera) {
  const char* name = camera.calibration.name.c_str();
  const std::string when = clockTime(camera.loose->time);
  const double pixels = camera.loose->pixels;
  if (camera.loose->later_part)
    return text(
        "%s is loose: its views disagree from %s on, by %.1f pixels. Those were left out; "
        "its place is the one before. Fasten it and calibrate again.",
        name, when.c_str(), pixels);
  return text(
      "%s is loose: its views before %s disagree with the later ones, by %.1f pixels. Those "
      "were left out; its place is the later one. Fasten it and calibrate again.",
      name, when.c_str(), pixels);
}

class Verdict {
 public:
  Verdict(const CalibrationInput& input, RigCalibration* result)
      : input_(input), result_(*result) {}

  void write() {
    for (const CalibratedCamera& camera : result_.cameras) judge(camera);
    judgeRig();
    const char* summary =
        result_.good ? "The calibration is good: %zu cameras, corners are met to %.2f pixels."
                     : "Look at this calibration before you use it: %zu cameras, corners "
                       "are met to %.2f pixels.";
    result_.verdict.insert(result_.verdict.begin(),
                           text(summary, result_.cameras.size(), result_.rms));
  }

 private:
  void doubt(const std::string& sentence) {
    result_.good = false;
    result_.verdict.push_back(sentence);
  }

  void judge(const CalibratedCamera& camera) {
    if (camera.loose) doubt(looseSentence(camera));
    judgeResiduals(camera);
    judgeCertainty(camera);
  }

  void judgeResiduals(const CalibratedCamera& camera) {
    std::vector<double> all;
    for (const CalibratedCamera& other : result_.cameras) all.push_back(other.rms);
    const char* name = camera.calibration.name.c_str();
    if (camera.rms > std::max(1.0, 2.5 * medianOf(all)))
      doubt(
          text("%s meets corners only to %.1f pixels, most cameras to %.1f: is it out of focus, "
               "badly timed, or does its lens need another model?",
               name, camera.rms, medianOf(all)));
    else if (camera.rms > 2.0)
      doubt(
          text("%s meets corners only to %.1f pixels: is the board flat and its size right, and "
               "do the cameras show the same instants?",
               name, camera.rms));
  }

  void judgeCertainty(const CalibratedCamera& camera) {
    constexpr double kFar = 0.01, kTurned = 0.2 * M_PI / 180;
    const char* const kMorePoints = "name more points in its image, far apart, near and far";
    const char* name = camera.calibration.name.c_str();
    const double far = camera.position_sigma.norm(), turned = camera.direction_sigma.norm();
    if (input_.locate && far > kFar)
      doubt(text("The place of %s is known only to %.0f mm: %s.", name, 1e3 * far,
                 input_.points.empty()
                     ? "show it the board more often together with other cameras, "
                       "near and far, tilted"
                     : kMorePoints));
    else if (input_.locate && turned > kTurned)
      doubt(text("The direction of %s is known only to %.2f degrees: %s.", name,
                 turned * 180 / M_PI,
                 input_.points.empty() ? "show it the board more often" : kMorePoints));
    const double focal = camera.focal_sigma.maxCoeff() / camera.calibration.K(0, 0);
    if (focal > 0.01)
      doubt(
          text("The focal length of %s is known only to %.1f %%: show it the board tilted, nearer "
               "and farther.",
               name, 100 * focal));
    if (camera.coverage < 0.25 && focal > 0)
      result_.verdict.push_back(
          text("%s saw the board in %.0f %% of its image only: its lens is a guess outside.", name,
               100 * camera.coverage));
  }

  /// Offsets against the middle one of all cameras.
  void judgeClocks() {
    constexpr double kLeast = 0.005;
    if (!result_.clocks_corrected) return;
    const double middle = middleOffset(result_);
    for (const CalibratedCamera& camera : result_.cameras)
      if (const double late = middle - camera.time_offset; std::abs(late) > kLeast)
        doubt(text(
            "The stamps of %s are %.0f ms %s than the middle one of all cameras, by the "
            "motion of the board. %s",
            camera.calibration.name.c_str(), 1e3 * std::abs(late), late > 0 ? "later" : "earlier",
            input_.clocks_last ? "The rig file corrects it (time_offset)."
                               : "That was corrected here; correct it in recordings, too."));
  }

  /// Films that were started by hand: when each began, and whether that is certain.
  void judgeFilms() {
    if (!result_.clocks) return;
    const auto first = std::min_element(
        result_.cameras.begin(), result_.cameras.end(),
        [](const auto& a, const auto& b) { return a.time_offset < b.time_offset; });
    for (size_t i = 0; i < result_.cameras.size(); ++i) {
      const CalibratedCamera& camera = result_.cameras[i];
      if (&camera != &*first)
        result_.verdict.push_back(
            text("The film of %s began %.3f s after that of %s.", camera.calibration.name.c_str(),
                 camera.time_offset - first->time_offset, first->calibration.name.c_str()));
      if (const double certainty = result_.clocks->certainty[i]; certainty < kCertainOffset)
        doubt(
            text("When the film of %s began is not certain: what speaks for it is %.1f times "
                 "what speaks for another time, %.1f is wanted. Give a table of times, or film "
                 "again: move the board in no rhythm, where two cameras see it.",
                 camera.calibration.name.c_str(), certainty, kCertainOffset));
    }
  }

  void judgeWalk(const WalkFloor& walk) {
    constexpr double kTilted = 1.0 * M_PI / 180, kShortest = 0.9, kTallest = 2.2;
    result_.verdict.push_back(
        text("The floor is where the person trod: %d soles within %.1f m, %.0f mm from one plane; "
             "up is known to %.1f degrees.",
             walk.steps, walk.extent, 1e3 * walk.scatter, walk.tilt_sigma * 180 / M_PI));
    if (walk.tilt_sigma > kTilted)
      doubt(
          "Up is not known well: the person should walk through more of the room, not on a line.");
    if (walk.stature < kShortest || walk.stature > kTallest)
      doubt(text("The person would be %.2f m tall: is the size of the board's squares right?",
                 walk.stature));
    else
      result_.verdict.push_back(
          text("The person is about %.2f m tall; if that is wrong by more than a few centimetres, "
               "so is the size of the board's squares.",
               walk.stature));
  }

  void judgeRig() {
    judgeClocks();
    judgeFilms();
    if (!input_.locate) return;
    if (!result_.floor_known)
      result_.verdict.push_back(
          "Nothing tells where the floor is: up is the cameras' mean upward direction and z = 0 "
          "the lowest place of the board. Lay the board on the floor and name that picture "
          "(--floor), or film a person who walks (--walk).");
    if (result_.walk) judgeWalk(*result_.walk);
    if (result_.points_rms > 5.0)
      doubt(text("The known points are met only to %.1f pixels: are their places and pixels right?",
                 result_.points_rms));
    else if (!input_.points.empty())
      result_.verdict.push_back(
          text("The known points are met to %.1f pixels.", result_.points_rms));
    if (result_.turned_guessed)
      doubt(
          "The board looks the same turned by half a turn and was seen in one place only, and the "
          "floor around it does not tell how it lies, so that each camera may stand on the other "
          "side of it: move the board, or use one with an even "
          "number of squares on one side and an odd number on the other.");
  }

  const CalibrationInput& input_;
  RigCalibration& result_;
};

}  // namespace

void writeVerdict(const CalibrationInput& input, RigCalibration* result) {
  Verdict(input, result).write();
}

}  // namespace markerless_mocap
