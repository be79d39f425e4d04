#include <tbb/parallel_for.h>

#include <algorithm>
#include <map>
#include <stdexcept>

#include "markerless_mocap/camera/rig_file.h"
#include "ros/camera_conversions.h"
#include "ros/image_conversions.h"
#include "ros/rig_recorder.h"
#include "tools/check/check_recording.h"
#include "tools/common/bag_io.h"
#include "tools/common/foreign_topic.h"
#include "tools/common/progress.h"
#include "tools/common/recorded_cameras.h"
#include "tools/common/recorded_transforms.h"

namespace markerless_mocap {
namespace {

constexpr size_t kBatch = 16;  ///< images of each camera that are decoded together

std::string topicOf(const RecordedCamera& camera) {
  return camera.image_topic.empty() ? camera.silhouette_topic : camera.image_topic;
}

/// A bag's image messages, camera by camera in batches, so that cameras are decoded side by side.
class ImageReader {
 public:
  using Message = rosbag::MessageInstance;
  /// Called with the number of the camera, that of the image, and the message; from one thread for
  /// each camera.
  using Take = std::function<void(size_t, size_t, const Message&)>;

  ImageReader(rosbag::Bag& bag, const std::vector<RecordedCamera>& cameras)
      : counts_(cameras.size(), 0) {
    std::vector<std::string> topics;
    for (size_t i = 0; i < cameras.size(); ++i)
      if (!topicOf(cameras[i]).empty()) {
        topics.push_back(topicOf(cameras[i]));
        camera_of_[topics.back()] = i;
      }
    if (topics.empty()) return;
    view_ = std::make_unique<rosbag::View>(bag, rosbag::TopicQuery(topics));
    for (const Message& message : *view_) ++counts_[camera_of_.at(message.getTopic())];
  }

  bool empty() const { return !view_ || view_->size() == 0; }
  ros::Time begin() const { return view_->getBeginTime(); }
  const std::vector<size_t>& counts() const { return counts_; }

  void readAll(const Take& take, Progress* progress) {
    std::vector<std::vector<Message>> batch(counts_.size());
    std::vector<size_t> done(counts_.size(), 0);
    size_t waiting = 0, read = 0;
    const auto flush = [&] {
      tbb::parallel_for(size_t(0), batch.size(), [&](size_t i) {
        for (const Message& message : batch[i]) take(i, done[i]++, message);
        batch[i].clear();
      });
      waiting = 0;
      progress->update(double(read) / double(view_->size()));
    };
    for (const Message& message : *view_) {
      batch[camera_of_.at(message.getTopic())].push_back(message);
      ++read;
      if (++waiting >= kBatch * batch.size()) flush();
    }
    flush();
  }

 private:
  std::map<std::string, size_t> camera_of_;
  std::vector<size_t> counts_;
  std::unique_ptr<rosbag::View> view_;
};

/// rosbag reads one message at a time.
class MessageLoader {
 public:
  template <class Message>
  boost::shared_ptr<const Message> load(const rosbag::MessageInstance& entry) {
    const std::lock_guard<std::mutex> lock(mutex_);
    return messageOf<Message>(entry);
  }

 private:
  std::mutex mutex_;
};

/// Throws std::runtime_error if the message is damaged, not if its image is.
cv::Mat pixelsOf(const rosbag::MessageInstance& entry, MessageLoader* loader) {
  const auto raw = loader->load<sensor_msgs::Image>(entry);
  const auto jpeg = raw ? nullptr : loader->load<sensor_msgs::CompressedImage>(entry);
  try {
    if (raw) return matFromMessage(*raw);
    if (jpeg) return matFromMessage(*jpeg);
  } catch (const std::exception&) {  // counted when silhouettes are looked for
  }
  return {};
}

bool isEarly(const rosbag::MessageInstance& entry, const ros::Time& begin, double seconds) {
  return (entry.getTime() - begin).toSec() <= seconds;
}

/// As mocap_offline: from the whole recording if somebody is there from the first image on.
std::vector<SharedBackground> learn(const SilhouetteOptions& options, double seconds,
                                    ImageReader* reader, MessageLoader* loader,
                                    Progress* progress) {
  std::vector<RecordingLearner> learners;
  for (const size_t count : reader->counts()) learners.emplace_back(options, int(count));
  std::vector<cv::Size> sizes(learners.size());
  const ros::Time begin = reader->begin();
  reader->readAll(
      [&](size_t camera, size_t, const rosbag::MessageInstance& entry) {
        const bool wanted = learners[camera].wantsNext() && isEarly(entry, begin, seconds);
        cv::Mat image = wanted ? checkedSize(pixelsOf(entry, loader)) : cv::Mat();
        if (sizes[camera].empty()) sizes[camera] = image.size();
        learners[camera].add(image.size() == sizes[camera] ? image : cv::Mat());
      },
      progress);
  return learnBackgrounds(learners);
}

ImageDetail detailOf(const rosbag::MessageInstance& entry, size_t number, size_t count,
                     const ros::Time& begin, double seconds) {
  const size_t stride = std::max<size_t>(1, count / size_t(kPictures));
  return {isEarly(entry, begin, seconds), number % stride == 0};
}

void recordOne(const rosbag::MessageInstance& entry, const ImageDetail& detail,
               MessageLoader* loader, CameraRecorder* recorder) {
  const int64_t received = nanosecondsOf(entry.getTime());
  if (const auto raw = loader->load<sensor_msgs::Image>(entry))
    recorder->add(*raw, received, detail);
  else if (const auto compressed = loader->load<sensor_msgs::CompressedImage>(entry))
    recorder->add(*compressed, received, detail);
  else
    throw std::runtime_error("topic " + entry.getTopic() + " holds " + entry.getDataType() +
                             ", expected are images of this ROS");
}

void readInfos(rosbag::Bag& bag, const std::string& topic, CameraRecorder* recorder) {
  if (topic.empty()) return;
  for (const rosbag::MessageInstance& entry : rosbag::View(bag, rosbag::TopicQuery(topic)))
    if (const auto info = messageOf<sensor_msgs::CameraInfo>(entry))
      recorder->add(*info, nanosecondsOf(entry.getTime()));
}

void useRigFile(const std::string& path, const std::vector<RecordedCamera>& cameras,
                std::vector<CameraRecorder>* recorders) {
  std::vector<std::string> names;
  for (const RecordedCamera& camera : cameras) names.push_back(camera.name);
  const std::vector<CameraCalibration> rig = camerasNamed(names, readRig(path), path);
  for (size_t i = 0; i < rig.size(); ++i) (*recorders)[i].useCalibration(rig[i]);
}

void readImages(const CheckArguments& arguments, const SilhouetteOptions& silhouette,
                const std::vector<RecordedCamera>& cameras, rosbag::Bag& bag,
                std::vector<CameraRecorder>* recorders, std::ostream* notes, bool terminal) {
  ImageReader reader(bag, cameras);
  if (reader.empty()) throw std::runtime_error(bag.getFileName() + " has no images");
  const std::string foreign = foreignTopic<sensor_msgs::Image, sensor_msgs::CompressedImage>(bag);
  if (!foreign.empty()) throw std::runtime_error("not all images can be read" + foreign);
  MessageLoader loader;
  SilhouetteOptions options = silhouette;
  const bool masks = (*recorders).front().seen().masks_only;
  if (canLearnFromRecording(options) && !masks) {
    Progress progress("background", notes, terminal);
    const auto backgrounds = learn(options, arguments.seconds, &reader, &loader, &progress);
    progress.finish();
    for (size_t i = 0; i < backgrounds.size(); ++i)
      if (backgrounds[i]) (*recorders)[i].useBackground(backgrounds[i]);
  }
  Progress progress("images", notes, terminal);
  const ros::Time begin = reader.begin();
  reader.readAll(
      [&](size_t camera, size_t number, const rosbag::MessageInstance& entry) {
        recordOne(entry, detailOf(entry, number, reader.counts()[camera], begin, arguments.seconds),
                  &loader, &(*recorders)[camera]);
      },
      &progress);
  progress.finish();
}

}  // namespace

SeenRig readSeenRig(const CheckArguments& arguments, const PipelineOptions& pipeline,
                    std::ostream* notes, bool terminal) {
  rosbag::Bag bag;
  openForReading(arguments.bag, bag);
  const std::vector<RecordedCamera> cameras = listCameras(bag, arguments.cameras);
  SilhouetteOptions silhouette = pipeline.silhouette;
  if (canLearnFromRecording(silhouette)) silhouette.background = "first_images";
  std::vector<CameraRecorder> recorders;
  for (const RecordedCamera& camera : cameras) {
    recorders.emplace_back(camera.name, silhouette, camera.image_topic.empty());
    readInfos(bag, camera.info_topic, &recorders.back());
  }
  if (!arguments.rig.empty()) useRigFile(arguments.rig, cameras, &recorders);
  readImages(arguments, pipeline.silhouette, cameras, bag, &recorders, notes, terminal);
  tf2::BufferCore tf;
  readTransforms(bag, &tf, nullptr);
  SeenRig rig;
  rig.world_frame = arguments.world_frame;
  for (const CameraRecorder& recorder : recorders)
    rig.cameras.push_back(recorder.seen(tf, arguments.world_frame));
  if (pipeline.hull.volume == "explicit")
    rig.volume = {pipeline.hull.volume_min, pipeline.hull.volume_max};
  return rig;
}

}  // namespace markerless_mocap
