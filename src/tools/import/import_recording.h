#pragma once

#include <cstdint>
#include <ostream>
#include <string>
#include <vector>

#include "markerless_mocap/camera/camera.h"
#include "tools/import/world_transform.h"

namespace markerless_mocap {

/// What every import wants to know.
struct ImportOptions {
  std::string output;   ///< bag to write
  std::string rig_out;  ///< rig file to write, or empty
  WorldTransform world;
  double fps = 0.0;          ///< instants per second; 0: the videos' own, 25 for images
  double start_stamp = 1.0;  ///< seconds
  int jpeg_quality = 0;      ///< 1 to 100; 0: raw images

  /// Throws std::invalid_argument naming option, value and what is allowed.
  void validate() const;
  /// Nanoseconds of the k-th instant.
  int64_t stampOf(int frame_set, double frame_sets_per_second) const;
};

/// Images or masks of numbered cameras with a 3x4 projection matrix each; see filesByCamera() for
/// the patterns. The k-th file of each camera, sorted by name, belongs to the k-th instant.
struct MatricesInput {
  std::string matrices;  ///< pattern; which cameras there are
  std::string images;    ///< pattern, or empty
  std::string masks;     ///< pattern, or empty; not black = person
};

/// One folder per camera with a video and an OpenCV calibration file.
struct VideosInput {
  std::string folder;                      ///< holds the cameras' folders, whose names are theirs
  std::string video = "video.avi";         ///< in each folder
  std::string background;                  ///< video of the empty scene that comes first, or empty
  std::string calibration = "config.xml";  ///< see readCalibration()
  /// Rig file that calibrates the cameras instead, in metres with z up; or empty.
  std::string rig;
  int background_frames = 30;  ///< frames taken of the background video
};

/// What an import has written.
struct ImportResult {
  std::vector<CameraCalibration> cameras;  ///< in metres, z up
  int frame_sets = 0;
  double fps = 0.0;
  std::vector<std::string> remarks;  ///< doubts about units and axes, frames left out
};

/// Both write a bag with topics as CameraBagWriter has them; it appears only if all went well. They
/// throw std::runtime_error or std::invalid_argument with one sentence: files that are missing,
/// unreadable or differ in number or size between cameras.
/// \param notes where progress goes; nullptr: nowhere \param terminal whether it is a terminal
ImportResult importMatrices(const MatricesInput& input, const ImportOptions& options,
                            std::ostream* notes, bool terminal);
ImportResult importVideos(const VideosInput& input, const ImportOptions& options,
                          std::ostream* notes, bool terminal);

/// Cameras with their positions and directions, instants, remarks.
void print(const ImportResult& result, std::ostream& out);

}  // namespace markerless_mocap
