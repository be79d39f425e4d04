#include "nodes/common/stage_inputs.h"

#include <exception>

#include "nodes/common/master_answers.h"
#include "ros/mask_png.h"
#include "text/joined.h"

namespace markerless_mocap {
namespace {

constexpr double kSilence = 5.0;  // seconds

/// What pose_fitting draws is nobody's input.
bool isPicture(const std::string& topic) {
  const std::string name = topic.substr(topic.rfind('/') + 1);
  return name == "overlay" || name == "person";
}

/// Message for a topic without messages: its name, the type of what is sent on it if that is
/// another one, and the topics of its type that may be meant.
std::string silentTopic(const std::string& topic, const std::string& type) {
  const std::string sentence = "no messages on " + topic + " (" + type + "); topics of that type ";
  const auto advertised = advertisedTopics();
  if (!advertised) return sentence + "are not known, as roscore is away";
  std::string others, sent;
  for (const auto& [name, datatype] : *advertised) {
    if (name == topic) sent = datatype;
    if (datatype == type && name != topic && !isPicture(name)) addWord(&others, name);
  }
  return (sent.empty() || sent == type ? "" : "what is sent on " + topic + " is " + sent + "; ") +
         sentence + "are " + (others.empty() ? "none" : others);
}

}  // namespace

ros::Subscriber StageInputs::subscribeToImages(
    const std::string& camera, const std::string& transport, uint32_t queue, Need need,
    const std::function<void(const CameraImage&)>& callback) {
  using Raw = ros::MessageEvent<const sensor_msgs::Image>;
  using Compressed = ros::MessageEvent<const sensor_msgs::CompressedImage>;
  const std::string topic = camera + "/image_raw";
  if (transport == "compressed")
    return subscribe<sensor_msgs::CompressedImage>(
        topic + "/compressed", queue, need, [callback](const Compressed& event) {
          callback({nullptr, event.getConstMessage(), event.getReceiptTime()});
        });
  return subscribe<sensor_msgs::Image>(topic, queue, need, [callback](const Raw& event) {
    callback({event.getConstMessage(), nullptr, event.getReceiptTime()});
  });
}

void StageInputs::listenToMasks(
    const std::string& camera, const std::string& transport, uint32_t queue,
    const std::function<void(const sensor_msgs::ImageConstPtr&)>& callback) {
  using sensor_msgs::CompressedImage;
  const std::string topic = camera + "/silhouette";
  if (transport != "compressed") return listen<sensor_msgs::Image>(topic, queue, kCamera, callback);
  listen<CompressedImage>(
      topic + "/compressed", queue, kCamera,
      [this, camera, callback](const CompressedImage::ConstPtr& message) {
        sensor_msgs::ImageConstPtr mask;
        try {
          mask = maskFromCompressed(*message);
        } catch (const std::exception& error) {
          status_->count("masks of " + camera + " that cannot be read");
          return status_->remark(camera + " has sent masks that cannot be used: " + error.what());
        }
        callback(mask);
      });
}

void StageInputs::require(const std::string& topic, const std::string& type) {
  // Callbacks of topics that are already subscribed may be running.
  gate_.guarded([&] { silent_[topic] = type; })();
  if (!silence_timer_.isValid())
    silence_timer_ = handle_.createWallTimer(
        ros::WallDuration(kSilence),
        gate_.guarded([this](const ros::WallTimerEvent&) { reportSilence(); }));
}

std::optional<size_t> StageInputs::watch(const std::string& topic, Need need) {
  using Loss = StageStatus::Loss;
  if (need == kRequired) return status_->watch(topic, Loss::kStopsStage);
  if (need == kHelpful) return status_->watch(topic, Loss::kCostsSome);
  if (need == kCamera) return status_->watch(topic, Loss::kCostsCamera);
  return std::nullopt;
}

bool StageInputs::isUsable(const std::string& topic, const std::string& sender,
                           SenderWatch* senders) {
  const double now = ros::SteadyTime::now().toSec();
  if (senders->accept(sender, now)) return true;
  status_->remark(sender + " sends on " + topic + ", too; allowed is one sender, the messages of " +
                  senders->sender() + " are used");
  return false;
}

void StageInputs::tellIfAnother(const std::string& topic, const SenderWatch& senders) {
  if (senders.firstSender() == senders.sender()) return;
  status_->remark("what is sent on " + topic + " comes from " + senders.sender() +
                  " now, at first from " + senders.firstSender() + "; allowed is one sender");
}

void StageInputs::reportSilence() {
  if (silent_.empty()) {
    silence_timer_.stop();
    return;
  }
  status_->waiting(silentTopic(silent_.begin()->first, silent_.begin()->second));
}

}  // namespace markerless_mocap
