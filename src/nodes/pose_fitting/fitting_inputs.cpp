#include "nodes/pose_fitting/fitting_inputs.h"

#include <algorithm>
#include <cmath>
#include <exception>

#include "camera/timing_remarks.h"
#include "ros/camera_conversions.h"
#include "ros/image_conversions.h"

namespace markerless_mocap {
namespace {

constexpr uint32_t kQueue = 64;        // callbacks only store messages
constexpr double kDeadline = 2.0;      // maximum delay of a stage relative to the hull, seconds
constexpr double kSilence = 0.3;       // s until a stage that has stopped is not waited for
constexpr double kLookInterval = 0.1;  // s
constexpr int kMaxPending = 60;        // frame sets; at 30 per second as long as the deadline
constexpr size_t kMaxViews = 64;       // per camera; it covers the delay of the stages
// Between processes, a silhouette can arrive later than the hull that was carved from it.
constexpr size_t kMaxWaiting = 3;           // frame sets
constexpr int64_t kMaxDelay = 100'000'000;  // nanoseconds; a camera with a larger delay is
                                            // assumed to have stopped

AssemblerOptions joinOptions(TrackerNeeds needs) {
  AssemblerOptions options;
  options.tolerance = 0.0;
  options.deadline = kDeadline;
  options.max_pending = kMaxPending;
  options.min_streams = needs.masks ? 1 : 3;
  // The other methods can do nothing without all stages.
  if (needs.masks) options.silence = kSilence;
  return options;
}

}  // namespace

FittingInputs::FittingInputs(ros::NodeHandle& handle, const FittingNodeOptions& options,
                             TrackerNeeds needs, StageStatus* status,
                             std::function<void(FittingMessages)> sink)
    : options_(options),
      needs_(needs),
      status_(status),
      sink_(std::move(sink)),
      tf_listener_(tf_),
      collector_(options.cameras, options.world_frame, options.rig_file),
      assembler_(needs.masks ? 5 : 3, joinOptions(needs)),
      offsets_(collector_.timeOffsets()),
      lags_(options.cameras.size()),
      masks_(options.cameras.size(), kMaxViews),
      images_(options.cameras.size(), kMaxViews),
      pending_(kMaxWaiting),
      states_(options.cameras.size()),
      inputs_(handle, status) {
  if (needs_.colors)
    colors_.emplace(options_.cameras, options_.image_transport, &inputs_, status_,
                    [this] { dispatchReady(); });
  if (!needs_.masks) rig_ = std::make_shared<const CameraRig>();
  for (size_t i = 0; needs_.masks && i < options_.cameras.size(); ++i) listenToCamera(i);
  listenToStages();
}

void FittingInputs::listenToStages() {
  using sensor_msgs::PointCloud2;
  inputs_.listen<VoxelGrid>("hull/grid", 1, StageInputs::kOnce,
                            [this](const VoxelGridConstPtr& grid) { grids_.add(grid); });
  inputs_.listen<PointCloud2>("hull/points", kQueue, StageInputs::kRequired,
                              [this](const sensor_msgs::PointCloud2ConstPtr& hull) {
                                receive(kHull, hull->header, {hull, {}, {}, {}});
                              });
  inputs_.listen<BodyPartsMsg>("segmentation/parts", kQueue,
                               needs_.masks ? StageInputs::kHelpful : StageInputs::kRequired,
                               [this](const BodyPartsMsg::ConstPtr& parts) {
                                 receive(kParts, parts->header, {{}, parts, {}, {}});
                               });
  inputs_.listen<PointCloud2>("segmentation/points", kQueue,
                              needs_.masks ? StageInputs::kHelpful : StageInputs::kRequired,
                              [this](const sensor_msgs::PointCloud2ConstPtr& labels) {
                                receive(kLabels, labels->header, {labels, {}, {}, {}});
                              });
  if (!needs_.masks) return;
  inputs_.listen<PoseTreeMsg>("pose_tree", kQueue, StageInputs::kHelpful,
                              [this](const PoseTreeMsg::ConstPtr& tree) {
                                receive(kTree, tree->header, {{}, {}, tree, {}});
                              });
  inputs_.listen<HullCameras>("hull/cameras_used", kQueue, StageInputs::kOptional,
                              [this](const boost::shared_ptr<const HullCameras>& cameras) {
                                receive(kCameras, cameras->header, {{}, {}, {}, cameras});
                              });
}

void FittingInputs::listenToCamera(size_t camera) {
  const std::string& name = options_.cameras[camera];
  if (!collector_.isFromFile())
    inputs_.listen<sensor_msgs::CameraInfo>(
        name + "/camera_info", kQueue, StageInputs::kOnce,
        [this, camera](const sensor_msgs::CameraInfoConstPtr& info) {
          if (collector_.add(camera, *info)) rig_.reset();
        });
  inputs_.listen<sensor_msgs::Image>(
      name + "/silhouette", kQueue, StageInputs::kCamera,
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
  const bool unknown = colors_ && hasUnknownBackground(*mask);
  if (colors_) colors_->noteMask(camera, stamp_ns, unknown);
  masks_.add(camera, stamp_ns, {mask, unknown});
  dispatchReady();
}

void FittingInputs::receive(Stream stream, const std_msgs::Header& header, Item item) {
  for (auto& frame_set : assembler_.add(stream, nanosecondsOf(header.stamp), std::move(item)))
    join(std::move(frame_set));
  dispatchReady();
  reportCounts();
}

void FittingInputs::join(Assembler::FrameSet frame_set) {
  if (!frame_set.present[kHull]) {
    status_->count("frame sets without a hull");
    return;
  }
  FittingMessages input;
  input.hull = frame_set.items[kHull].cloud;
  input.header = input.hull->header;
  input.parts = frame_set.items[kParts].parts;
  input.labels = frame_set.items[kLabels].cloud;
  input.complete = frame_set.present[kParts] && frame_set.present[kLabels];
  if (needs_.masks) {
    input.tree = frame_set.items[kTree].tree;
    input.cameras = frame_set.items[kCameras].cameras;
    input.complete = input.complete && input.tree;
  }
  pending_.push(std::move(input));
}

void FittingInputs::followRig() {
  const double now = ros::WallTime::now().toSec();
  if (now >= next_look_ || now < next_look_ - kLookInterval) {
    next_look_ = now + kLookInterval;
    std::vector<std::string> remarks;
    if (collector_.settle(tf_, now, &remarks)) rig_.reset();
    for (const std::string& remark : remarks) status_->remark(remark);
  }
}

void FittingInputs::dispatchReady() {
  if (needs_.masks) followRig();
  pending_.release([this](const FittingMessages& input) { return waitsForViews(input); },
                   [this](FittingMessages input) {
                     if (needs_.masks) addViews(&input);
                     if (!grids_.empty()) input.grid = grids_.of(input.header.stamp);
                     input.error = input.grid ? prepareRig() : "no hull/grid has been received yet";
                     input.rig = rig_;
                     sink_(std::move(input));
                   });
}

bool FittingInputs::waitsForViews(const FittingMessages& input) const {
  if (!needs_.masks) return false;
  const int64_t hull_ns = nanosecondsOf(input.header.stamp), tolerance = stampTolerance();
  for (size_t i = 0; i < options_.cameras.size(); ++i) {
    const int64_t stamp_ns = stampOfCamera(i, hull_ns);
    if (masks_.mayStillCome(i, stamp_ns, tolerance, kMaxDelay) ||
        (colors_ && colors_->mayStillCome(i, stamp_ns, tolerance, kMaxDelay)))
      return true;
  }
  return false;
}

int64_t FittingInputs::stampOfCamera(size_t camera, int64_t hull_stamp_ns) const {
  if (offsets_.empty()) return hull_stamp_ns;
  return hull_stamp_ns - std::llround(1e9 * offsets_[camera] - lags_.lag_ns(camera));
}

// The hull's stamp has the lags taken off that visual_hull follows; here they are found anew.
void FittingInputs::followLag(size_t camera, int64_t mask_stamp_ns, int64_t hull_stamp_ns) {
  if (offsets_.empty()) return;
  const double lag = double(mask_stamp_ns - hull_stamp_ns) + 1e9 * offsets_[camera];
  if (std::abs(lag) <= 1e9 * kFollowedDrift) lags_.add(camera, lag);
}

int64_t FittingInputs::stampTolerance() const {
  return int64_t(std::llround(options_.stamp_tolerance * 1e9));
}

void FittingInputs::addViews(FittingMessages* input) {
  const int64_t hull_ns = nanosecondsOf(input->header.stamp);
  for (size_t i = 0; i < options_.cameras.size(); ++i) {
    Mask mask = masks_.take(i, stampOfCamera(i, hull_ns), stampTolerance());
    const std::string refusal = refusalOf(*input, i);
    if (mask.message)
      followLag(i, nanosecondsOf(mask.message->header.stamp), hull_ns);
    else
      status_->count("frame sets without the silhouette of " + options_.cameras[i]);
    if (mask.message && !refusal.empty()) {
      status_->count("frame sets in which visual_hull left out " + options_.cameras[i]);
      mask = Mask();
    }
    noteUse(i, bool(mask.message), refusal);
    input->masks.push_back(mask.message);
    if (needs_.images || needs_.colors) input->images.push_back(takeImage(i, mask));
  }
}

std::string FittingInputs::refusalOf(const FittingMessages& input, size_t camera) const {
  if (!input.cameras) return "";
  const HullCameras& hull = *input.cameras;
  for (size_t i = 0; i < hull.cameras.size() && i < hull.usable.size(); ++i)
    if (hull.cameras[i] == options_.cameras[camera] && !hull.usable[i])
      return i < hull.reasons.size() && !hull.reasons[i].empty() ? hull.reasons[i] : "left out";
  return "";
}

void FittingInputs::noteUse(size_t camera, bool used, const std::string& reason) {
  const std::lock_guard<std::mutex> lock(states_mutex_);
  states_[camera].used = used;
  states_[camera].reason = reason;
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

CameraImage FittingInputs::takeImage(size_t camera, const Mask& mask) {
  if (!mask.message) return {};
  const int64_t stamp_ns = nanosecondsOf(mask.message->header.stamp);
  if (needs_.images) return images_.take(camera, stamp_ns);
  const CameraImage image = colors_->take(camera, stamp_ns);
  if (!mask.unknown) return {};
  if (!image) status_->count("frame sets without the colours of " + options_.cameras[camera]);
  return image;
}

std::string FittingInputs::prepareRig() {
  if (rig_) return "";
  try {
    rig_ = std::make_shared<const CameraRig>(collector_.rig(tf_));
    return "";
  } catch (const std::exception& error) {
    return error.what();
  }
}

void FittingInputs::reportCounts() {
  const AssemblerCounts& counts = assembler_.counts();
  status_->set("frame sets", counts.complete + counts.incomplete);
  status_->set("incomplete frame sets", counts.incomplete);
  status_->set("abandoned frame sets", counts.abandoned + counts.overflow);
  status_->set("duplicate or late", counts.duplicate + counts.late);
  status_->set("time went back", counts.time_jumps_back);
}

}  // namespace markerless_mocap
