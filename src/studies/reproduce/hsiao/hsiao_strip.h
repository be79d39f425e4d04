#pragma once

#include "evaluation/body_overlay.h"
#include "studies/reproduce/hsiao/hsiao_film.h"
#include "studies/reproduce/hsiao/voxel_drawing.h"

namespace markerless_mocap {

constexpr int kStripWidth = 150, kStripHeight = 200;  ///< of one picture in a strip, px

/// The part of a camera's image with the hull, in the shape of a strip's picture.
cv::Mat personImage(const Camera& camera, const cv::Mat& image, const VisualHull& hull);
/// A view of the person from the side of a camera.
BodyView viewOf(const VisualHull& hull, const Camera& camera);
cv::Mat hullPicture(const BodyView& view, const VisualHull& hull);
cv::Mat partsPicture(const BodyView& view, const VisualHull& hull, const BodyParts& parts);
/// Part curves in their colours; the model's segments over them in black, if there is a pose.
cv::Mat curvesPicture(const BodyView& view, const PipelineResult& now);
/// The person with the body drawn over it.
cv::Mat bodyPicture(const Camera& camera, const cv::Mat& image, const PipelineResult& now);

/// One column of a film strip as in Figures 4-2 to 4-10: image, hull, parts, curves with the fitted
/// model, body.
std::vector<cv::Mat> stripColumn(const Camera& camera, const cv::Mat& image,
                                 const PipelineResult& now);

}  // namespace markerless_mocap
