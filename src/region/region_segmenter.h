#pragma once

#include <Eigen/Core>
#include <memory>
#include <opencv2/core/mat.hpp>
#include <vector>

namespace markerless_mocap {

/// A round cone of the body, projected into a view: the convex hull of two disks.
struct ProjectedCone {
  Eigen::Vector2f a, b;      ///< centres of the disks, samples
  float radius_a, radius_b;  ///< samples
  float depth_a, depth_b;    ///< metres from the camera plane
  int part;                  ///< part of the body, from 0
};

/// The body, projected into one view.
struct ProjectedBody {
  std::vector<ProjectedCone> cones;
  float sigma = 0;  ///< expected error of the outline, samples
};

/// The person as found in a view.
struct RegionMask {
  cv::Mat mask;  ///< CV_8UC1, 0 | 255
  /// By part of the body: samples that colours show as person, those of them whose background was
  /// known, and those of these that background subtraction sees as person, too.
  std::vector<int> colored, known, agreeing;
  int silhouette = 0;  ///< samples that background subtraction sees as person, in the whole view
};

/// Separates a person from what is behind them by colour, where the background is not known. A
/// predicted pose says where to look; colour histograms of each part of the body and of its
/// surroundings decide, and a graph cut makes the borders follow the edges of the image.
/// One object per camera: it learns the colours of the person in that camera. Not thread-safe.
///
/// Sources: Tjaden et al., region-based pose tracking with temporally consistent local histograms
/// (2019); Boykov and Jolly, interactive graph cuts (2001).
class RegionSegmenter {
 public:
  /// \param parts number of parts of the body, at least 1
  explicit RegionSegmenter(int parts);
  ~RegionSegmenter();
  RegionSegmenter(RegionSegmenter&&) noexcept;
  RegionSegmenter& operator=(RegionSegmenter&&) noexcept;

  /// Makes the table of colours that all share, which takes 0.15 s; else the first image does.
  static void prepare();

  /// Forgets the colours.
  void reset();

  /// Learns colours from a pose that is believed. The first time they are taken over, later they
  /// are mixed with what was known.
  /// \param image CV_8UC3 BGR, samples of the whole image
  void learn(const cv::Mat& image, const ProjectedBody& body);

  /// kElsewhere: limbs may be elsewhere than in the pose. What background subtraction sees as
  /// person is then taken, too, where it is attached to what colours show.
  enum class Limbs { kElsewhere, kWhereTheyAre };

  /// Finds the person near the projected body. Colours that were never learned are taken from the
  /// image itself, inside and outside the projected body.
  /// \param image CV_8UC3 BGR, samples of the whole image
  /// \param known CV_8UC1 of the same size: 0 background, 255 person, 128 unknown; or empty
  /// \return a mask of the same size; all 0 if the body is outside the image
  RegionMask segment(const cv::Mat& image, const ProjectedBody& body, const cv::Mat& known,
                     Limbs limbs = Limbs::kElsewhere) const;

  /// Where else the person may be: samples near the body that background subtraction sees as
  /// person, or that have colours of the person where the background is not known.
  /// \param reach distance from the projected body, samples
  /// \return CV_8UC1, 0 | 255
  cv::Mat candidates(const cv::Mat& image, const ProjectedBody& body, const cv::Mat& known,
                     float reach) const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace markerless_mocap
