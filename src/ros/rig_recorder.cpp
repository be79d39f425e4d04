#include "ros/rig_recorder.h"

#include <opencv2/imgproc.hpp>
#include <string_view>

#include "ros/camera_conversions.h"
#include "ros/image_conversions.h"

namespace markerless_mocap {
namespace {

uint64_t fingerprintOf(const std::vector<uint8_t>& bytes) {
  return std::hash<std::string_view>()({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

SeenInfo infoOf(const std::string& name, const sensor_msgs::CameraInfo& message,
                int64_t received_ns) {
  SeenInfo info;
  info.received_ns = received_ns;
  info.width = int(message.width);
  info.height = int(message.height);
  info.K = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(message.K.data());
  info.D = message.D;
  info.lens = lensTypeOf(message.distortion_model);
  info.frame = message.header.frame_id;
  geometry_msgs::Transform identity;
  identity.rotation.w = 1;
  if (!info.K.isZero() && info.width > 0 && info.height > 0) try {
      calibrationFromMessage(name, message, identity);
    } catch (const std::invalid_argument& error) {
      info.problem = error.what();
    }
  return info;
}

bool isSame(const SeenInfo& a, const SeenInfo& b) {
  return a.width == b.width && a.height == b.height && a.K == b.K && a.D == b.D &&
         a.lens == b.lens && a.frame == b.frame && a.problem == b.problem;
}

cv::Mat scaledTo(const cv::Mat& image, int width) {
  cv::Mat small;
  const int height = std::max(1, int(std::lround(double(image.rows) * width / image.cols)));
  cv::resize(image, small, {width, height}, 0, 0, cv::INTER_AREA);
  return small;
}

cv::Mat inColor(const cv::Mat& image) {
  cv::Mat color = image;
  if (image.channels() == 1) cv::cvtColor(image, color, cv::COLOR_GRAY2BGR);
  return color;
}

cv::Mat inGrey(const cv::Mat& image) {
  cv::Mat grey = image;
  if (image.channels() == 3) cv::cvtColor(image, grey, cv::COLOR_BGR2GRAY);
  return grey.isContinuous() && grey.data != image.data ? grey : grey.clone();
}

/// Where the transform is, or a sentence why there is none.
void lookUp(const tf2::BufferCore& tf, const std::string& world, SeenCamera* camera) {
  if (camera->infos.empty()) return;
  const std::string& frame = camera->infos.front().frame;
  if (frame.empty()) {
    camera->pose_problem = "camera_info has an empty frame_id";
    return;
  }
  std::string why;
  if (!tf.canTransform(world, frame, ros::Time(0), &why)) {
    camera->pose_problem = "tf does not connect " + frame + " to " + world;
    return;
  }
  const geometry_msgs::Transform found = tf.lookupTransform(world, frame, ros::Time(0)).transform;
  sensor_msgs::CameraInfo sound;  // so that the transform alone can be at fault
  sound.width = sound.height = 100;
  sound.K = {100, 0, 50, 0, 100, 50, 0, 0, 1};
  try {
    camera->T_world_camera = calibrationFromMessage(camera->name, sound, found).T_world_camera;
  } catch (const std::invalid_argument& error) {
    camera->pose_problem = error.what();
  }
}

}  // namespace

cv::Mat checkedSize(const cv::Mat& image) {
  return image.cols > kPictureWidth ? scaledTo(image, kPictureWidth) : image;
}

CameraRecorder::CameraRecorder(const std::string& name, const SilhouetteOptions& silhouette,
                               bool masks)
    : extractor_(silhouette) {
  seen_.name = name;
  seen_.masks_only = masks;
}

void CameraRecorder::useBackground(const SharedBackground& background) {
  extractor_.useBackground(background);
}

void CameraRecorder::add(const sensor_msgs::CameraInfo& message, int64_t received_ns) {
  if (has_rig_file_) return;
  SeenInfo info = infoOf(seen_.name, message, received_ns);
  if (seen_.infos.empty() || !isSame(seen_.infos.back(), info))
    seen_.infos.push_back(std::move(info));
}

void CameraRecorder::useCalibration(const CameraCalibration& calibration) {
  has_rig_file_ = true;
  SeenInfo info;
  info.width = calibration.width;
  info.height = calibration.height;
  info.K = calibration.K;
  info.D = calibration.D;
  info.lens = calibration.lens;
  info.time_offset = calibration.time_offset;
  seen_.infos = {info};
  seen_.T_world_camera = calibration.T_world_camera;
}

void CameraRecorder::add(const sensor_msgs::Image& image, int64_t received_ns,
                         const ImageDetail& detail) {
  SeenImage seen;
  seen.stamp_ns = nanosecondsOf(image.header.stamp);
  seen.received_ns = received_ns;
  seen.width = int(image.width);
  seen.height = int(image.height);
  seen.fingerprint = fingerprintOf(image.data);
  keep(std::move(seen), detail,
       [&] { return seen_.masks_only ? maskFromMessage(image) : sharedMatFromMessage(image); });
}

void CameraRecorder::add(const sensor_msgs::CompressedImage& image, int64_t received_ns,
                         const ImageDetail& detail) {
  SeenImage seen;
  seen.stamp_ns = nanosecondsOf(image.header.stamp);
  seen.received_ns = received_ns;
  seen.fingerprint = fingerprintOf(image.data);
  keep(std::move(seen), detail, [&] { return matFromMessage(image); });
}

template <class Decode>
void CameraRecorder::keep(SeenImage seen, const ImageDetail& detail, const Decode& decode) {
  if (detail.pixels || detail.picture) {
    try {
      addPixels(decode(), detail, &seen);
    } catch (const std::invalid_argument&) {
      ++seen_.unreadable;
    }
  }
  seen_.images.push_back(std::move(seen));
}

void CameraRecorder::addPixels(const cv::Mat& image, const ImageDetail& detail, SeenImage* seen) {
  seen->width = image.cols;
  seen->height = image.rows;
  const cv::Mat small = checkedSize(image);
  if (detail.picture && !seen_.masks_only)
    seen_.pictures.push_back({seen->stamp_ns, inGrey(small)});
  if (!detail.pixels) return;
  if (!seen_.masks_only) seen->colors = scaledTo(inColor(small), kColorsWidth);
  findOutline(small, seen);
}

void CameraRecorder::findOutline(const cv::Mat& small, SeenImage* seen) {
  if (seen_.masks_only) {
    seen->outline = outlineOf(small, seen->width, seen->height);
    return;
  }
  if (mask_size_.empty()) mask_size_ = small.size();
  if (small.size() != mask_size_) return;
  const SilhouetteResult result = extractor_.update(small);
  if (result.state != SilhouetteState::kLearning)
    seen->outline = outlineOf(result.mask, seen->width, seen->height);
}

SeenCamera CameraRecorder::seen(const tf2::BufferCore& tf, const std::string& world_frame) const {
  SeenCamera camera = seen_;
  if (!has_rig_file_) lookUp(tf, world_frame, &camera);
  return camera;
}

void CameraRecorder::forgetBefore(int64_t received_ns) {
  const auto old = [&](const SeenImage& image) { return image.received_ns < received_ns; };
  auto& images = seen_.images;
  images.erase(std::remove_if(images.begin(), images.end(), old), images.end());
  auto& pictures = seen_.pictures;
  if (pictures.size() > size_t(kPictures)) pictures.erase(pictures.begin());
  auto& infos = seen_.infos;
  while (infos.size() > 1 && infos[1].received_ns < received_ns) infos.erase(infos.begin());
}

}  // namespace markerless_mocap
