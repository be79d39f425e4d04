#include "nodes/visual_hull/hull_stage.h"

#include <ros/console.h>

#include <algorithm>
#include <stdexcept>

#include "nodes/common/low_latency_transport.h"
#include "nodes/common/publish_shared.h"
#include "ros/camera_conversions.h"
#include "ros/camera_markers.h"
#include "ros/hull_conversions.h"
#include "ros/image_conversions.h"

namespace markerless_mocap {
namespace {

constexpr uint32_t kQueue = 16;     // messages per topic while another stage has the cores
constexpr size_t kMostWaiting = 3;  // instants held back for their images
constexpr size_t kMostImages = 16;  // per camera: what the masks may lag behind
constexpr double kMarkerDepth = 0.5;

AssemblerOptions assemblerOptions(const HullNodeOptions& node) {
  AssemblerOptions options;
  options.tolerance = node.stamp_tolerance;
  options.deadline = node.deadline;
  options.min_streams = 1;  // an instant of too few cameras gets its reason published
  return options;
}

/// "hull of 2000 voxels without camera 'a': its mask is full; 2 components are suspect ghosts"
std::string sentenceOn(const VisualHull& hull) {
  std::string sentence = "hull of " + std::to_string(hull.voxels.size()) + " voxels";
  for (const LeftOutCamera& camera : hull.cameras_left_out)
    sentence += " without camera '" + camera.name + "': " + camera.reason + ";";
  if (!hull.cameras_left_out.empty()) sentence.pop_back();
  const auto ghosts = std::count_if(hull.components.begin(), hull.components.end(),
                                    [](const HullComponent& c) { return c.suspect_ghost; });
  if (ghosts > 0) sentence += "; " + std::to_string(ghosts) + " components are suspect ghosts";
  return sentence;
}

}  // namespace

HullStage::HullStage(ros::NodeHandle& handle, const ros::NodeHandle& private_handle,
                     const HullOptions& options, const HullNodeOptions& node_options)
    : options_(options),
      node_options_(node_options),
      tf_listener_(tf_),
      rig_(node_options.cameras, node_options.world_frame, node_options.rig_file),
      assembler_(node_options.cameras.size(), assemblerOptions(node_options)),
      images_(node_options.cameras.size(), kMostImages),
      waiting_(kMostWaiting),
      status_(handle, private_handle, "visual hull"),
      inputs_(handle, &status_) {
  points_ = handle.advertise<sensor_msgs::PointCloud2>("hull/points", kPublisherQueue);
  grid_ = handle.advertise<VoxelGrid>("hull/grid", 1, true);
  markers_ = handle.advertise<visualization_msgs::MarkerArray>("hull/cameras", 1, true);
  if (!rig_.unusedCameras().empty()) ROS_WARN_STREAM("visual hull: " << rig_.unusedCameras());
  if (rig_.isFromFile()) prepareBeforehand(ros::Time());
  subscribe();
}

void HullStage::subscribe() {
  for (size_t i = 0; i < node_options_.cameras.size(); ++i) {
    const std::string& camera = node_options_.cameras[i];
    if (!rig_.isFromFile())
      inputs_.listen<sensor_msgs::CameraInfo>(
          camera + "/camera_info", kQueue, StageInputs::kOptional,
          [this, i](const sensor_msgs::CameraInfoConstPtr& info) { receiveInfo(i, *info); });
    if (node_options_.color)
      inputs_.listenToImages(camera, node_options_.image_transport, kQueue, StageInputs::kOptional,
                             [this, i](const CameraImage& image) { receiveImage(i, image); });
    inputs_.listen<sensor_msgs::Image>(
        camera + "/silhouette", kQueue, StageInputs::kRequired,
        [this, i](const sensor_msgs::ImageConstPtr& mask) { receiveMask(i, mask); });
  }
}

void HullStage::receiveInfo(size_t camera, const sensor_msgs::CameraInfo& info) {
  if (rig_.add(camera, info)) {
    carver_.reset();
    carver_error_.clear();
  }
  if (!carver_) prepareBeforehand(info.header.stamp);
}

// Making it takes as long as several instants do, so not when the first masks are there.
void HullStage::prepareBeforehand(const ros::Time& stamp) {
  std_msgs::Header header;
  header.stamp = stamp;
  header.frame_id = node_options_.world_frame;
  try {
    prepareCarver(header);
  } catch (const std::exception&) {
    // Camera_info or transforms are still to come; said once there are masks.
  }
}

void HullStage::receiveImage(size_t camera, const CameraImage& image) {
  images_.add(camera, nanosecondsOf(image.header().stamp), image);
  drain();
}

void HullStage::receiveMask(size_t camera, const sensor_msgs::ImageConstPtr& mask) {
  const uint64_t jumps = assembler_.counts().time_jumps_back;
  auto instants = assembler_.add(camera, nanosecondsOf(mask->header.stamp), mask);
  if (assembler_.counts().time_jumps_back != jumps) waiting_.clear();
  for (auto& instant : instants) waiting_.push(std::move(instant));
  drain();
  reportCounts();
}

void HullStage::drain() {
  waiting_.release([this](const Assembler::FrameSet& instant) { return waitsForImages(instant); },
                   [this](const Assembler::FrameSet& instant) { process(instant); });
}

bool HullStage::waitsForImages(const Assembler::FrameSet& instant) const {
  for (size_t i = 0; i < instant.items.size(); ++i)
    if (instant.present[i] &&
        images_.mayStillCome(i, nanosecondsOf(instant.items[i]->header.stamp)))
      return true;
  return false;
}

void HullStage::process(const Assembler::FrameSet& instant) {
  std_msgs::Header header;
  header.stamp = rosTime(instant.stamp_ns);
  header.frame_id = node_options_.world_frame;
  VisualHull hull;
  try {
    prepareCarver(header);
    const std::vector<CameraImage> images = takeImages(instant);
    hull = carver_->carve(viewsOf(instant, images));
    reportHull(hull);
  } catch (const std::exception& error) {
    hull = VisualHull();
    status_.problem(error.what());
  }
  publishShared(points_, messageFromHull(hull, header));
}

void HullStage::reportHull(const VisualHull& hull) {
  for (const LeftOutCamera& camera : hull.cameras_left_out)
    status_.count("frame sets without camera " + camera.name);
  if (hull.status != HullStatus::kOk)
    status_.problem(hull.reason);
  else if (hull.cameras_left_out.empty() && !hull.components[0].suspect_ghost)
    status_.ok(sentenceOn(hull));
  else
    status_.waiting(sentenceOn(hull));
}

void HullStage::prepareCarver(const std_msgs::Header& header) {
  if (carver_) return;
  if (!carver_error_.empty()) throw std::invalid_argument(carver_error_);
  const std::string missing = rig_.missing(tf_);
  if (!missing.empty()) throw std::invalid_argument(missing);
  try {
    carver_.emplace(rig_.rig(tf_), options_);
  } catch (const std::invalid_argument& error) {
    carver_error_ = error.what();
    throw;
  }
  grid_.publish(messageFromLattice(carver_->lattice(), header));
  markers_.publish(cameraMarkers(carver_->rig(), header, kMarkerDepth));
}

std::vector<CameraImage> HullStage::takeImages(const Assembler::FrameSet& instant) {
  std::vector<CameraImage> images(instant.items.size());
  for (size_t i = 0; i < images.size(); ++i)
    if (instant.present[i])
      images[i] = images_.take(i, nanosecondsOf(instant.items[i]->header.stamp));
  return images;
}

std::vector<HullView> HullStage::viewsOf(const Assembler::FrameSet& instant,
                                         const std::vector<CameraImage>& images) const {
  const size_t present = std::count(instant.present.begin(), instant.present.end(), true);
  if (present < node_options_.requiredCameras())
    throw std::invalid_argument(
        "the frame set has the masks of " + std::to_string(present) + " of " +
        std::to_string(instant.items.size()) + " cameras, needed are " +
        std::to_string(node_options_.requiredCameras()) + " within the deadline");
  std::vector<HullView> views(instant.items.size());
  for (size_t i = 0; i < views.size(); ++i) {
    if (!instant.present[i]) continue;
    views[i].mask = maskFromMessage(*instant.items[i]);
    views[i].image = images[i].mat();
  }
  return views;
}

void HullStage::reportCounts() {
  const AssemblerCounts& counts = assembler_.counts();
  status_.set("complete frame sets", counts.complete);
  status_.set("incomplete frame sets", counts.incomplete);
  status_.set("abandoned frame sets", counts.abandoned);
  status_.set("duplicate masks", counts.duplicate);
  status_.set("late masks", counts.late);
  status_.set("masks far in the future", counts.far_future);
  status_.set("frame sets dropped from a full queue", counts.overflow);
  status_.set("time went back", counts.time_jumps_back);
}

}  // namespace markerless_mocap
