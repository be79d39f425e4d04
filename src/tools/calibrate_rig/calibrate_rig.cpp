#include "tools/calibrate_rig/calibrate_rig.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <set>
#include <stdexcept>

#include "calibration/board_hints.h"
#include "markerless_mocap/camera/rig_file.h"
#include "tools/calibrate_rig/calibration_files.h"
#include "tools/calibrate_rig/find_boards.h"
#include "tools/calibrate_rig/input_check.h"
#include "tools/calibrate_rig/live_boards.h"
#include "tools/calibrate_rig/still_board.h"
#include "tools/calibrate_rig/walk_silhouettes.h"
#include "tools/common/progress.h"
#include "tools/common/run_tool.h"

namespace markerless_mocap {
namespace {

constexpr int kGlance = 5;  // images that show whether the board lies still

FrameTimes timesOf(const CheckedArguments& a) {
  if (a.times.empty()) return {};
  std::vector<std::string> names;
  for (const FilmSource& film : a.board_films) names.push_back(film.camera);
  return readFrameTimes(a.times, names);
}

void addPicturesOfLenses(const CheckedArguments& a, const BoardDetector& detector,
                         FoundBoards* boards) {
  if (a.lens_pictures.empty()) return;
  addLensPictures(findBoards(detector, a.lens_films, a.most_images, {}, {}), boards);
}

/// The places of the cameras come from images of the board that all may see at one time.
bool isSeenTogether(const CheckedArguments& a) {
  return !a.live && !a.separate && !a.lens_only && a.lens_pictures.empty() && a.points.empty();
}

FoundBoards searchAll(const CheckedArguments& a, const Board& board, std::ostream* notes,
                      bool terminal) {
  const BoardDetector detector(board);
  Progress progress("boards", notes, terminal);
  const auto search = [&](int most_images) {
    return findBoards(detector, a.board_films, most_images, timesOf(a),
                      [&](double part) { progress.update(part); });
  };
  FoundBoards boards = isSeenTogether(a) && !a.lenses.empty() ? search(kGlance) : FoundBoards();
  if (!liesStill(board, boards)) boards = search(a.most_images);
  if (boards.views.empty()) boards = search(kGlance);  // few images are looked at longer
  addPicturesOfLenses(a, detector, &boards);
  progress.finish();
  return boards;
}

/// Images of equal times in place of evenly spread ones, which show the lenses from then on.
void searchTogether(const CheckedArguments& a, const Board& board, const FoundBoards& found,
                    CalibrationInput* input, std::ostream* notes, bool terminal) {
  std::vector<double> offsets(found.cameras.size(), 0.0);
  if (input->clocks) offsets = input->clocks->offsets;
  if (!std::all_of(offsets.begin(), offsets.end(), [](double o) { return std::isfinite(o); }))
    return;  // which the calibration says
  Progress progress("boards at equal times", notes, terminal);
  FoundBoards together = findBoardsIn(BoardDetector(board), a.board_films,
                                      imagesTogether(found, offsets, a.most_images), timesOf(a),
                                      [&](double p) { progress.update(p); });
  progress.finish();
  for (BoardView& view : input->views) view.alone = true;
  input->views.insert(input->views.end(), together.views.begin(), together.views.end());
}

/// The board is in no film: what is there in its place?
[[noreturn]] void refuseFilms(const CheckedArguments& a, const Board& board) {
  constexpr int kImages = 8;  // per film
  std::string hint;
  for (const FilmSource& film : a.board_films)
    if (hint.empty()) hint = otherBoardIn(board, imagesOf(film, kImages));
  throw std::invalid_argument(
      "the board was found in no picture of any camera" +
      (hint.empty() ? ": is it described rightly (squares are counted, not inner corners)?"
                    : "; " + hint));
}

/// The first view of the camera, or the time that is named.
FloorView floorView(const CheckedArguments& a, const FoundBoards& boards) {
  const FloorPlace place = floorPlaceIn(a.floor);
  FloorView floor;
  floor.camera = cameraNamed(place.camera, boards.cameras, "--floor");
  floor.thickness = a.floor_thickness;
  floor.time = INFINITY;
  for (const BoardView& view : boards.views)
    if (view.camera == floor.camera && !view.alone) floor.time = std::min(floor.time, view.time);
  if (place.time) floor.time = *place.time;
  return floor;
}

void useLenses(const CheckedArguments& a, std::vector<CameraToCalibrate>* cameras) {
  for (size_t i = 0; i < cameras->size(); ++i) {
    CameraToCalibrate& camera = (*cameras)[i];
    CameraCalibration given = a.known_lenses[i];
    if (given.width == 0) {
      given.width = camera.width;
      given.height = camera.height;
    }
    if (given.width != camera.width || given.height != camera.height)
      throw std::invalid_argument(
          a.lenses + ": " + camera.name + " is " + std::to_string(given.width) + " x " +
          std::to_string(given.height) + " pixels, its film " + std::to_string(camera.width) +
          " x " + std::to_string(camera.height));
    camera.given = given;
  }
}

/// Not pictures, between which the board may have gone anywhere.
bool areFilms(const CheckedArguments& a) {
  if (a.live) return true;
  for (const FilmSource& film : a.board_films)
    if (std::filesystem::is_directory(film.path)) return false;
  return true;
}

/// Stamps of a bag or a table are made alike in later recordings; the beginning of a video is not.
bool haveStamps(const CheckedArguments& a) {
  if (a.live || !a.times.empty()) return true;
  return std::all_of(a.board_films.begin(), a.board_films.end(),
                     [](const FilmSource& film) { return !film.topic.empty(); });
}

/// Clocks that tell times are believed, and checked later; single pictures have none.
FilmStart startOf(const CheckedArguments& a) {
  if (a.lens_only || a.separate) return FilmStart::kTogether;
  const bool known = !areFilms(a) || haveStamps(a);
  return a.start == FilmStart::kUnknown && known ? FilmStart::kTogether : a.start;
}

/// Whether the person walks in the films of the board.
bool isWalkOfBoard(const CheckedArguments& a) {
  if (a.live) return false;
  std::set<std::string> boards;
  for (const FilmSource& film : a.board_films) boards.insert(film.path);
  return std::all_of(a.walk_films.begin(), a.walk_films.end(),
                     [&](const FilmSource& film) { return boards.count(film.path) > 0; });
}

CalibrationInput inputOf(const CheckedArguments& a, const FoundBoards& boards) {
  CalibrationInput input;
  input.board = a.board;
  input.cameras = boards.cameras;
  input.views = boards.views;
  for (BoardView& view : input.views) view.alone |= a.separate || a.lens_only;
  if (!a.lenses.empty()) useLenses(a, &input.cameras);
  if (!a.points.empty()) input.points = readKnownPoints(a.points, boards.cameras);
  if (!a.floor.empty()) input.floor = floorView(a, boards);
  if (!a.walk.empty())
    input.walk = [&a, cameras = boards.cameras](const std::vector<double>& offsets) {
      return walkSilhouettes(a.walk_films, cameras, offsets, isWalkOfBoard(a));
    };
  if (a.lens != "auto") input.lens = lensModelNamed(a.lens);
  input.largest_offset = a.largest_offset;
  input.locate = !a.lens_only;
  input.check_clocks = areFilms(a);
  input.clocks_last = haveStamps(a);
  return input;
}

/// Live, the board lies on the floor at the end.
FoundBoards watchCameras(CheckedArguments* a, const Board& board, std::ostream* notes) {
  LiveWatch watch;
  watch.cameras = a->inputs;
  watch.interrupted = a->interrupted;
  std::vector<CameraToCalibrate> named;
  for (const std::string& name : a->inputs) named.push_back({name, 0, 0, {}});
  if (!a->floor.empty()) watch.floor = cameraNamed(a->floor, named, "--floor");
  const BoardDetector detector(board);
  const LiveBoards live = watchBoards(detector, watch, notes);
  if (!live.floor_time) {
    a->floor.clear();
  } else {
    char time[40];
    std::snprintf(time, sizeof time, ":%.6f", *live.floor_time);
    a->floor += time;
  }
  return live.boards;
}

void sayWhatWasFound(const FoundBoards& boards, std::ostream& out) {
  std::vector<int> views(boards.cameras.size(), 0);
  for (const BoardView& view : boards.views) ++views[view.camera];
  for (size_t i = 0; i < views.size(); ++i)
    out << boards.cameras[i].name << ": board found in " << views[i] << " pictures, "
        << boards.images[i] << " images searched\n";
}

}  // namespace

RigCalibration calibrateFilms(const CalibrateRigArguments& given, std::ostream* notes,
                              bool terminal) {
  CheckedArguments arguments = checked(given);
  const Board board(arguments.board);
  const FoundBoards boards = arguments.live ? watchCameras(&arguments, board, notes)
                                            : searchAll(arguments, board, notes, terminal);
  if (notes) sayWhatWasFound(boards, *notes);
  if (boards.views.empty() && !arguments.live) refuseFilms(arguments, board);
  CalibrationInput input = inputOf(arguments, boards);
  std::string remark;
  const bool still =
      isSeenTogether(arguments) && useStillBoard(arguments.board_films, &input, &remark);
  if (!still) remark = findStarts(startOf(arguments), &input);
  if (!still && areSparse(boards) &&
      (input.clocks || (areFilms(arguments) && !haveOneRate(boards))))
    searchTogether(arguments, board, boards, &input, notes, terminal);
  Progress progress("adjustment", notes, terminal);
  RigCalibration result = calibrateRig(input, [&](double part) { progress.update(part); });
  progress.finish();
  if (!remark.empty()) result.verdict.insert(result.verdict.begin() + 1, remark);
  if (arguments.lens_only)
    writeLenses(arguments.output, result);
  else
    writeCalibration(arguments.output, result, arguments.world_frame);
  return result;
}

void print(const RigCalibration& result, std::ostream& out) {
  char line[300];
  std::snprintf(line, sizeof line, "%-12s %6s %9s %9s %16s %10s %12s %16s  %s\n", "camera", "views",
                "covered", "residual", "focal", "place", "direction", "time offset", "lens");
  out << line;
  const double middle = middleOffset(result);
  for (const CalibratedCamera& c : result.cameras) {
    std::snprintf(line, sizeof line,
                  "%-12s %6zu %7.0f %% %6.2f px %8.1f +- %.1f px %4.1f mm %8.3f deg %8.1f +- %.1f "
                  "ms  %s\n",
                  c.calibration.name.c_str(), c.views.size(), 100 * c.coverage, c.rms,
                  c.calibration.K(0, 0), c.focal_sigma.x(), 1e3 * c.position_sigma.norm(),
                  c.direction_sigma.norm() * 180 / M_PI, 1e3 * (c.time_offset - middle),
                  1e3 * c.time_sigma, nameOf(c.lens).c_str());
    out << line;
  }
  for (const std::string& sentence : result.verdict) out << sentence << '\n';
}

std::string nextStep(const CalibrateRigArguments& arguments) {
  const std::string& out = arguments.output;
  if (arguments.lens_only) return "written: " + out + "/camera_info, " + out + "/report.html";
  return "written: " + out + "/rig.yaml; how good it is: " + out +
         "/report.html\nnext, films of a person: " + callOf("import_recording") +
         " films person.bag FILMS --calibration " + out +
         "/rig.yaml\na bag of one: " + callOf("mocap_offline") + " person.bag result.bag --rig " +
         out + "/rig.yaml";
}

}  // namespace markerless_mocap
