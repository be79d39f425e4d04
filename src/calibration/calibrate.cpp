#include "calibration/calibrate.h"

#include <tbb/parallel_for.h>
#include <algorithm>
#include <cmath>
#include <mutex>
#include <stdexcept>

#include "calibration/adjust/lens_choice.h"
#include "calibration/adjust/rig_adjustment.h"
#include "calibration/adjust/uncertainty.h"
#include "calibration/check/findings.h"
#include "calibration/check/loose_cameras.h"
#include "calibration/origin/world_frame.h"
#include "calibration/start/pose_graph.h"
#include "calibration/time/instants.h"
#include "calibration/time/offset_search.h"
#include "numerics/order_statistics.h"
#include "text/joined.h"

namespace markerless_mocap {
namespace {

constexpr size_t kLeastViews = 5;

std::vector<const BoardView*> viewsOf(const CalibrationInput& input, size_t camera) {
  std::vector<const BoardView*> views;
  for (const BoardView& view : input.views)
    if (view.camera == camera) views.push_back(&view);
  return views;
}

/// The steps of one calibration.
class Calibrator {
 public:
  Calibrator(const CalibrationInput& input, const std::function<void(double)>& progress)
      : input_(input),
        progress_(progress),
        board_(input.board),
        views_(input.views),
        adjustment_(board_, views_, poses_, input.threads, &state_) {
    if (input_.cameras.empty()) throw std::invalid_argument("there is no camera to calibrate");
    state_.cameras.resize(input_.cameras.size());
    state_.points = input_.points;
    trials_.resize(input_.cameras.size());
    if (input_.estimate_offsets) adjustment_.freeOffsets();
  }

  RigCalibration run() {
    checkViews();
    startLenses(0.4);
    if (board_.looksSameTurned())
      keepTurns(int(board_.corners().size()), state_.cameras.size(), &views_);
    estimatePosesOfViews();
    startOffsets();
    startPoses();
    done(0.5);
    leaveOutLooseParts();
    done(0.6);
    adjustment_.run();
    done(0.8);
    if (input_.check_clocks) adjustment_.checkClocks();
    chooseWorld();
    done(0.95);
    return result();
  }

 private:
  void done(double part) const {
    if (progress_) progress_(part);
  }

  void checkViews() const {
    for (size_t i = 0; i < input_.cameras.size(); ++i) {
      const size_t count = viewsOf(input_, i).size();
      if (input_.cameras[i].given || count >= kLeastViews) continue;
      throw std::invalid_argument(
          "the board was found in " + std::to_string(count) + " pictures of " +
          input_.cameras[i].name + ", its lens needs at least " + std::to_string(kLeastViews) +
          ": is the board described rightly (squares are counted, not inner corners)?");
    }
  }

  void startLens(size_t i) {
    CameraState& camera = state_.cameras[i];
    camera.size << input_.cameras[i].width, input_.cameras[i].height;
    if (const auto& given = input_.cameras[i].given) {
      camera.intrinsics = intrinsicsOf(*given);
      camera.intrinsics_fixed = true;
      camera.lens = modelOf(*given);
      return;
    }
    const LensChoice choice = lensFromViews(board_, input_.cameras[i], viewsOf(input_, i),
                                            input_.lens, &camera.intrinsics);
    camera.lens = choice.lens;
    trials_[i] = choice.trials;
  }

  /// The longest step where there are many views, so each camera is told.
  void startLenses(double part) {
    std::mutex mutex;
    size_t ready = 0;
    tbb::parallel_for(size_t(0), state_.cameras.size(), [&](size_t i) {
      startLens(i);
      const std::lock_guard<std::mutex> lock(mutex);
      done(part * double(++ready) / double(state_.cameras.size()));
    });
  }

  void estimatePosesOfViews() {
    poses_.resize(views_.size());
    tbb::parallel_for(size_t(0), views_.size(), [&](size_t i) {
      const CameraState& camera = state_.cameras[views_[i].camera];
      poses_[i] = boardPose(board_, views_[i].corners, camera.intrinsics, camera.lens);
    });
  }

  void startOffsets() {
    if (!input_.estimate_offsets) return;
    clocks_ = input_.clocks ? *input_.clocks
                            : searchOffsets(board_, state_.cameras.size(), views_, poses_,
                                            input_.largest_offset);
    std::string lacking;
    for (size_t i = 0; i < state_.cameras.size(); ++i) {
      state_.cameras[i].time_offset = clocks_->offsets[i];
      if (!std::isfinite(clocks_->offsets[i])) addWord(&lacking, input_.cameras[i].name);
    }
    if (!lacking.empty())
      throw std::invalid_argument(
          "the time offset of " + lacking +
          " cannot be found: too little of the board's motion is seen together with other cameras");
  }

  void startPoses() {
    adjustment_.regroup();
    pairs_ = cameraPairs(board_, state_, poses_);
    groups_ = placeCameras(board_, pairs_, poses_, &state_);
    if (!state_.points.empty()) placeByPoints(groups_, &state_);
    if (input_.locate) checkLocated();
    for (size_t i = 0; i < groups_.size(); ++i)
      if (state_.points.empty() && isRoot(i)) adjustment_.hold(i);
  }

  /// The camera at the origin of its group.
  bool isRoot(size_t i) const { return state_.cameras[i].camera_world.isZero(0.0); }

  void checkLocated() const {
    std::string apart, joined;
    for (size_t i = 0; i < groups_.size(); ++i) {
      std::string& list = state_.cameras[i].located ? joined : apart;
      addWord(&list, input_.cameras[i].name);
    }
    if (apart.empty()) return;
    throw std::invalid_argument("no picture joins " + apart + " to " +
                                (joined.empty() ? "the known points" : joined) +
                                ": show the board where both see it at the same time");
  }

  /// Whether the board was seen in places that differ by half its size.
  bool boardMoved() const {
    Eigen::AlignedBox3d places;
    for (const Instant& instant : state_.instants)
      if (instant.located) places.extend(instant.world_board.tail<3>());
    return !places.isEmpty() && places.diagonal().norm() > 0.5 * board_.size().norm();
  }

  /// With the lenses that each camera found alone, which know nothing of the others: free ones
  /// would bend until they meet the views of a camera that moved.
  void leaveOutLooseParts() {
    BundleOptions fixed = adjustment_.options();
    fixed.estimate_intrinsics = false;
    fixed.estimate_offsets |= input_.check_clocks;  // a late clock is no loose camera
    for (const double loss : {BundleOptions().loss_pixels, std::max(0.5, medianViewError())}) {
      fixed.loss_pixels = loss;
      adjustBundle(board_, fixed, &state_);
    }
    loose_ = leaveOutLooseViews(board_, fixed, &state_);
    if (!adjustment_.areOffsetsFree())
      for (CameraState& camera : state_.cameras) camera.time_offset = 0.0;
  }

  void chooseWorld() {
    sigmas_ = uncertaintiesOf(board_, state_, adjustment_.held(), adjustment_.areOffsetsFree());
    if (!input_.locate || !state_.points.empty()) return;
    if (input_.floor)
      putFloorUnderBoard(input_.floor->camera, input_.floor->time, input_.floor->thickness,
                         &state_);
    else
      guessFloor(board_, &state_);
  }

  /// Of the views each by itself, pixels: how well the corners were found.
  double medianViewError() const {
    std::vector<double> errors;
    for (const BoardPose& pose : poses_)
      if (std::isfinite(pose.rms)) errors.push_back(pose.rms);
    return errors.empty() ? 0.0 : medianAmong(errors);
  }

  RigCalibration result() const {
    RigCalibration result = summarise(board_, input_, state_);
    for (size_t i = 0; i < state_.cameras.size(); ++i) {
      CalibratedCamera& camera = result.cameras[i];
      camera.lens_trials = trials_[i];
      camera.position_sigma = sigmas_[i].position;
      camera.direction_sigma = sigmas_[i].direction;
      camera.focal_sigma = sigmas_[i].focal;
      camera.centre_sigma = sigmas_[i].centre;
      camera.time_sigma = sigmas_[i].time_offset;
    }
    for (const CameraPair& pair : pairs_)
      result.pairs.push_back({pair.a, pair.b, pair.shared, pair.agreeing});
    for (const LooseCamera& loose : loose_)
      result.cameras[loose.camera].loose = LooseTime{loose.time, loose.pixels, loose.later_part};
    const bool offsets_free = adjustment_.areOffsetsFree();
    result.outliers = adjustment_.outliers();
    result.clocks = clocks_;
    result.clocks_corrected = offsets_free && !input_.estimate_offsets;
    if (offsets_free && input_.clocks_last) keepOffsets(&result);
    if (input_.locate && input_.walk && !input_.floor && state_.points.empty())
      putFloorUnderWalk(input_, &result);
    result.turned_guessed = board_.looksSameTurned() && !boardMoved() && !input_.turns_known;
    writeVerdict(input_, &result);
    return result;
  }

  const CalibrationInput& input_;
  const std::function<void(double)>& progress_;
  Board board_;
  std::vector<BoardView> views_;
  RigState state_;
  std::vector<std::vector<LensTrial>> trials_;
  std::vector<BoardPose> poses_;
  RigAdjustment adjustment_;
  std::vector<CameraPair> pairs_;
  std::vector<size_t> groups_;
  std::vector<LooseCamera> loose_;
  std::vector<CameraUncertainty> sigmas_;
  std::optional<FilmClocks> clocks_;
};

}  // namespace

RigCalibration calibrateRig(const CalibrationInput& input,
                            const std::function<void(double)>& progress) {
  return Calibrator(input, progress).run();
}

}  // namespace markerless_mocap
