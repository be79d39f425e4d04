#include <std_msgs/Empty.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <opencv2/imgproc.hpp>
#include <optional>
#include <sstream>
#include <stdexcept>

#include "markerless_mocap/formats/calibration_files.h"
#include "markerless_mocap/products/silhouette_mask.h"
#include "ros/camera_conversions.h"
#include "tools/common/camera_bag_writer.h"
#include "tools/common/film_times.h"
#include "tools/common/progress.h"
#include "tools/import/film.h"
#include "tools/import/film_calibration.h"
#include "tools/import/film_join.h"
#include "tools/import/import_recording.h"
#include "tools/import/person_starts.h"

namespace markerless_mocap {
namespace {

constexpr double kImagesFps = 25.0;

std::vector<std::string> namesOf(const std::vector<CameraCalibration>& cameras) {
  std::vector<std::string> names;
  for (const CameraCalibration& camera : cameras) names.push_back(camera.name);
  return names;
}

std::vector<std::string> namesOf(const std::vector<NamedFilm>& films) {
  std::vector<std::string> names;
  for (const NamedFilm& film : films) names.push_back(film.name);
  return names;
}

template <class T>
const T& named(const std::vector<T>& things, const std::string& name) {
  return *std::find_if(things.begin(), things.end(),
                       [&](const T& thing) { return thing.name == name; });
}

/// The calibration in metres with z up.
CalibrationSet calibrationIn(const FilmsInput& input, const ImportOptions& options,
                             std::vector<std::string>* notes) {
  CalibrationSet set = readCalibration(input.calibration);
  const WorldGuess guess = guessWorld(set);
  WorldTransform world = options.world;
  if (input.guess_unit) world.scale_to_metres = guess.world.scale_to_metres;
  if (input.guess_up) world.up = guess.world.up;
  for (CameraCalibration& camera : set.cameras) camera = world.apply(camera);
  std::ostringstream said;
  said << "the calibration is " << titleOf(set.format) << ", its unit " << world.scale_to_metres
       << " m (" << (input.guess_unit ? guess.unit_reason : "as given") << "), up is " << world.up
       << " (" << (input.guess_up ? guess.up_reason : "as given") << ")";
  notes->push_back(said.str());
  notes->insert(notes->end(), set.remarks.begin(), set.remarks.end());
  return set;
}

/// Films with their cameras, in one order.
struct Cast {
  std::vector<CameraCalibration> cameras;
  std::vector<Film> films;
  std::vector<Film> empty_room;  ///< or none
  std::vector<double> offsets;   ///< s
};

void setTimes(const std::string& table, const std::vector<NamedFilm>& films, Cast* cast,
              std::vector<std::string>* notes) {
  if (table.empty()) return;
  const FrameTimes times = readFrameTimes(table, namesOf(films));
  for (size_t i = 0; i < films.size(); ++i) {
    Film& film = cast->films[i];
    const std::vector<double>& of_film = times.at(films[i].name);
    if (film.frames() > int(of_film.size()))
      notes->push_back(films[i].name + " has " + std::to_string(film.frames()) + " frames, " +
                       table + " has times of the first " + std::to_string(of_film.size()) +
                       ": the others are left out");
    film.setTimes(of_film);
  }
}

void addMasks(const FilmsInput& input, const std::vector<NamedFilm>& films, Cast* cast) {
  const std::vector<NamedFilm> masks = filmsIn({input.masks});
  const auto matched = matchNames(namesOf(films), namesOf(masks), "film of masks");
  for (size_t i = 0; i < films.size(); ++i) cast->films[i].addMasks(named(masks, matched[i]).path);
}

void addEmptyRoom(const FilmsInput& input, const std::vector<NamedFilm>& films, double fps,
                  Cast* cast) {
  if (input.background.empty()) return;
  const std::vector<NamedFilm> rooms = filmsIn(input.background);
  const auto matched = matchNames(namesOf(films), namesOf(rooms), "film of the empty room");
  for (size_t i = 0; i < films.size(); ++i) {
    Film room(named(rooms, matched[i]).path, fps);
    const Film& film = cast->films[i];
    if (!film.turns()) room.doNotTurn();
    if (room.size() != film.size())
      throw std::invalid_argument("the film of the empty room " + room.path() + " is " +
                                  text(room.size()) + " pixels, " + film.path() + " is " +
                                  text(film.size()));
    cast->empty_room.push_back(std::move(room));
  }
}

/// Folders of other pictures may lie beside the films. They are left out if every camera has a film
/// without them.
std::vector<NamedFilm> filmsOfCameras(const std::vector<std::string>& inputs,
                                      const std::vector<std::string>& cameras,
                                      std::vector<std::string>* notes) {
  std::vector<NamedFilm> films, others;
  for (const NamedFilm& film : filmsIn(inputs))
    (isCalledLikeOne(film.name, cameras) ? films : others).push_back(film);
  if (films.size() < cameras.size()) return filmsIn(inputs);
  for (const NamedFilm& other : others)
    notes->push_back(other.path + " belongs to no camera of the calibration and is left out");
  return films;
}

Cast castOf(const FilmsInput& input, const ImportOptions& options, ImportResult* result) {
  const double fps = options.fps > 0.0 ? options.fps : kImagesFps;
  const CalibrationSet set = calibrationIn(input, options, &result->warnings);
  const std::vector<NamedFilm> films =
      filmsOfCameras(input.films, namesOf(set.cameras), &result->warnings);
  const auto cameras =
      matchNames(namesOf(films), namesOf(set.cameras), "camera of the calibration");
  Cast cast;
  for (size_t i = 0; i < films.size(); ++i) {
    cast.films.emplace_back(films[i].path, fps);
    cast.cameras.push_back(named(set.cameras, cameras[i]));
    agreeInSize(&cast.cameras.back(), &cast.films.back(), &result->warnings);
    cast.offsets.push_back(cast.cameras.back().time_offset);
    cast.cameras.back().time_offset = 0.0;  // it is in the stamps
  }
  if (!input.masks.empty()) addMasks(input, films, &cast);
  addEmptyRoom(input, films, fps, &cast);
  setTimes(input.times, films, &cast, &result->warnings);
  return cast;
}

/// As calibrate_rig does with films of the board.
FilmsInput withTimesBeside(const FilmsInput& input, ImportResult* result) {
  FilmsInput out = input;
  if (!input.times.empty() || input.start == FilmStart::kApart) return out;
  out.times = fileBesideFilms(input.films, {kTimesBesideFilms});
  if (!out.times.empty())
    result->warnings.push_back("the times are those of " + out.times +
                               ", which lies beside the films");
  return out;
}

/// Offsets of a rig file are believed unless the films are said to have begun apart.
bool areStartsKnown(const FilmsInput& input, const Cast& cast) {
  if (!input.times.empty() || input.start == FilmStart::kTogether) return true;
  return input.start == FilmStart::kUnknown &&
         std::any_of(cast.offsets.begin(), cast.offsets.end(), [](double o) { return o != 0.0; });
}

std::string noteOf(const std::string& camera, const JoinStatistics& counts) {
  std::ostringstream out;
  out << std::fixed << std::setprecision(1) << camera << ": " << counts.used << " frames used, "
      << 1e3 * counts.sum / std::max(counts.used, 1) << " ms from their frame sets on average, "
      << 1e3 * counts.largest << " ms at most";
  if (counts.left_out > 0) out << "; " << counts.left_out << " left out";
  if (counts.missing > 0) out << "; missing in " << counts.missing << " frame sets";
  return out.str();
}

cv::Mat maskFrom(const cv::Mat& image) {
  if (image.empty()) return {};
  cv::Mat grey;
  cv::cvtColor(image, grey, cv::COLOR_BGR2GRAY);
  return maskOfThreeValues(grey);
}

/// How much later than its frame set each camera exposes, ns; 0 where it is missing.
std::vector<int64_t> laterThan(const FilmJoin::Joined& joined) {
  std::vector<int64_t> later;
  for (const FilmFrame& frame : joined.frames)
    later.push_back(frame.image.empty() ? 0 : std::llround(1e9 * (frame.time - joined.time)));
  return later;
}

/// The images that the background is learned from come first, at the cameras' own times as well.
/// Returns the number of frame sets.
int writeEmptyRoom(std::vector<Film>* films, int most, const std::vector<int64_t>& later,
                   const ImportOptions& options, double fps, CameraBagWriter* bag) {
  for (int k = 0; k < most; ++k) {
    std::vector<cv::Mat> images;
    for (Film& film : *films)
      if (const auto frame = film.next()) images.push_back(frame->image);
    if (images.empty() || images.size() < films->size()) return k;
    for (size_t i = 0; i < images.size(); ++i)
      bag->write(options.stampOf(k, fps) + later[i], i, images[i], cv::Mat());
  }
  return most;
}

/// Returns the number of frame sets. \param joined the first one
int writeFilms(std::optional<FilmJoin::Joined> joined, FilmJoin* films, int64_t start,
               CameraBagWriter* bag, Progress* progress) {
  int frame_sets = 0;
  const double first = joined->time;
  for (; joined; joined = films->next()) {
    const int64_t stamp = start + std::llround(1e9 * (joined->time - first));
    const std::vector<int64_t> later = laterThan(*joined);
    for (size_t i = 0; i < joined->frames.size(); ++i)
      if (const FilmFrame& frame = joined->frames[i]; !frame.image.empty())
        bag->write(stamp + later[i], i, frame.image, maskFrom(frame.mask));
    progress->update(double(++frame_sets) / std::max(films->expectedFrameSets(), 1));
  }
  return frame_sets;
}

void findStarts(const FilmsInput& input, Cast* cast, ImportResult* result, std::ostream* notes,
                bool terminal) {
  if (areStartsKnown(input, *cast)) return;
  Progress search("beginning of the films", notes, terminal);
  const auto found = findPersonStarts(cast->films, cast->cameras, input, &cast->offsets,
                                      [&](double part) { search.update(part); });
  search.finish();
  result->warnings.insert(result->warnings.end(), found.begin(), found.end());
}

}  // namespace

ImportResult importFilms(const FilmsInput& given, const ImportOptions& options, std::ostream* notes,
                         bool terminal) {
  options.validate();
  ImportResult result;
  const FilmsInput input = withTimesBeside(given, &result);
  Cast cast = castOf(input, options, &result);
  findStarts(input, &cast, &result, notes, terminal);
  result.cameras = cast.cameras;
  FilmJoin films(std::move(cast.films), cast.offsets, options.fps);
  result.fps = films.fps();
  const auto warnings = calibrationWarnings(result.cameras);
  result.warnings.insert(result.warnings.end(), warnings.begin(), warnings.end());

  CameraBagWriter bag(options.output, result.cameras, options.jpeg_quality);
  Progress progress("import_recording", notes, terminal);
  std::optional<FilmJoin::Joined> first = films.next();
  if (!first) throw std::runtime_error("the films have no time in common, or no frames");
  bag.writeTransforms(options.stampOf(0, result.fps));
  bag.bag().writeLatched(kStampsOfCapture, rosTime(options.stampOf(0, result.fps)),
                         std_msgs::Empty());
  const int empty = writeEmptyRoom(&cast.empty_room, input.background_frames, laterThan(*first),
                                   options, result.fps, &bag);
  if (!cast.empty_room.empty())
    result.warnings.push_back("the first " + std::to_string(empty) +
                              " frame sets are of the empty room");
  result.frame_sets = empty + writeFilms(std::move(first), &films,
                                         options.stampOf(empty, result.fps), &bag, &progress);
  progress.finish();
  for (size_t i = 0; i < result.cameras.size(); ++i)
    result.warnings.push_back(noteOf(result.cameras[i].name, films.statistics()[i]));
  bag.commit();
  return result;
}

}  // namespace markerless_mocap
