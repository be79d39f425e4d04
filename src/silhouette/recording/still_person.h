#pragma once

#include <opencv2/core/mat.hpp>

#include "silhouette/recording/scene_samples.h"

namespace markerless_mocap {

/// Whether somebody stands or sits in the image, by the shape of their edges; nothing need move.
/// \param image CV_8UC1 or CV_8UC3
bool showsPerson(const cv::Mat& image);

/// Where people are who keep still, so that nothing tells them from furniture but their shape:
/// CV_8UC1 of `samples.image_size`, non-zero inside. A detector finds upright and seated people in
/// some of the samples, and colours their outline; what most of these samples agree on is taken.
/// Furniture of this shape is in it, too.
///
/// Sources: Dalal and Triggs, histograms of oriented gradients for human detection (2005), with the
/// weights that come with OpenCV; Rother et al., GrabCut (2004).
cv::Mat stillPerson(const SceneSamples& samples);

}  // namespace markerless_mocap
