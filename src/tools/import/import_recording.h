#pragma once

#include <cstdint>
#include <ostream>
#include <string>
#include <vector>

#include "camera/film_clocks.h"
#include "markerless_mocap/camera/camera.h"
#include "markerless_mocap/formats/world_transform.h"

namespace markerless_mocap {

/// Options of all kinds of import.
struct ImportOptions {
  std::string output;   ///< bag to write
  std::string rig_out;  ///< rig file to write, or empty
  WorldTransform world;
  double fps = 0.0;  ///< frame sets per second; 0: the rate of the (slowest) video, 25 for images
  double start_stamp = 1.0;  ///< seconds
  int jpeg_quality = 0;      ///< 1 to 100; 0: raw images

  /// Throws std::invalid_argument; the message names option, value and allowed values.
  void validate() const;
  /// Stamp of a frame set, nanoseconds.
  int64_t stampOf(int frame_set, double frame_sets_per_second) const;
};

/// Images or masks of numbered cameras, with a calibration file each; see filesByCamera() for
/// the patterns. The k-th file of each camera, sorted by name, belongs to the k-th frame set.
struct MatricesInput {
  std::string matrices;  ///< pattern; it determines the cameras
  std::string images;    ///< pattern, or empty
  std::string masks;     ///< pattern, or empty; black = background
};

/// One folder per camera with a video and a calibration file.
struct VideosInput {
  std::string folder;               ///< contains one folder per camera, named like the camera
  std::string video = "video.avi";  ///< in each folder
  std::string background;           ///< video of the empty scene, used before `video`; or empty
  std::string calibration = "config.xml";  ///< see readCameraCalibration()
  /// Rig file in metres with z up, which replaces the calibration files; or empty.
  std::string rig;
  int background_frames = 30;  ///< number of frames from the background video
};

/// A video or a folder of images for each camera, and one calibration. They belong together by name
/// or by the number in it.
struct FilmsInput {
  std::vector<std::string> films;        ///< see filmsIn()
  std::vector<std::string> calibration;  ///< see readCalibration()
  std::string masks;                     ///< folder of films, black = background; or empty
  std::vector<std::string> background;   ///< films of the empty room, as `films`; or none
  int background_frames = 30;            ///< of these, that come before the others
  /// Table, see readFrameTimes(). Empty: kTimesBesideFilms in a folder of films unless the films
  /// began apart, or else the containers' times.
  std::string times;
  bool guess_unit = true;  ///< as guessWorld(), in place of ImportOptions::world
  bool guess_up = true;
  /// Films without such a table: unless they began together, or the rig file has time offsets, when
  /// they began is searched by the motion of the person.
  FilmStart start = FilmStart::kUnknown;
  double largest_offset = kLargestFilmOffset;  ///< s, between two films, that is searched for
};

/// Summary of an import.
struct ImportResult {
  std::vector<CameraCalibration> cameras;  ///< in metres, z up
  int frame_sets = 0;
  double fps = 0.0;
  std::vector<std::string> warnings;  ///< warnings about units and axes, omitted frames
};

/// These functions write a bag with the topics of CameraBagWriter. It appears only if the import
/// succeeds. They throw std::runtime_error or std::invalid_argument if files are missing or
/// unreadable, or differ in number or size between cameras.
/// \param notes stream for the progress; nullptr: none
/// \param terminal true if `notes` is a terminal
ImportResult importMatrices(const MatricesInput& input, const ImportOptions& options,
                            std::ostream* notes, bool terminal);
ImportResult importVideos(const VideosInput& input, const ImportOptions& options,
                          std::ostream* notes, bool terminal);
/// Films of any rates and containers; the frame sets are at the times of the slowest film, see
/// FilmJoin. Time offsets of a rig file are applied to the stamps, so the cameras of the result
/// have none.
ImportResult importFilms(const FilmsInput& input, const ImportOptions& options, std::ostream* notes,
                         bool terminal);

/// Cameras with positions and directions, number of frame sets, warnings.
void print(const ImportResult& result, std::ostream& out);

}  // namespace markerless_mocap
