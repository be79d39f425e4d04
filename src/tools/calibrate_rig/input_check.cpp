#include "tools/calibrate_rig/input_check.h"

#include <cmath>
#include <cstdlib>
#include <stdexcept>

#include "files/output_folder.h"
#include "markerless_mocap/camera/rig_file.h"
#include "markerless_mocap/formats/calibration_files.h"
#include "text/joined.h"
#include "tools/calibrate_rig/find_boards.h"
#include "tools/common/film_times.h"

namespace markerless_mocap {
namespace {

/// What the films tell before they are opened: their names.
std::vector<CameraToCalibrate> namedCameras(const CheckedArguments& a) {
  std::vector<CameraToCalibrate> cameras;
  if (a.live)
    for (const std::string& name : a.inputs) cameras.push_back({name, 0, 0, {}});
  else
    for (const FilmSource& film : a.board_films) cameras.push_back({film.camera, 0, 0, {}});
  return cameras;
}

/// The calibrations of the cameras in a file or folder, as readLenses() and matchNames(), in the
/// order of the cameras.
std::vector<CameraCalibration> lensesOf(const std::string& path,
                                        const std::vector<CameraToCalibrate>& cameras) {
  const std::vector<CameraCalibration> known = readLenses({path}).cameras;
  std::vector<std::string> names, wanted;
  for (const CameraCalibration& camera : known) names.push_back(camera.name);
  for (const CameraToCalibrate& camera : cameras) wanted.push_back(camera.name);
  return camerasNamed(matchNames(wanted, names, "camera of " + path), known, path);
}

void checkChoices(const CalibrateRigArguments& a) {
  if (int(!a.floor.empty()) + int(!a.points.empty()) + int(!a.walk.empty()) > 1)
    throw std::invalid_argument(
        "--floor, --points and --walk all say where the world is: choose one");
  if (a.separate && !a.lens_only && a.points.empty())
    throw std::invalid_argument(
        "with --separate no two cameras see the board at one time, so it cannot tell their places: "
        "give --points (docs/calibration.md), or --lens-only for the lenses alone");
  if (!std::isfinite(a.floor_thickness))
    throw std::invalid_argument("--floor-thickness is not finite, allowed are metres");
}

}  // namespace

FloorPlace floorPlaceIn(const std::string& text) {
  const size_t colon = text.rfind(':');
  FloorPlace place{text.substr(0, colon), std::nullopt};
  if (colon == std::string::npos) return place;
  char* end = nullptr;
  const std::string seconds = text.substr(colon + 1);
  place.time = std::strtod(seconds.c_str(), &end);
  if (seconds.empty() || *end != 0 || !std::isfinite(*place.time))
    throw std::invalid_argument("--floor " + text + ": after the colon comes a time in seconds");
  return place;
}

size_t cameraNamed(const std::string& name, const std::vector<CameraToCalibrate>& cameras,
                   const std::string& option) {
  std::string known;
  for (size_t i = 0; i < cameras.size(); ++i) {
    if (cameras[i].name == name) return i;
    addWord(&known, cameras[i].name);
  }
  throw std::invalid_argument(option + " names the camera " + name + ", there are " + known);
}

CheckedArguments checked(const CalibrateRigArguments& arguments) {
  CheckedArguments a(arguments);
  checkChoices(a);
  checkOutputFolder(a.output);
  if (a.lens != "auto") lensModelNamed(a.lens);
  if (!a.live) a.board_films = findFilms(a.inputs, a.video);
  const std::vector<CameraToCalibrate> cameras = namedCameras(a);
  if (!a.floor.empty()) cameraNamed(floorPlaceIn(a.floor).camera, cameras, "--floor");
  if (!a.points.empty()) readKnownPoints(a.points, cameras);
  if (!a.walk.empty()) a.walk_films = findFilms(a.walk, a.video);
  if (!a.lens_pictures.empty()) a.lens_films = findFilms(a.lens_pictures, "");
  if (!a.lenses.empty()) a.known_lenses = lensesOf(a.lenses, cameras);
  return a;
}

}  // namespace markerless_mocap
