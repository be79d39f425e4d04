#include "nodes/visual_hull/hull_stage.h"

#include <ros/console.h>

#include <algorithm>
#include <chrono>
#include <stdexcept>

#include "camera/camera_difference.h"
#include "hull/camera_trust.h"
#include "nodes/common/camera_pixels.h"
#include "nodes/common/low_latency_transport.h"
#include "nodes/common/master_answers.h"
#include "nodes/common/publish_shared.h"
#include "ros/camera_conversions.h"
#include "ros/hull_conversions.h"
#include "ros/image_conversions.h"

namespace markerless_mocap {
namespace {

constexpr uint32_t kQueue = 16;    // messages per topic that wait while another stage uses the CPU
constexpr size_t kMaxImages = 16;  // per camera; it covers the delay of the masks
constexpr double kImagesKept = 3.0;  // s after somebody listened last

}  // namespace

HullStage::HullStage(ros::NodeHandle& handle, const ros::NodeHandle& private_handle,
                     const HullOptions& options, const HullNodeOptions& node_options)
    : node_options_(node_options),
      tf_(handle),
      rig_(node_options.cameras, node_options.world_frame, node_options.rig_file,
           node_options.requiredCameras()),
      mask_sets_(
          {node_options.cameras.size(), node_options.requiredCameras(),
           node_options.stamp_tolerance, node_options.deadline, rig_.timeOffsets()},
          [this](const MaskSet& set) { return waitsForImages(set); },
          [this](const MaskSet& set) { process(set); }),
      images_(node_options.cameras.size(), kMaxImages),
      carver_(options),
      status_(handle, private_handle, "visual hull"),
      display_(handle, node_options.cameras.size()),
      inputs_(handle, &status_),
      live_(private_handle, options, {},
            [this](const HullOptions& changed) {
              trustIn(node_options_.cameras, changed.camera_trust);  // before there is a rig
              carver_.prepare(changed);
            }),
      handles_(handle.resolveName("hull/volume"), node_options.world_frame,
               {[this](const SettingChanges& changes) { live_.change(changes); },
                [this] { return saveVolume(); }},
               &status_),
      services_(private_handle) {
  trustIn(node_options_.cameras, options.camera_trust);
  points_ = handle.advertise<sensor_msgs::PointCloud2>("hull/points", kPublisherQueue);
  cameras_ = handle.advertise<HullCameras>("hull/cameras_used", kPublisherQueue);
  grid_ = handle.advertise<VoxelGrid>("hull/grid", 1, true);
  if (node_options_.color && node_options_.privacy)
    ROS_INFO("visual hull: with privacy no image is read, so voxels have no colours");
  if (!rig_.unusedCameras().empty()) ROS_WARN_STREAM("visual hull: " << rig_.unusedCameras());
  if (rig_.isFromFile()) prepareBeforehand(ros::Time());
  advertiseServices();
  subscribe();
}

// A driver of many cameras accepts one subscriber after another; nothing can be done without
// camera_info, so these come first.
void HullStage::subscribe() {
  for (size_t i = 0; i < node_options_.cameras.size() && !rig_.isFromFile(); ++i)
    inputs_.listen<sensor_msgs::CameraInfo>(
        node_options_.cameras[i] + "/camera_info", kQueue, StageInputs::kOptional,
        [this, i](const sensor_msgs::CameraInfoConstPtr& info) { receiveInfo(i, *info); });
  for (size_t i = 0; i < node_options_.cameras.size(); ++i) {
    inputs_.listenToMasks(
        node_options_.cameras[i], node_options_.mask_transport, kQueue,
        [this, i](const sensor_msgs::ImageConstPtr& mask) { receiveMask(i, mask); });
  }
}

void HullStage::followDemand() {
  if (!node_options_.readsImages()) return;
  const double now = ros::SteadyTime::now().toSec();
  if (isWanted()) wanted_until_ = now + kImagesKept;
  if (now < wanted_until_ && image_subscribers_.empty() && masterAnswers())
    for (size_t i = 0; i < node_options_.cameras.size(); ++i)
      image_subscribers_.push_back(inputs_.subscribeToImages(
          node_options_.cameras[i], node_options_.image_transport, kQueue, StageInputs::kOptional,
          [this, i](const CameraImage& image) { receiveImage(i, image); }));
  if (now < wanted_until_ || image_subscribers_.empty()) return;
  image_subscribers_.clear();
  images_ = StampCache<CameraImage>(node_options_.cameras.size(), kMaxImages);
}

void HullStage::receiveInfo(size_t camera, const sensor_msgs::CameraInfo& info) {
  if (rig_.add(camera, info)) carver_.forgetRig();
  if (!carver_) prepareBeforehand(info.header.stamp);
}

// Making the carver takes as long as several frame sets, so it is made before the first masks
// arrive.
void HullStage::prepareBeforehand(const ros::Time& stamp) {
  std_msgs::Header header;
  header.stamp = stamp;
  header.frame_id = node_options_.world_frame;
  try {
    prepareCarver(header);
  } catch (const std::exception&) {
    // Camera_info or transforms are missing; this is reported once there are masks.
  }
}

void HullStage::receiveImage(size_t camera, const CameraImage& image) {
  images_.add(camera, nanosecondsOf(image.header().stamp), image);
  mask_sets_.passOn();
}

void HullStage::followRig() {
  std::vector<std::string> remarks;
  const RigChange change = rig_.settle(tf_.buffer(), ros::SteadyTime::now().toSec(), &remarks);
  if (change == RigChange::kAfterPause)
    carver_.forgetRig();
  else if (change == RigChange::kWhileUsed && rig_.missing(tf_.buffer()).empty())
    carver_.changeRig(rig_.rig(tf_.buffer()));
  for (const std::string& remark : remarks) status_.remark(remark);
  tf_.tellFaults(rig_, &status_);
}

std::string HullStage::doubtOf(size_t camera) const {
  const std::string& doubt = rig_.doubtOf(camera);
  const CameraRig* next = carver_.nextRig();
  if (!doubt.empty() || !next || !seeDifferently(carver_->rig()[camera], (*next)[camera]))
    return doubt;
  return node_options_.cameras[camera] + " is left out until its new pose has been taken over";
}

void HullStage::receiveMask(size_t camera, const sensor_msgs::ImageConstPtr& mask) {
  if (mask->header.stamp.isZero())
    return status_.error("the stamps of " + node_options_.cameras[camera] +
                         "'s silhouettes are zero");
  followDemand();
  rig_.noteImageSize(camera, int(mask->width), int(mask->height));
  mask_sets_.add(camera, mask);
  reportCounts();
}

bool HullStage::waitsForImages(const MaskSet& frame_set) const {
  for (size_t i = 0; i < frame_set.items.size(); ++i)
    if (frame_set.present[i] &&
        images_.mayStillCome(i, nanosecondsOf(frame_set.items[i]->header.stamp)))
      return true;
  return false;
}

void HullStage::process(const MaskSet& frame_set) {
  if (mask_sets_.isStray(frame_set)) {
    status_.count("lone masks between frame sets");
    return;
  }
  std_msgs::Header header;
  header.stamp = rosTime(frame_set.stamp_ns);
  header.frame_id = node_options_.world_frame;
  if (!runs_) return status_.ok("stopped by the service set_running");
  VisualHull hull;
  try {
    followRig();
    prepareCarver(header);
    const std::vector<CameraImage> images = takeImages(frame_set);
    std::vector<LeftOutCamera> unreadable;
    const std::vector<HullView> views = viewsOf(frame_set, images, &unreadable);
    mask_sets_.noteUsed(frame_set);
    hull = carver_->carve(views);
    hull.cameras_left_out.insert(hull.cameras_left_out.end(), unreadable.begin(), unreadable.end());
    reportHull(hull, timingRemarks(frame_set));
  } catch (const std::exception& error) {
    hull = VisualHull();
    status_.problem(error.what() + timingRemarks(frame_set));
  }
  publishCameras(frame_set, hull, header);
  if (isWanted()) publishShared(points_, messageFromHull(hull, header));
  status_.sent(header.stamp);
}

void HullStage::prepareCarver(const std_msgs::Header& header) {
  if (carver_.takeNew()) announceCarver(header);
  if (carver_) return;
  if (!carver_.error().empty()) throw std::invalid_argument(carver_.error());
  const std::string missing = rig_.missing(tf_.buffer());
  if (!missing.empty()) throw std::invalid_argument(missing);
  carver_.make(rig_.rig(tf_.buffer()));
  announceCarver(header);
}

void HullStage::announceCarver(const std_msgs::Header& header) {
  grid_.publish(messageFromLattice(carver_->lattice(), header));
  display_.setRig(carver_->rig(), header);
  handles_.show(carver_.volume());
}

std::vector<CameraImage> HullStage::takeImages(const MaskSet& frame_set) {
  std::vector<CameraImage> images(frame_set.items.size());
  for (size_t i = 0; i < images.size(); ++i)
    if (frame_set.present[i])
      images[i] = images_.take(i, nanosecondsOf(frame_set.items[i]->header.stamp));
  return images;
}

void HullStage::requireCameras(size_t usable, const MaskSet& frame_set) const {
  if (usable >= node_options_.requiredCameras()) return;
  throw std::invalid_argument(
      lackOfMasks(usable, frame_set.items.size(), node_options_.requiredCameras()));
}

std::vector<HullView> HullStage::viewsOf(const MaskSet& frame_set,
                                         const std::vector<CameraImage>& images,
                                         std::vector<LeftOutCamera>* left_out) const {
  size_t usable = countOf(frame_set);
  requireCameras(usable, frame_set);
  std::vector<HullView> views(frame_set.items.size());
  for (size_t i = 0; i < views.size(); ++i) {
    if (!frame_set.present[i]) continue;
    try {
      if (const std::string doubt = doubtOf(i); !doubt.empty()) throw std::invalid_argument(doubt);
      views[i].mask = maskOfCamera(carver_->rig()[i], *frame_set.items[i]);
      views[i].image = imageOfCamera(carver_->rig()[i], images[i]);
    } catch (const std::exception& error) {
      left_out->push_back({node_options_.cameras[i], error.what()});
      if (--usable < node_options_.requiredCameras()) throw;
    }
  }
  return views;
}

}  // namespace markerless_mocap
