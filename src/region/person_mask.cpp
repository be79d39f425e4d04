#include "markerless_mocap/region/person_mask.h"

#include <array>
#include <opencv2/core.hpp>
#include <stdexcept>
#include <vector>

#include "markerless_mocap/products/silhouette_mask.h"
#include "region/body_drawing.h"
#include "region/region_view.h"
#include "region/things_beside.h"
#include "tracking/part_of_joint.h"

namespace markerless_mocap {
namespace {

constexpr double kOutlineError_m = 0.03;  // of a fitted body
constexpr double kReach_m = 0.1;          // from its outline, for clothes and hair
// Of a link, by the silhouette; one that is shown less may be hidden.
constexpr double kMinShown = 0.5;

/// The body with its links as parts, as colours differ along a limb. Those without a shape are
/// parts, too, but empty.
PlacedBody placedBody(const BodyModel& model, const BodyPose& pose) {
  LinkPoses T_world_link;
  model.forwardKinematics(pose.T_world_body, pose.angles, T_world_link);
  PlacedBody out{{}, pose.T_world_body.translation(), int(model.links().size())};
  for (const RoundCone& cone : model.shape()) {
    const Eigen::Isometry3d& T = T_world_link[size_t(cone.link)];
    out.cones.push_back({T * cone.a, T * cone.b, cone.radius_a, cone.radius_b, cone.link});
  }
  return out;
}

/// The samples of those links of which a mask shows less than half: CV_8UC1 in drawing.box, 0 or
/// 255. \param mask in drawing.box
cv::Mat hardlyShown(const BodyDrawing& drawing, const cv::Mat& mask) {
  std::array<int, BodyDrawing::kNoPart + 1> all{}, shown{};
  for (int y = 0; y < mask.rows; ++y)
    for (int x = 0; x < mask.cols; ++x) {
      const uchar part = drawing.part.at<uchar>(y, x);
      ++all[part];
      shown[part] += mask.at<uchar>(y, x) != kBackgroundPixel;
    }
  cv::Mat hidden = drawing.distance <= 0;
  for (int y = 0; y < mask.rows; ++y)
    for (int x = 0; x < mask.cols; ++x) {
      const uchar part = drawing.part.at<uchar>(y, x);
      if (shown[part] >= kMinShown * all[part]) hidden.at<uchar>(y, x) = 0;
    }
  return hidden;
}

/// The samples of limbs that no view shows well: CV_8UC1 in drawing.box, 0 or 255.
cv::Mat unseenLimbs(const BodyDrawing& drawing, const BodyModel& model, const BodyPose& pose) {
  cv::Mat unseen = cv::Mat::zeros(drawing.part.size(), CV_8UC1);
  for (int link = 0; link < int(model.links().size()); ++link)
    if (!pose.part_seen[size_t(partOfLink(model, link))]) unseen |= drawing.part == link;
  return unseen;
}

/// What silhouette and colours show, everywhere in the view.
cv::Mat seen(const RegionView& view, const ProjectedBody& at, int parts, const cv::Mat& mask) {
  if (view.colors.empty() || !isUnknownNear(at, view.known)) return mask;
  const RegionSegmenter segmenter(parts);
  const RegionMask found =
      segmenter.segment(view.colors, at, view.known, RegionSegmenter::Limbs::kWhereTheyAre);
  return enlarged(found.mask, view.step, mask.size());
}

}  // namespace

cv::Mat personMask(const Camera& camera, const BodyModel& model, const BodyPose& pose,
                   const cv::Mat& silhouette, const cv::Mat& image) {
  if (pose.status == PoseStatus::kLost)
    throw std::invalid_argument("a mask of the person needs a pose that is not lost");
  if (silhouette.type() != CV_8UC1 ||
      silhouette.size() != cv::Size(camera.width(), camera.height()))
    throw std::invalid_argument("the silhouette of camera '" + camera.name() +
                                "' must have one channel of 8 bits and the size of its image");
  const bool has_colors = image.type() == CV_8UC3 && image.size() == silhouette.size();
  const cv::Mat colors = has_colors ? image : cv::Mat();
  const PlacedBody body = placedBody(model, pose);
  const cv::Mat mask =
      withoutThingsBeside({silhouette}, {true}, CameraRig{camera}, body, 0.0).masks[0];
  const RegionView view = regionView(colors, mask);
  const ProjectedBody at = projectedBody(camera, view.step, body, kOutlineError_m);
  const float samples_per_metre = samplesPerMetre(camera, view.step, body.pelvis);
  const float reach = float(kReach_m) * samples_per_metre;
  const BodyDrawing drawing = drawBody(at, body.parts, view.known.size(), reach + 1);
  cv::Mat out = cv::Mat::zeros(mask.size(), CV_8UC1);
  if (drawing.box.area() == 0) return out;
  const auto in_image = [&](const cv::Mat& in_box) {
    cv::Mat samples = cv::Mat::zeros(view.known.size(), CV_8UC1);
    in_box.copyTo(samples(drawing.box));
    return enlarged(samples, view.step, mask.size());
  };
  const cv::Mat person = seen(view, at, body.parts, mask);
  person.copyTo(out, in_image(drawing.distance <= reach));
  const cv::Mat hidden = hardlyShown(drawing, regionView({}, silhouette).known(drawing.box));
  const cv::Mat core = drawing.distance <= float(-kOutlineError_m) * samples_per_metre;
  out.setTo(kPersonPixel, in_image(core & ~hidden));
  out.setTo(kBackgroundPixel, in_image(hidden & unseenLimbs(drawing, model, pose)) &
                                  (silhouette == kBackgroundPixel));
  return out;
}

}  // namespace markerless_mocap
