#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "calibration/board.h"
#include "calibration/lens.h"
#include "calibration/views.h"
#include "calibration/walk_floor.h"
#include "camera/film_clocks.h"
#include "markerless_mocap/camera/camera.h"

namespace markerless_mocap {

/// The view in which the board lies on the floor.
struct FloorView {
  size_t camera = 0;
  double time = 0.0;       ///< s, clock of the camera
  double thickness = 0.0;  ///< m, of the board
};

/// What a rig is calibrated from.
struct CalibrationInput {
  BoardOptions board;
  std::vector<CameraToCalibrate> cameras;
  std::vector<BoardView> views;
  std::vector<KnownPoint> points;  ///< they define the world, if there are any
  std::optional<FloorView> floor;  ///< defines the world, if there are no points
  /// Silhouettes of a person who walks, by the time offsets of the cameras (s); defines the world,
  /// if there are neither points nor a floor. Empty: nobody walks.
  std::function<std::vector<SilhouetteSet>(const std::vector<double>&)> walk;
  std::optional<LensModel> lens;  ///< empty: chosen for each camera by cross-validation
  bool estimate_offsets = false;  ///< the cameras' clocks do not agree
  double largest_offset = kLargestFilmOffset;  ///< s, that is searched for
  /// With estimate_offsets: from where they are estimated, as searchClocks(); empty: searched.
  std::optional<FilmClocks> clocks;
  /// The views are films, so that the board's motion tells whether the cameras' clocks agree; if
  /// they clearly do not, their offsets are estimated and told.
  bool check_clocks = false;
  /// The clocks are those of later recordings, too, as stamps of a bag are: offsets that are found
  /// become part of the calibrations.
  bool clocks_last = false;
  /// The board looks the same turned, but all views show it the same way round.
  bool turns_known = false;
  bool locate = true;  ///< false: intrinsics only
  int threads = 2;
};

/// Residual of one corner, for the report.
struct CornerError {
  Eigen::Vector2d pixel, residual;  ///< pixels
  bool used = true;
};

/// Residuals of one view.
struct ViewError {
  double instant = 0.0;  ///< s: the time that all its cameras share
  double time = 0.0;     ///< s, clock of the camera
  double rms = 0.0;      ///< pixels, over all its corners; NaN if the board's pose is not known
  bool used = true;      ///< false: left out because the camera had moved
  bool alone = false;
  std::vector<CornerError> corners;
};

/// A camera that moved during the recording.
struct LooseTime {
  double time = 0.0;       ///< s: from then on its views disagree with those before
  double pixels = 0.0;     ///< by how much
  bool later_part = true;  ///< what was left out: the part after `time`, else before it
};

/// A calibrated camera.
struct CalibratedCamera {
  CameraCalibration calibration;
  LensModel lens = LensModel::kPlumbBob;
  std::vector<LensTrial> lens_trials;  ///< empty: the model was given
  std::vector<ViewError> views;        ///< by time
  double rms = 0.0;                    ///< pixels, per corner, over the corners used
  double coverage = 0.0;               ///< part of the image, in cells of an eighth, with a corner
  double time_offset = 0.0;            ///< s, to be added to the camera's clock
  Eigen::Vector3d position_sigma = Eigen::Vector3d::Zero();   ///< m, along the camera's x y z
  Eigen::Vector3d direction_sigma = Eigen::Vector3d::Zero();  ///< rad, about the camera's x y z
  Eigen::Vector2d focal_sigma = Eigen::Vector2d::Zero();      ///< pixels
  Eigen::Vector2d centre_sigma = Eigen::Vector2d::Zero();     ///< pixels
  double time_sigma = 0.0;                                    ///< s
  std::optional<LooseTime> loose;
};

/// Two cameras that saw the board together.
struct SharedViews {
  size_t a = 0, b = 0;
  int shared = 0;    ///< instants
  int agreeing = 0;  ///< whose first estimates of the relative pose agree
};

/// A calibrated rig.
struct RigCalibration {
  std::vector<CalibratedCamera> cameras;
  std::vector<SharedViews> pairs;
  double rms = 0.0;  ///< pixels, per corner, of all cameras
  int instants = 0;  ///< of which the board's pose was estimated
  int outliers = 0;  ///< corners that were left out
  bool floor_known = false;
  std::optional<WalkFloor> walk;     ///< the floor, if a person's walk gave it
  bool clocks_corrected = false;     ///< offsets were estimated though nobody asked for it
  std::optional<FilmClocks> clocks;  ///< how they were found, with estimate_offsets
  double points_rms = 0.0;           ///< pixels; 0 without points
  bool turned_guessed = false;  ///< the board looks the same turned and nothing tells how it lay
  std::vector<std::string> verdict;  ///< sentences for people; the first is the summary
  bool good = true;                  ///< nothing in the verdict speaks against use
};

/// The middle of the cameras' offsets, s. What is said of a camera's clock, and what the rig file
/// has, is relative to it.
double middleOffset(const RigCalibration& result);

/// When the films began, by the motion of the board. Lenses that are not given are estimated
/// roughly, by the views of each camera alone.
FilmClocks searchClocks(const CalibrationInput& input);

/// Calibrates all cameras of a rig. Throws std::invalid_argument with a sentence that says what is
/// missing: a camera with too few views, cameras that were never seen together.
/// \param progress called with the part that is done, 0 to 1; may be empty
RigCalibration calibrateRig(const CalibrationInput& input,
                            const std::function<void(double)>& progress = {});

}  // namespace markerless_mocap
