#pragma once

#include <functional>
#include <opencv2/imgproc.hpp>
#include <ostream>
#include <random>
#include <string>
#include <vector>

#include "checks/seen_rig.h"

namespace markerless_mocap {

/// One fault: its name in docs/checking.md, the camera that it is of, and how it is made.
struct Fault {
  std::string what, camera;
  std::function<void(SeenRig*)> make;
};

inline void PrintTo(const Fault& fault, std::ostream* out) {
  *out << fault.what;
}

inline Eigen::Isometry3d& poseOf(SeenRig* rig, size_t camera) {
  return *rig->cameras[camera].T_world_camera;
}

inline void forAllPoses(SeenRig* rig, const std::function<void(Eigen::Isometry3d&)>& change) {
  for (SeenCamera& camera : rig->cameras) change(*camera.T_world_camera);
}

inline void shiftStamps(SeenCamera* camera, const std::function<double(double)>& by) {
  const int64_t first = camera->images.front().stamp_ns;
  for (SeenImage& image : camera->images) {
    const double seconds = by(1e-9 * double(image.stamp_ns - first));
    image.stamp_ns += std::llround(1e9 * seconds);
    image.received_ns = image.stamp_ns;
  }
}

inline void multiplyLight(SeenCamera* camera, const std::function<cv::Scalar(double)>& gain) {
  for (size_t i = 0; i < camera->images.size(); ++i) {
    SeenImage& image = camera->images[i];
    image.colors = image.colors.clone();
    cv::multiply(image.colors, gain(double(i) / double(camera->images.size())), image.colors);
  }
}

inline void changePictures(SeenCamera* camera, const std::function<cv::Mat(const cv::Mat&)>& change,
                           size_t from = 0) {
  for (size_t i = from; i < camera->pictures.size(); ++i)
    camera->pictures[i].grey = change(camera->pictures[i].grey);
}

inline void mirrorOutlines(SeenCamera* camera, bool upside_down) {
  for (SeenImage& image : camera->images) {
    const auto turned = [&](const Eigen::Vector2d& p) {
      return Eigen::Vector2d(image.width - 1 - p.x(),
                             upside_down ? image.height - 1 - p.y() : p.y());
    };
    for (Eigen::Vector2d& corner : image.outline->hull) corner = turned(corner);
    image.outline->centre = turned(image.outline->centre);
  }
}

/// What furniture and other people do to silhouettes: each camera's wanders by itself.
inline void spoilOutlines(SeenCamera* camera, unsigned seed) {
  constexpr double kReach = 60, kStart = 20, kStep = 2;  // px
  std::mt19937 random(seed);
  std::normal_distribution<> step(0, kStep);
  std::uniform_real_distribution<> start(-kStart, kStart);
  Eigen::Vector2d by(start(random), start(random));
  for (SeenImage& image : camera->images) {
    by += Eigen::Vector2d(step(random), step(random));
    by = by.cwiseMax(-kReach).cwiseMin(kReach);
    for (Eigen::Vector2d& corner : image.outline->hull) corner += by;
    image.outline->centre += by;
  }
}

inline Eigen::Matrix3d turnedBy(double degrees, const Eigen::Vector3d& axis) {
  return Eigen::AngleAxisd(degrees * M_PI / 180, axis).toRotationMatrix();
}

inline cv::Scalar grey(double gain) {
  return cv::Scalar::all(gain);
}

inline std::vector<Fault> messageFaults() {
  return {
      {"camera_info_missing", "cam1", [](SeenRig* r) { r->cameras[1].infos.clear(); }},
      {"camera_info_zero", "cam2", [](SeenRig* r) { r->cameras[2].infos[0].K.setZero(); }},
      {"camera_info_unusable", "cam2",
       [](SeenRig* r) { r->cameras[2].infos[0].problem = "camera_info of cam2 has binning"; }},
      {"camera_info_size", "cam0",
       [](SeenRig* r) {
         r->cameras[0].infos[0].width = 640;
         r->cameras[0].infos[0].height = 480;
         r->cameras[0].infos[0].K.topRows(2) *= 2;
       }},
      {"camera_info_changes", "cam3",
       [](SeenRig* r) {
         r->cameras[3].infos.push_back(r->cameras[3].infos[0]);
         r->cameras[3].infos[1].K(0, 0) *= 1.05;
       }},
      {"camera_info_implausible", "cam3",
       [](SeenRig* r) { r->cameras[3].infos[0].K.topRows(2) *= 4; }},
      {"image_size_changes", "cam1",
       [](SeenRig* r) {
         for (size_t i = 60; i < r->cameras[1].images.size(); ++i)
           r->cameras[1].images[i].width = 160;
       }},
      {"images_missing", "cam1", [](SeenRig* r) { r->cameras[1].images.clear(); }},
      {"images_unreadable", "cam1", [](SeenRig* r) { r->cameras[1].unreadable = 7; }},
      {"tf_missing", "cam1", [](SeenRig* r) { r->cameras[1].T_world_camera.reset(); }},
  };
}

inline std::vector<Fault> geometryFaults() {
  return {
      {"units_not_metres", "",
       [](SeenRig* r) { forAllPoses(r, [](auto& pose) { pose.translation() *= 1000; }); }},
      {"world_z_down", "",
       [](SeenRig* r) {
         forAllPoses(r, [](auto& pose) { pose = turnedBy(180, Eigen::Vector3d::UnitX()) * pose; });
       }},
      {"world_z_not_up", "",
       [](SeenRig* r) {
         forAllPoses(r, [](auto& pose) { pose = turnedBy(-90, Eigen::Vector3d::UnitX()) * pose; });
       }},
      {"poses_identical", "cam0, cam1", [](SeenRig* r) { poseOf(r, 0) = poseOf(r, 1); }},
      {"no_common_volume", "cam2",
       [](SeenRig* r) {
         poseOf(r, 2).rotate(turnedBy(180, Eigen::Vector3d::UnitY()));
         for (SeenImage& image : r->cameras[2].images) image.outline->hull.clear();
       }},
      {"rotation_inverted", "",
       [](SeenRig* r) {
         forAllPoses(r, [](auto& pose) { pose.linear() = pose.linear().transpose().eval(); });
       }},
      {"rotation_inverted", "cam1",
       [](SeenRig* r) { poseOf(r, 1).linear() = poseOf(r, 1).linear().transpose().eval(); }},
      {"pose_inverted", "",
       [](SeenRig* r) { forAllPoses(r, [](auto& pose) { pose = pose.inverse(); }); }},
      {"translation_inverted", "",
       [](SeenRig* r) {
         forAllPoses(r, [](auto& pose) { pose.translation() = pose.inverse().translation(); });
       }},
      {"axes_not_optical", "",
       [](SeenRig* r) {
         Eigen::Matrix3d optical_of_body;
         optical_of_body << 0, -1, 0, 0, 0, -1, 1, 0, 0;
         forAllPoses(r, [&](auto& pose) { pose.linear() = pose.linear() * optical_of_body; });
       }},
      {"cameras_exchanged", "cam0, cam1",
       [](SeenRig* r) { std::swap(r->cameras[0].images, r->cameras[1].images); }},
      {"camera_turned", "cam3",
       [](SeenRig* r) { poseOf(r, 3).rotate(turnedBy(2.5, Eigen::Vector3d::UnitY())); }},
      {"image_upside_down", "cam1", [](SeenRig* r) { mirrorOutlines(&r->cameras[1], true); }},
      {"image_mirrored", "cam1", [](SeenRig* r) { mirrorOutlines(&r->cameras[1], false); }},
      {"focal_length_wrong", "cam2",
       [](SeenRig* r) { r->cameras[2].infos[0].K.topLeftCorner(2, 2) *= 1.3; }},
      {"volume_cuts_person", "",
       [](SeenRig* r) {
         r->volume = {Eigen::Vector3d(-0.7, -0.7, 0), Eigen::Vector3d(0.7, 0.7, 2.2)};
       }},
  };
}

inline std::vector<Fault> timeFaults() {
  return {
      {"time_offset", "cam1",
       [](SeenRig* r) { shiftStamps(&r->cameras[1], [](double) { return 0.11; }); }},
      {"clock_drifts", "cam2",
       [](SeenRig* r) { shiftStamps(&r->cameras[2], [](double s) { return 0.015 * s; }); }},
      {"clocks_apart", "cam0",
       [](SeenRig* r) { shiftStamps(&r->cameras[0], [](double) { return 3600.0; }); }},
      {"stamps_of_reception", "cam3",
       [](SeenRig* r) {
         std::mt19937 random(1);
         std::normal_distribution<> late(0.02, 0.012);
         shiftStamps(&r->cameras[3], [&](double) { return late(random); });
       }},
      {"stamps_jitter", "cam3",
       [](SeenRig* r) {
         std::mt19937 random(1);
         std::normal_distribution<> late(0, 0.012);
         for (SeenImage& image : r->cameras[3].images)
           image.stamp_ns += std::llround(1e9 * late(random));
       }},
      {"stamps_zero", "cam0",
       [](SeenRig* r) {
         for (SeenImage& image : r->cameras[0].images) image.stamp_ns = 0;
       }},
      {"stamps_jump_back", "cam0",
       [](SeenRig* r) {
         for (size_t i = 70; i < r->cameras[0].images.size(); ++i)
           r->cameras[0].images[i].stamp_ns -= 2'000'000'000;
       }},
      {"stamps_doubled", "cam0",
       [](SeenRig* r) { r->cameras[0].images[9].stamp_ns = r->cameras[0].images[8].stamp_ns; }},
      {"images_dropped", "cam0",
       [](SeenRig* r) {
         auto& images = r->cameras[0].images;
         for (size_t i = 100; i > 10; i -= 12) images.erase(images.begin() + std::ptrdiff_t(i));
       }},
      {"rate_differs", "cam0",
       [](SeenRig* r) {
         auto& images = r->cameras[0].images;
         for (size_t i = images.size() - 1; i > 1; i -= 2)
           images.erase(images.begin() + std::ptrdiff_t(i));
       }},
      {"images_frozen", "cam2",
       [](SeenRig* r) {
         for (size_t i = 60; i < 90; ++i) r->cameras[2].images[i].fingerprint = 1;
       }},
  };
}

inline std::vector<Fault> pictureFaults() {
  return {
      {"light_flickers", "cam1",
       [](SeenRig* r) {
         multiplyLight(&r->cameras[1],
                       [](double at) { return grey(1 + 0.08 * std::sin(300 * at)); });
       }},
      {"exposure_wanders", "cam1",
       [](SeenRig* r) {
         multiplyLight(&r->cameras[1], [](double at) { return grey(1 + 0.25 * at * at); });
       }},
      {"white_balance_wanders", "cam1",
       [](SeenRig* r) {
         multiplyLight(&r->cameras[1], [](double at) { return cv::Scalar(1 + 0.1 * at, 1, 1); });
       }},
      {"light_switched", "",
       [](SeenRig* r) {
         for (SeenCamera& camera : r->cameras)
           multiplyLight(&camera, [](double at) { return grey(at < 0.4 ? 1.0 : 0.6); });
       }},
      {"image_dark", "cam0",
       [](SeenRig* r) {
         changePictures(&r->cameras[0], [](const cv::Mat& m) { return cv::Mat(0.12 * m); });
       }},
      {"image_overexposed", "cam0",
       [](SeenRig* r) {
         changePictures(&r->cameras[0], [](const cv::Mat& m) { return cv::Mat(2.6 * m); });
       }},
      {"image_covered", "cam0",
       [](SeenRig* r) {
         changePictures(
             &r->cameras[0], [](const cv::Mat& m) { return cv::Mat(m.size(), CV_8UC1, grey(30)); },
             10);
       }},
      {"image_blurred", "cam0",
       [](SeenRig* r) {
         changePictures(&r->cameras[0], [](const cv::Mat& m) {
           cv::Mat out;
           cv::GaussianBlur(m, out, {}, 5.0);
           return out;
         });
       }},
      {"camera_moved", "cam2",
       [](SeenRig* r) {
         changePictures(
             &r->cameras[2],
             [](const cv::Mat& m) {
               cv::Mat out;
               const cv::Mat shift = (cv::Mat_<double>(2, 3) << 1, 0, 5.0, 0, 1, 3.0);
               cv::warpAffine(m, out, shift, m.size(), cv::INTER_LINEAR, cv::BORDER_REPLICATE);
               return out;
             },
             12);
       }},
  };
}

}  // namespace markerless_mocap
