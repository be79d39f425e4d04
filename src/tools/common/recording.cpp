#include "tools/common/recording.h"

#include <sensor_msgs/CameraInfo.h>

#include <algorithm>
#include <map>
#include <stdexcept>

#include "camera/timing_remarks.h"
#include "markerless_mocap/camera/rig_file.h"
#include "markerless_mocap/products/silhouette_mask.h"
#include "ros/camera_conversions.h"
#include "ros/image_conversions.h"
#include "ros/rig_collector.h"
#include "text/number_text.h"
#include "tools/common/bag_io.h"
#include "tools/common/camera_bag_writer.h"
#include "tools/common/recorded_transforms.h"
#include "tools/common/reused_image.h"

namespace markerless_mocap {
namespace {

constexpr size_t kLookAhead = 10;  // images of each stream

/// In a recording, a late camera can be waited for longer than in real time.
AssemblerOptions offlineAssembly(double tolerance, const std::vector<double>& offsets) {
  AssemblerOptions options;
  options.tolerance = tolerance;
  options.out_of_step = OutOfStep::kJoinIfNever;
  options.offsets = offsets;
  for (const double offset : offsets)
    if (offset != 0.0) options.max_drift = kFollowedDrift;
  // A bag that was written by stamps has the images of another clock that much earlier or later.
  const double apart = offsets.empty() ? 0.0
                                       : *std::max_element(offsets.begin(), offsets.end()) -
                                             *std::min_element(offsets.begin(), offsets.end());
  options.deadline = 0.5 + apart;
  options.max_jump += apart;
  options.max_pending = 1000;  // limited by the deadline instead; no overflow
  return options;
}

std::vector<std::string> namesOf(const std::vector<RecordedCamera>& cameras) {
  std::vector<std::string> names;
  for (const RecordedCamera& camera : cameras) names.push_back(camera.name);
  return names;
}

RecordedImage imageOf(const rosbag::MessageInstance& message) {
  if (const auto raw = messageOf<ReusedImage>(message)) return {raw->image, nullptr};
  if (const auto compressed = messageOf<sensor_msgs::CompressedImage>(message))
    return {nullptr, compressed};
  throw std::runtime_error("topic " + message.getTopic() + " holds " + message.getDataType() +
                           ", expected are images of this ROS");
}

int64_t stampOf(const RecordedImage& image) {
  return nanosecondsOf(image.raw ? image.raw->header.stamp : image.compressed->header.stamp);
}

/// A decoded image may share the pixels of the message.
cv::Mat decoded(const RecordedImage& image, bool is_mask) {
  if (!image.compressed)
    return is_mask ? maskFromMessage(*image.raw) : sharedMatFromMessage(*image.raw);
  const cv::Mat pixels = matFromMessage(*image.compressed);
  return is_mask && pixels.type() == CV_8UC1 ? maskOfThreeValues(pixels) : pixels;
}

}  // namespace

Recording::Recording(const std::string& path, const RecordingOptions& options) : options_(options) {
  openForReading(path, bag_);
  try {
    cameras_ = findCameras(bag_, options.cameras, !options.rig.empty());
    if (cameras_.size() < 2)
      throw std::runtime_error("camera " + cameras_.front().name +
                               " is the only one, at least two are needed");
    options.rig.empty() ? readRig() : useRigFile();
    listStreams();
  } catch (const rosbag::BagException&) {
    throw std::runtime_error(path + " is damaged");
  }
}

void Recording::readRig() {
  tf2::BufferCore buffer;
  readTransforms(bag_, &buffer, &static_transforms_);
  RigCollector collector(namesOf(cameras_), options_.world_frame);
  for (size_t i = 0; i < cameras_.size(); ++i) {
    rosbag::View infos(bag_, rosbag::TopicQuery(cameras_[i].info_topic));
    if (infos.begin() == infos.end()) continue;
    const auto info = messageOf<sensor_msgs::CameraInfo>(*infos.begin());
    if (!info)
      throw std::runtime_error("topic " + cameras_[i].info_topic +
                               " holds a CameraInfo of another md5 sum than this ROS has");
    collector.add(i, *info);
    cameras_[i].frame = info->header.frame_id;
  }
  rig_ = collector.rig(buffer);
}

void Recording::useRigFile() {
  const std::vector<CameraCalibration> used =
      camerasNamed(namesOf(cameras_), markerless_mocap::readRig(options_.rig), options_.rig);
  for (RecordedCamera& camera : cameras_) camera.frame = opticalFrame(camera.name);
  for (const CameraCalibration& camera : used) rig_.emplace_back(camera);
  static_transforms_ = transformsOf(used, rosTime(0), options_.world_frame);
}

void Recording::listStreams() {
  for (size_t i = 0; i < cameras_.size(); ++i) {
    const RecordedCamera& camera = cameras_[i];
    const bool masks =
        !camera.silhouette_topic.empty() && (options_.use_masks || camera.image_topic.empty());
    if (!camera.image_topic.empty()) streams_.push_back({camera.image_topic, i, false, false});
    if (masks) streams_.push_back({camera.silhouette_topic, i, true, false});
    if (options_.use_masks && !masks)
      throw std::runtime_error("camera " + camera.name + " has no silhouettes in the bag");
  }
}

bool Recording::hasMasks() const {
  return std::all_of(cameras_.begin(), cameras_.end(),
                     [](const RecordedCamera& camera) { return !camera.silhouette_topic.empty(); });
}

void Recording::startReading() {
  std::vector<std::string> topics;
  for (size_t i = 0; i < streams_.size(); ++i) {
    topics.push_back(streams_[i].topic);
    stream_of_topic_[streams_[i].topic] = i;
  }
  rosbag::View all(bag_, rosbag::TopicQuery(topics));
  if (all.size() == 0) throw std::runtime_error(bag_.getFileName() + " has no images");
  const ros::Time first = all.getBeginTime() + ros::Duration(options_.start);
  const double seconds = std::min(options_.duration, (all.getEndTime() - first).toSec() + 1.0);
  if (seconds < 0.0)
    throw std::runtime_error("the start is " + numberText(options_.start) +
                             " s, after the end of the recording, which has " +
                             numberText((all.getEndTime() - all.getBeginTime()).toSec()) + " s");
  view_ = std::make_unique<rosbag::View>(bag_, rosbag::TopicQuery(topics), first,
                                         first + ros::Duration(seconds));
  message_ = view_->begin();
  startJoining();
}

void Recording::startJoining() {
  assembler_ = std::make_unique<Assembler>(streams_.size(), assembly());
  lookAhead();
}

void Recording::lookAhead() {
  size_t messages = kLookAhead * streams_.size();
  for (auto message = message_; messages > 0 && message != view_->end(); ++message, --messages)
    try {
      assembler_->foresee(stream_of_topic_.at(message->getTopic()), stampOf(imageOf(*message)));
    } catch (const std::runtime_error&) {  // readImage() tells it
    }
}

AssemblerOptions Recording::assembly() const {
  AssemblerOptions options = offlineAssembly(options_.stamp_tolerance, offsets());
  if (rosbag::View(bag_, rosbag::TopicQuery(kStampsOfCapture)).size() > 0)
    options.out_of_step = OutOfStep::kJoin;
  return options;
}

std::vector<double> Recording::offsets() const {
  std::vector<double> offsets;
  for (const Stream& stream : streams_)
    offsets.push_back(rig_[stream.camera].calibration().time_offset);
  return offsets;
}

std::vector<std::string> Recording::timingRemarks() const {
  std::vector<std::string> remarks;
  if (!assembler_) return remarks;
  const AssemblerOptions options = offlineAssembly(options_.stamp_tolerance, offsets());
  const std::string step = stepRemark(assembler_->tolerance(), options.tolerance);
  if (!step.empty()) remarks.push_back(step);
  for (size_t i = 0; i < streams_.size(); ++i) {
    const StreamTiming timing = assembler_->timing(i);
    const std::string lag = lagRemark(streams_[i].topic, timing, options);
    if (step.empty() && !lag.empty()) remarks.push_back(lag);
    if (timing.left_out > 0)
      remarks.push_back(std::to_string(timing.left_out) + " frame sets lack " + streams_[i].topic +
                        "; in the last, " + missRemark(cameras_[streams_[i].camera].name, timing));
  }
  return remarks;
}

std::optional<RecordedImage> Recording::readImage() {
  try {
    return imageOf(*message_);
  } catch (const std::runtime_error& error) {
    if (messages_read_ == 0) throw;  // nothing of this recording can be read
    if (unreadable_++ == 0) first_unreadable_ = error.what();
    return std::nullopt;
  }
}

void Recording::readMessage() {
  const std::optional<RecordedImage> image = readImage();
  if (!image) {
    ++message_;
    ++messages_read_;
    return;
  }
  for (auto& frame_set :
       assembler_->add(stream_of_topic_.at(message_->getTopic()), stampOf(*image), *image))
    ready_.push_back(std::move(frame_set));
  ++message_;
  ++messages_read_;
}

std::optional<FrameSet> Recording::next() {
  if (!view_) startReading();
  while (ready_.empty() && message_ != view_->end()) readMessage();
  if (ready_.empty())
    for (auto& frame_set : assembler_->flush()) ready_.push_back(std::move(frame_set));
  counts_ = assembler_->counts();
  if (ready_.empty()) return std::nullopt;
  const Assembler::FrameSet frame_set = std::move(ready_.front());
  ready_.pop_front();
  return frameSetOf(frame_set);
}

void Recording::skip(int frame_sets) {
  if (frame_sets <= 0) return;
  if (!view_) startReading();
  for (; frame_sets > 0 && !ready_.empty(); --frame_sets) ready_.pop_front();
  if (frame_sets == 0) return;
  startJoining();
  size_t messages = size_t(frame_sets) * streams_.size();
  for (; messages > 0 && message_ != view_->end(); --messages, ++messages_read_) ++message_;
}

std::vector<size_t> Recording::imagesBefore() {
  if (!view_) startReading();
  std::vector<size_t> counts(cameras_.size(), 0);
  const ros::Time last = view_->getBeginTime() - ros::Duration(0, 1);
  for (const Stream& stream : streams_)
    if (!stream.is_mask)
      counts[stream.camera] =
          rosbag::View(bag_, rosbag::TopicQuery(stream.topic), ros::TIME_MIN, last).size();
  return counts;
}

int Recording::expectedFrameSets() {
  if (!view_) startReading();
  return int(view_->size() / streams_.size());
}

double Recording::fractionRead() const {
  return view_ ? double(messages_read_) / double(view_->size()) : 0.0;
}

void Recording::checkSize(size_t stream, const cv::Mat& pixels) {
  const Camera& camera = rig_[streams_[stream].camera];
  const bool fits = pixels.cols == camera.width() && pixels.rows == camera.height();
  // If the first one differs, the calibration is of another resolution: the run says so and ends.
  if (!fits && streams_[stream].has_fitted)
    throw std::invalid_argument("an image of " + streams_[stream].topic + " is " +
                                std::to_string(pixels.cols) + " x " + std::to_string(pixels.rows) +
                                " pixels, the others " + std::to_string(camera.width()) + " x " +
                                std::to_string(camera.height()));
  streams_[stream].has_fitted = fits;
}

FrameSet Recording::frameSetOf(const Assembler::FrameSet& frame_set) {
  FrameSet out;
  out.stamp_ns = frame_set.stamp_ns;
  out.frames.resize(cameras_.size());
  out.owner = frame_set.items;
  for (size_t i = 0; i < streams_.size(); ++i) {
    if (!frame_set.present[i]) continue;
    CameraFrame& frame = out.frames[streams_[i].camera];
    frame.later_s = frame_set.laterBy(i);
    try {
      const cv::Mat pixels = decoded(frame_set.items[i], streams_[i].is_mask);
      checkSize(i, pixels);
      (streams_[i].is_mask ? frame.mask : frame.image) = pixels;
    } catch (const std::exception& error) {  // of ours or of OpenCV
      if (unreadable_++ == 0) first_unreadable_ = error.what();
    }
  }
  return out;
}

}  // namespace markerless_mocap
