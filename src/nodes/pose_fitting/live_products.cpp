#include "nodes/pose_fitting/live_products.h"

#include <chrono>
#include <utility>

#include "nodes/common/master_answers.h"
#include "ros/camera_conversions.h"

namespace markerless_mocap {
namespace {

constexpr uint32_t kQueue = 64;                 // callbacks only store messages
constexpr int64_t kMaxAge_ns = 500'000'000;     // of the newest hull
constexpr double kKeptSubscribed = 3.0;         // s after a tracker asked last
constexpr std::chrono::milliseconds kLook{20};  // while waiting

}  // namespace

LiveProducts::LiveProducts(StageInputs* inputs, StageStatus* status, int64_t tolerance_ns,
                           bool always, std::function<void(const std_msgs::Header&)> hull_came,
                           std::function<void()> search_begins)
    : inputs_(inputs),
      status_(status),
      tolerance_ns_(tolerance_ns),
      always_(always),
      hull_came_(std::move(hull_came)),
      search_begins_(std::move(search_begins)) {
  inputs_->listenToLatched<VoxelGrid>("hull/grid", StageInputs::kOnce,
                                      [this](const VoxelGridConstPtr& grid) {
                                        const std::lock_guard<std::mutex> lock(mutex_);
                                        const std::string fault = grids_.add(grid);
                                        if (!fault.empty()) tell({fault});
                                      });
  if (!always_) return;
  subscribeToHulls();
  subscribeToOthers();
}

LiveProducts::~LiveProducts() {
  close();
}

void LiveProducts::close() {
  const std::lock_guard<std::mutex> lock(mutex_);
  closed_ = true;
  changed_.notify_all();
}

template <class MessageT>
ros::Subscriber LiveProducts::listen(const char* topic, RecentMessages<MessageT>* recent) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    recent->expect(ros::SteadyTime::now().toSec());
  }
  return inputs_->subscribe<MessageT>(
      topic, kQueue, always_ ? StageInputs::kRequired : StageInputs::kOptional,
      [this, recent](const boost::shared_ptr<const MessageT>& message) {
        {
          const std::lock_guard<std::mutex> lock(mutex_);
          recent->add(nanosecondsOf(message->header.stamp), message,
                      ros::SteadyTime::now().toSec());
          changed_.notify_all();
        }
        if constexpr (std::is_same_v<MessageT, sensor_msgs::PointCloud2>)
          if (recent == &hulls_ && always_) hull_came_(message->header);
      });
}

void LiveProducts::subscribeToHulls() {
  hull_subscriber_ = listen("hull/points", &hulls_);
}

void LiveProducts::subscribeToOthers() {
  other_subscribers_.push_back(listen("segmentation/parts", &parts_));
  other_subscribers_.push_back(listen("segmentation/points", &labels_));
  if (!always_) other_subscribers_.push_back(listen("pose_tree", &trees_));
}

void LiveProducts::ask(Asked what) {
  const std::lock_guard<std::mutex> subscribing(subscribing_);
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    asked_for_hulls_ = ros::SteadyTime::now().toSec();
    if (what == kAll) asked_for_others_ = asked_for_hulls_;
  }
  const bool others = what == kAll && other_subscribers_.empty();
  if ((hull_subscriber_ && !others) || !masterAnswers()) return;
  if (!hull_subscriber_) subscribeToHulls();
  if (others) subscribeToOthers();
}

// A callback that runs is waited for, and it needs mutex_.
void LiveProducts::rest() {
  const std::lock_guard<std::mutex> subscribing(subscribing_);
  if (always_) return;
  double hulls, others;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    hulls = ros::SteadyTime::now().toSec() - asked_for_hulls_;
    others = ros::SteadyTime::now().toSec() - asked_for_others_;
  }
  if (hulls > kKeptSubscribed) hull_subscriber_.shutdown();
  if (others > kKeptSubscribed) other_subscribers_.clear();
}

LiveProducts::Messages LiveProducts::wait(int64_t stamp_ns) {
  std::unique_lock<std::mutex> lock(mutex_);
  Messages found;
  const auto look = [&](const auto& recent, auto* message) {
    *message = recent.at(stamp_ns, tolerance_ns_);
    return *message || !recent.mayCome(stamp_ns, ros::SteadyTime::now().toSec());
  };
  const auto complete = [&] {
    const bool done[] = {look(hulls_, &found.hull), look(parts_, &found.parts),
                         look(labels_, &found.labels), always_ || look(trees_, &found.tree)};
    return closed_ || (done[0] && done[1] && done[2] && done[3]);
  };
  while (!complete()) changed_.wait_for(lock, kLook);
  if (!found.parts || !found.labels)
    found.lack = "; body_segmentation has sent nothing for this frame set";
  else if (!found.tree && !always_)
    found.lack = "; pose_tree has sent nothing for this frame set";
  if (!found.hull) found.lack = "; visual_hull has sent nothing for this frame set";
  found.grids = grids_;
  return found;
}

VisualHull LiveProducts::newestHull(int64_t stamp_ns) {
  ProductMessages messages;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    messages.hull = hulls_.newest(stamp_ns, kMaxAge_ns);
    messages.grids = grids_;
  }
  std::vector<std::string> faults;
  VisualHull hull = convertedProducts(messages, &faults).hull;
  tell(faults);
  return hull;
}

void LiveProducts::tell(const std::vector<std::string>& faults) {
  for (const std::string& fault : faults) status_->remark(fault);
}

LiveProducts::Source LiveProducts::at(const ros::Time& stamp) {
  return Source(this, nanosecondsOf(stamp));
}

const FrameProducts& LiveProducts::Source::ofThisFrame() {
  if (of_this_frame_) return *of_this_frame_;
  all_.ask(kAll);
  const Messages messages = all_.wait(stamp_ns_);
  lack_ = messages.lack;
  std::vector<std::string> faults;
  of_this_frame_ = std::make_unique<FrameProducts>(convertedProducts(messages, &faults));
  all_.tell(faults);
  if (lack_.empty() && !faults.empty()) lack_ = "; " + faults.front();
  return *of_this_frame_;
}

const VisualHull& LiveProducts::Source::newestHull() {
  if (of_this_frame_) return of_this_frame_->hull;
  if (newest_hull_) return *newest_hull_;
  all_.ask(kHulls);
  newest_hull_ = std::make_unique<VisualHull>(all_.newestHull(stamp_ns_));
  return *newest_hull_;
}

const FrameProducts& LiveProducts::Source::forStart() {
  if (all_.search_begins_) all_.search_begins_();
  return ofThisFrame();
}

}  // namespace markerless_mocap
