#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "checks/seen_rig.h"
#include "markerless_mocap/camera/camera.h"

namespace markerless_mocap {

/// What is followed of a person: the middle of the silhouette and its uppermost point. Both are
/// nearly the projection of one point of the body in all views.
enum class BodyMark { kCentre, kTop };
constexpr int kBodyMarks = 2;

/// A person in the images of one camera, over time.
struct PersonTrack {
  std::vector<double> seconds;  ///< stamps since a time that all cameras share, ascending
  std::vector<const Outline*> outlines;
  int width = 0, height = 0;  ///< of the images
  double period = 0;          ///< s
};

/// \param start_ns the time that all cameras share
PersonTrack personTrackOf(const SeenCamera& camera, int64_t start_ns);

/// How the images of a track are to be read.
enum class ImageTurn { kNone, kUpsideDown, kMirrored };

/// Directions to a mark in the world, for each outline of a track; none where the border cuts it.
struct Sight {
  std::vector<std::optional<Eigen::Vector2d>> pixels[kBodyMarks];
};
Sight sightOf(const PersonTrack& track, const CameraCalibration& calibration, ImageTurn turn);

/// The last place of a person upwards and downwards in the world, as a camera sees it.
enum class BodyEnd { kUpper, kLower };

/// Whether the next outline after a time ends within the image, not at its border; none if it shows
/// nobody, or there is none soon.
std::optional<bool> endsInside(const PersonTrack& track, const CameraCalibration& calibration,
                               ImageTurn turn, BodyEnd end, double seconds);

/// The pixel at a time, between two images that are not far from each other.
std::optional<Eigen::Vector2d> pixelAt(const PersonTrack& track, const Sight& sight, BodyMark mark,
                                       double seconds);

}  // namespace markerless_mocap
