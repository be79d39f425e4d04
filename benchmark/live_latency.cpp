/// Plays the raw images of a bag to running stages, with the stamps of now, and measures the time
/// from sending the last image of a frame set until its tf and its pose are back:
///
///     roslaunch markerless_mocap mocap.launch nodelets:=true cameras:="[cam0, cam1]"
///     live_latency capture.bag --rate 30 --seconds 120
///
/// With --inside, the stages run in this process, and images reach them without a copy, as those of
/// a camera driver do that is a nodelet beside them (`more_stages:=usb_cameras`):
///
///     roscore & live_latency capture.bag --inside
///
/// The bag begins with the empty room, for twice as many images as are learned from (an image that
/// is lost at first would put the person among those), or with the person, for a start without
/// that. `first tf` counts from its first image. The bag is played forwards and backwards again and
/// again, so there is a start in each round. `settled` is the time from two seconds after the first
/// tf of a round until its end, the empty room at the end included; `all` has starts and losses,
/// too, and counts poses of any status. Frame sets before the first pose message are those from
/// which the background is learned. The period of the frame sets is the reference: each time is
/// also given as a fraction of it.

#include <markerless_mocap/BodyPose.h>
#include <nodelet/loader.h>
#include <ros/ros.h>
#include <rosbag/bag.h>
#include <rosbag/view.h>
#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/Image.h>
#include <tf2_msgs/TFMessage.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <boost/make_shared.hpp>
#include <cstdio>
#include <map>
#include <mutex>
#include <string>
#include <vector>

#include "nodes/common/keep_memory.h"

namespace {

constexpr double kSettled = 2.0;  // s after the first tf of a round

struct Arguments {
  std::string bag;
  double rate = 30.0, seconds = 120.0, warm_up = 4.0;
  bool inside = false;
};

struct Recorded {
  std::vector<std::string> cameras;
  std::map<std::string, std::vector<sensor_msgs::ImagePtr>> images;  ///< by camera
  std::map<std::string, sensor_msgs::CameraInfoPtr> infos;
  tf2_msgs::TFMessage transforms;
  size_t instants() const {
    size_t count = images.begin()->second.size();
    for (const auto& one : images) count = std::min(count, one.second.size());
    return count;
  }
};

Recorded readBag(const std::string& path) {
  const std::string kImage = "/image_raw", kInfo = "/camera_info";
  const auto endsWith = [](const std::string& text, const std::string& end) {
    return text.size() > end.size() && !text.compare(text.size() - end.size(), end.size(), end);
  };
  Recorded recorded;
  rosbag::Bag bag(path);
  for (const rosbag::MessageInstance& message : rosbag::View(bag)) {
    const std::string& topic = message.getTopic();
    if (endsWith(topic, kImage))
      recorded.images[topic.substr(0, topic.size() - kImage.size())].push_back(
          message.instantiate<sensor_msgs::Image>());
    if (endsWith(topic, kInfo))
      recorded.infos[topic.substr(0, topic.size() - kInfo.size())] =
          message.instantiate<sensor_msgs::CameraInfo>();
    if (topic == "/tf_static") recorded.transforms = *message.instantiate<tf2_msgs::TFMessage>();
  }
  if (recorded.images.empty()) throw std::runtime_error(path + " has no */image_raw");
  for (const auto& one : recorded.images) recorded.cameras.push_back(one.first);
  return recorded;
}

/// When each frame set was sent and answered.
class Times {
 public:
  struct FrameSet {
    ros::WallTime sent, tf, pose;
    bool settled = false;
  };

  void beginRound() {
    const std::lock_guard lock(mutex_);
    if (begun_.isZero()) begun_ = ros::WallTime::now();
    first_tf_ = ros::WallTime();
  }
  void sent(const ros::Time& stamp) {
    const std::lock_guard lock(mutex_);
    FrameSet& frame_set = frame_sets_[stamp];
    frame_set.sent = ros::WallTime::now();
    frame_set.settled = !first_tf_.isZero() && (frame_set.sent - first_tf_).toSec() > kSettled;
  }
  void tf(const tf2_msgs::TFMessageConstPtr& message) {
    const std::lock_guard lock(mutex_);
    FrameSet* frame_set = find(message->transforms.front().header.stamp);
    if (frame_set && frame_set->tf.isZero()) frame_set->tf = ros::WallTime::now();
    if (frame_set && first_tf_.isZero()) first_tf_ = ros::WallTime::now();
    if (frame_set && first_of_all_.isZero()) first_of_all_ = ros::WallTime::now();
  }
  void pose(const markerless_mocap::BodyPoseConstPtr& message) {
    const std::lock_guard lock(mutex_);
    FrameSet* frame_set = find(message->header.stamp);
    if (frame_set) frame_set->pose = ros::WallTime::now();
    if (frame_set && first_pose_.isZero()) first_pose_ = frame_set->sent;
  }

  void print(double period) const {
    const std::lock_guard lock(mutex_);
    std::vector<double> settled, started, all;
    size_t without_tf = 0, without_pose = 0, total = 0, learning = 0;
    for (const auto& [stamp, one] : frame_sets_) {
      if (one.sent > ros::WallTime::now() - ros::WallDuration(1.5)) continue;
      ++total;
      if (one.settled && one.tf.isZero()) ++without_tf;
      if (!one.tf.isZero())
        (one.settled ? settled : started).push_back((one.tf - one.sent).toSec());
      if (one.pose.isZero()) ++(one.sent < first_pose_ ? learning : without_pose);
      if (!one.pose.isZero()) all.push_back((one.pose - one.sent).toSec());
    }
    std::printf(
        "%zu frame sets: %zu before the first pose message, then %zu without one; "
        "%zu settled without tf\n",
        total, learning, without_pose, without_tf);
    if (!first_of_all_.isZero())
      std::printf("first tf %.2f s after the first image\n", (first_of_all_ - begun_).toSec());
    printLine("last image to tf, settled", settled, period);
    printLine("last image to tf, at starts", started, period);
    printLine("last image to pose, all", all, period);
    std::fflush(stdout);
  }

 private:
  /// Stamps of a frame set are the mean of its images' stamps, to the nanosecond.
  FrameSet* find(const ros::Time& stamp) {
    const auto at = frame_sets_.find(stamp);
    return at == frame_sets_.end() ? nullptr : &at->second;
  }
  static void printLine(const char* what, std::vector<double> times, double period) {
    if (times.empty()) return;
    std::sort(times.begin(), times.end());
    const auto at = [&](double share) { return times[size_t(share * double(times.size() - 1))]; };
    std::printf("%-28s median %6.1f ms (%.2f periods), 99 %% %6.1f ms (%.2f), worst %6.1f ms\n",
                what, 1e3 * at(0.5), at(0.5) / period, 1e3 * at(0.99), at(0.99) / period,
                1e3 * times.back());
  }

  mutable std::mutex mutex_;
  std::map<ros::Time, FrameSet> frame_sets_;
  ros::WallTime begun_, first_of_all_;
  ros::WallTime first_pose_;  ///< when its frame set was sent
  ros::WallTime first_tf_;    ///< of this round
};

void play(const Arguments& arguments, const Recorded& recorded, ros::NodeHandle& handle,
          Times* times) {
  ros::Publisher transforms = handle.advertise<tf2_msgs::TFMessage>("/tf_static", 1, true);
  transforms.publish(recorded.transforms);
  std::vector<ros::Publisher> images, infos;
  for (const std::string& camera : recorded.cameras) {
    images.push_back(handle.advertise<sensor_msgs::Image>(camera + "/image_raw", 4));
    infos.push_back(handle.advertise<sensor_msgs::CameraInfo>(camera + "/camera_info", 4));
  }
  ros::WallDuration(arguments.warm_up).sleep();
  const size_t instants = recorded.instants();
  ros::WallRate rate(arguments.rate);
  const auto count = size_t(arguments.seconds * arguments.rate);
  for (size_t i = 0; i < count && ros::ok(); ++i) {
    const size_t step = i % (2 * instants), at = std::min(step, 2 * instants - 1 - step);
    if (step == 0) times->beginRound();
    std::vector<sensor_msgs::ImagePtr> next;
    for (const std::string& name : recorded.cameras) {
      const sensor_msgs::ImagePtr& image = recorded.images.at(name)[at];
      // What is shared in a process must not be written to any more.
      next.push_back(arguments.inside ? boost::make_shared<sensor_msgs::Image>(*image) : image);
    }
    const ros::Time stamp = ros::Time::now();
    for (size_t camera = 0; camera < images.size(); ++camera) {
      const std::string& name = recorded.cameras[camera];
      sensor_msgs::CameraInfoPtr info(new sensor_msgs::CameraInfo(*recorded.infos.at(name)));
      info->header.stamp = stamp;
      infos[camera].publish(info);
      next[camera]->header.stamp = stamp;
      images[camera].publish(next[camera]);
    }
    times->sent(stamp);
    rate.sleep();
  }
  ros::WallDuration(2.0).sleep();
}

/// Starts all stages in this process. Throws std::runtime_error if one refuses.
void startStages(const std::vector<std::string>& cameras, nodelet::Loader* loader) {
  for (const char* stage : {"silhouette", "visual_hull", "pose_fitting"})
    ros::param::set("/" + std::string(stage) + "/cameras", cameras);
  for (const char* stage :
       {"silhouette", "visual_hull", "body_segmentation", "pose_tree", "pose_fitting"})
    if (!loader->load("/" + std::string(stage), "markerless_mocap/" + std::string(stage), {}, {}))
      throw std::runtime_error(std::string(stage) + " cannot be started");
}

}  // namespace

int main(int argc, char** argv) {
  ros::init(argc, argv, "live_latency", ros::init_options::AnonymousName);
  markerless_mocap::keepFreedMemory();  // a player that is late delays what it measures
  Arguments arguments;
  CLI::App app("Measures the time from the last image of a frame set to its tf.", "live_latency");
  app.add_option("bag", arguments.bag, "bag with */image_raw, */camera_info and /tf_static")
      ->required();
  app.add_option("--rate", arguments.rate, "frame sets per second")->capture_default_str();
  app.add_option("--seconds", arguments.seconds, "time to play")->capture_default_str();
  app.add_flag("--inside", arguments.inside, "run the stages in this process");
  CLI11_PARSE(app, argc, argv);
  const Recorded recorded = readBag(arguments.bag);
  ros::NodeHandle handle;
  nodelet::Loader stages(false);
  if (arguments.inside) startStages(recorded.cameras, &stages);
  Times times;
  const auto options = ros::TransportHints().tcpNoDelay();
  const ros::Subscriber tf =
      handle.subscribe<tf2_msgs::TFMessage>("/tf", 256, &Times::tf, &times, options);
  const ros::Subscriber pose =
      handle.subscribe<markerless_mocap::BodyPose>("/pose", 256, &Times::pose, &times, options);
  ros::AsyncSpinner spinner(1);
  spinner.start();
  play(arguments, recorded, handle, &times);
  times.print(1.0 / arguments.rate);
  return 0;
}
