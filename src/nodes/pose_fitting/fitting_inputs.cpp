#include "nodes/pose_fitting/fitting_inputs.h"

#include <algorithm>
#include <cmath>
#include <exception>

#include "ros/camera_conversions.h"
#include "ros/image_conversions.h"

namespace markerless_mocap {
namespace {

constexpr uint32_t kQueue = 64;             // callbacks only store messages
constexpr size_t kMaxImages = 64;           // per camera; it covers the delay of the masks
constexpr size_t kMaxMasks = 8;             // per camera, until their frame set is whole
constexpr int64_t kMaxDelay = 100'000'000;  // ns; a camera with a larger delay is assumed to have
                                            // stopped
// visual_hull judges the cameras of a frame set while it is fitted, so the last judgement counts.
constexpr size_t kJudgements = 8;
constexpr int64_t kJudgementHolds = 500'000'000;  // ns

}  // namespace

FittingInputs::FittingInputs(ros::NodeHandle& handle, const FittingNodeOptions& options,
                             TrackerNeeds needs, StageStatus* status,
                             std::function<void(FittingMessages)> sink, ReadMask read_mask,
                             std::function<void()> search_begins)
    : options_(options),
      needs_(needs),
      status_(status),
      sink_(std::move(sink)),
      read_mask_(std::move(read_mask)),
      tf_(handle),
      collector_(options.cameras, options.world_frame, options.rig_file, options.requiredCameras()),
      // Before products_: a tracker without masks waits for no camera, and hulls may come at once.
      rig_(needs.masks ? nullptr : std::make_shared<const CameraRig>()),
      mask_sets_(
          {std::max(options.cameras.size(), size_t(1)), options.requiredCameras(),
           options.stamp_tolerance, options.deadline, collector_.timeOffsets()},
          [this](const MaskSet& set) { return waitsForImages(set); },
          [this](const MaskSet& set) { dispatch(set); }),
      images_(options.cameras.size(), kMaxImages),
      pixels_(options.cameras.size(), kMaxMasks),
      states_(options.cameras.size()),
      inputs_(handle, status),
      products_(
          &inputs_, status, std::llround(options.stamp_tolerance * 1e9), !needs.masks,
          [this](const std_msgs::Header& header) { receiveHull(header); },
          std::move(search_begins)) {
  if (!needs_.masks) return;
  if (needs_.colors && !options_.privacy)
    colors_.emplace(options_.cameras, options_.image_transport, &inputs_, status_,
                    [this] { mask_sets_.passOn(); });
  // A driver of many cameras accepts one subscriber after another: the most needed come first.
  for (size_t i = 0; i < options_.cameras.size(); ++i) listenToInfo(i);
  for (size_t i = 0; i < options_.cameras.size(); ++i) listenToCamera(i);
  inputs_.listen<HullCameras>("hull/cameras_used", kQueue, StageInputs::kHelpful,
                              [this](const boost::shared_ptr<const HullCameras>& cameras) {
                                judgements_.push_back(cameras);
                                if (judgements_.size() > kJudgements) judgements_.pop_front();
                              });
}

void FittingInputs::listenToInfo(size_t camera) {
  if (collector_.isFromFile()) return;
  inputs_.listen<sensor_msgs::CameraInfo>(
      options_.cameras[camera] + "/camera_info", kQueue, StageInputs::kOnce,
      [this, camera](const sensor_msgs::CameraInfoConstPtr& info) {
        if (collector_.add(camera, *info)) rig_.reset();
      });
}

void FittingInputs::listenToCamera(size_t camera) {
  const std::string& name = options_.cameras[camera];
  inputs_.listenToMasks(
      name, options_.mask_transport, kQueue,
      [this, camera](const sensor_msgs::ImageConstPtr& mask) { receiveMask(camera, mask); });
  if (!needs_.images) return;
  inputs_.listenToImages(name, options_.image_transport, kQueue, StageInputs::kOptional,
                         [this, camera](const CameraImage& image) {
                           images_.add(camera, nanosecondsOf(image.header().stamp), image);
                         });
}

void FittingInputs::receiveMask(size_t camera, const sensor_msgs::ImageConstPtr& mask) {
  const int64_t stamp_ns = nanosecondsOf(mask->header.stamp);
  collector_.noteImageSize(camera, int(mask->width), int(mask->height));
  {
    const std::lock_guard<std::mutex> lock(states_mutex_);
    states_[camera].last_stamp = mask->header.stamp;
  }
  if (stamp_ns == 0) return;  // visual_hull says so
  if (colors_)
    colors_->noteMask(camera, stamp_ns, hasUnknownBackground(*mask) || areColorsWanted(camera));
  if (options_.privacy && needs_.colors && hasUnknownBackground(*mask))
    status_->remark("the background of " + options_.cameras[camera] +
                    " is not known, and with privacy its colours are not read");
  readBeforehand(camera, *mask);
  mask_sets_.add(camera, mask);
  reportCounts();
}

void FittingInputs::wantColors(std::vector<bool> cameras) {
  const std::lock_guard<std::mutex> lock(states_mutex_);
  wanted_colors_ = std::move(cameras);
}

bool FittingInputs::areColorsWanted(size_t camera) const {
  const std::lock_guard<std::mutex> lock(states_mutex_);
  return camera < wanted_colors_.size() && wanted_colors_[camera];
}

void FittingInputs::readBeforehand(size_t camera, const sensor_msgs::Image& mask) {
  try {
    const cv::Mat pixels = read_mask_(camera, mask);
    if (!pixels.empty()) pixels_.add(camera, nanosecondsOf(mask.header.stamp), pixels);
  } catch (const std::invalid_argument&) {  // told when it is used
  }
}

void FittingInputs::receiveHull(const std_msgs::Header& header) {
  FittingMessages input;
  input.arrival_ns = ros::SteadyTime::now().toNSec();
  input.header = header;
  input.rig = rig_;
  sink_(std::move(input));
}

void FittingInputs::followRig() {
  std::vector<std::string> remarks;
  if (collector_.settle(tf_.buffer(), ros::SteadyTime::now().toSec(), &remarks) != RigChange::kNone)
    rig_.reset();
  for (const std::string& remark : remarks) status_->remark(remark);
  tf_.tellFaults(collector_, status_);
}

void FittingInputs::dispatch(const MaskSet& frame_set) {
  if (mask_sets_.isStray(frame_set)) return status_->count("lone masks between frame sets");
  followRig();
  FittingMessages input;
  input.arrival_ns = ros::SteadyTime::now().toNSec();
  input.header.stamp = rosTime(frame_set.stamp_ns);
  input.header.frame_id = options_.world_frame;
  for (size_t i = 0; i < options_.cameras.size(); ++i) addView(i, frame_set, &input);
  input.error = prepareRig();
  if (countOf(frame_set) < options_.requiredCameras())
    input.error =
        lackOfMasks(countOf(frame_set), options_.cameras.size(), options_.requiredCameras());
  else
    mask_sets_.noteUsed(frame_set);
  if (input.error.empty()) input.error = doubtOf(frame_set);
  input.rig = rig_;
  sink_(std::move(input));
}

std::string FittingInputs::doubtOf(const MaskSet& frame_set) const {
  size_t usable = countOf(frame_set);
  std::string doubt;
  for (size_t i = 0; i < options_.cameras.size(); ++i) {
    if (!frame_set.present[i] || collector_.doubtOf(i).empty()) continue;
    doubt = collector_.doubtOf(i);
    --usable;
  }
  return usable < options_.requiredCameras() ? doubt : "";
}

bool FittingInputs::waitsForImages(const MaskSet& frame_set) const {
  for (size_t i = 0; colors_ && i < options_.cameras.size(); ++i)
    if (frame_set.present[i] &&
        colors_->mayStillCome(i, nanosecondsOf(frame_set.items[i]->header.stamp), 0, kMaxDelay))
      return true;
  return false;
}

void FittingInputs::addView(size_t camera, const MaskSet& frame_set, FittingMessages* input) {
  sensor_msgs::ImageConstPtr mask = frame_set.items[camera];
  const Judgement judgement = judgementOf(camera, frame_set.stamp_ns);
  const std::string& doubt = collector_.doubtOf(camera);
  if (!mask) status_->count("frame sets without the silhouette of " + options_.cameras[camera]);
  if (mask && !(judgement.usable && doubt.empty())) {
    status_->count(
        (doubt.empty() ? "frame sets in which visual_hull left out " : "frame sets without ") +
        options_.cameras[camera]);
    mask.reset();
  }
  noteUse(camera, bool(mask), mask ? "" : doubt.empty() ? judgement.reason : doubt);
  input->masks.push_back(mask);
  input->pixels.push_back(mask ? pixels_.take(camera, nanosecondsOf(mask->header.stamp))
                               : cv::Mat());
  input->later_s.push_back(frame_set.laterBy(camera));
  if (mask && colors_ && colors_->areAwaited(camera, nanosecondsOf(mask->header.stamp)))
    input->images_awaited = true;
  if (needs_.images || colors_)
    input->images.push_back(mask ? takeImage(camera, *mask) : CameraImage());
}

FittingInputs::Judgement FittingInputs::judgementOf(size_t camera, int64_t stamp_ns) const {
  const auto age = [&](const HullCameras& one) {
    return std::abs(stamp_ns - nanosecondsOf(one.header.stamp));
  };
  const HullCameras* last = nullptr;
  for (const auto& one : judgements_)
    if (age(*one) < kJudgementHolds && (!last || age(*one) <= age(*last))) last = one.get();
  if (!last) return {};
  const size_t cameras =
      std::min({last->cameras.size(), last->usable.size(), last->reasons.size()});
  for (size_t i = 0; i < cameras; ++i)
    if (last->cameras[i] == options_.cameras[camera])
      return {bool(last->usable[i]), last->reasons[i]};
  return {};
}

void FittingInputs::noteUse(size_t camera, bool used, const std::string& reason) {
  const std::lock_guard<std::mutex> lock(states_mutex_);
  states_[camera].used = used;
  states_[camera].reason = reason;
}

std::string FittingInputs::lackingCameras() const {
  if (!needs_.masks) return "";
  const std::lock_guard<std::mutex> lock(states_mutex_);
  std::string lacking;
  for (size_t i = 0; i < states_.size(); ++i) {
    if (states_[i].used) continue;
    lacking += (lacking.empty() ? "without " : "; ") + options_.cameras[i];
    if (!states_[i].reason.empty()) lacking += " (" + states_[i].reason + ")";
  }
  return lacking;
}

void FittingInputs::describeCameras(MocapStatus* message) const {
  const std::lock_guard<std::mutex> lock(states_mutex_);
  message->cameras = options_.cameras;
  for (const CameraState& state : states_) {
    message->last_stamps.push_back(state.last_stamp);
    message->used.push_back(state.used);
    message->reasons.push_back(state.reason);
  }
}

CameraImage FittingInputs::takeImage(size_t camera, const sensor_msgs::Image& mask) {
  const int64_t stamp_ns = nanosecondsOf(mask.header.stamp);
  if (needs_.images) return images_.take(camera, stamp_ns);
  if (!colors_->isNeeded(camera, stamp_ns)) return {};
  CameraImage image = colors_->take(camera, stamp_ns);
  if (!hasUnknownBackground(mask) && !areColorsWanted(camera)) return {};
  if (!image) status_->count("frame sets without the colours of " + options_.cameras[camera]);
  return image;
}

std::string FittingInputs::prepareRig() {
  if (rig_) return "";
  try {
    rig_ = std::make_shared<const CameraRig>(collector_.rig(tf_.buffer()));
    return "";
  } catch (const std::exception& error) {
    return error.what();
  }
}

void FittingInputs::reportCounts() {
  const AssemblerCounts& counts = mask_sets_.counts();
  status_->set("frame sets", counts.complete + counts.incomplete);
  status_->set("incomplete frame sets", counts.incomplete);
  status_->set("abandoned frame sets", counts.abandoned);
  status_->set("duplicate or late", counts.duplicate + counts.late);
  status_->set("time went back", counts.time_jumps_back);
}

}  // namespace markerless_mocap
