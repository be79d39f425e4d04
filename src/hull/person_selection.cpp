#include "hull/person_selection.h"

#include <cmath>
#include <opencv2/core.hpp>

namespace markerless_mocap {
namespace {

/// A silhouette that covers more of its image shows no outline to carve with.
constexpr double kFullMaskShare = 0.95;
/// A second component is a second body when it is at least this large.
constexpr double kSecondBodyShare = 0.4;
constexpr double kSecondBodyLitres = 15.0;

std::string oneDecimal(double value) {
  const long tenths = std::lround(value * 10);
  return std::to_string(tenths / 10) + "." + std::to_string(tenths % 10);
}

void appendName(const std::string& name, std::string* names) {
  *names += (names->empty() ? "'" : ", '") + name + "'";
}

}  // namespace

MaskSurvey surveyMasks(const CameraRig& rig, const std::vector<HullView>& views) {
  MaskSurvey result;
  result.set_pixels.resize(views.size());
  for (size_t c = 0; c < views.size(); ++c) {
    if (views[c].mask.empty()) continue;
    ++result.present;
    const size_t set = cv::countNonZero(views[c].mask);
    result.set_pixels[c] = set;
    if (set == 0) {
      ++result.empty;
      appendName(rig[c].name(), &result.empty_names);
    } else if (double(set) >= kFullMaskShare * double(views[c].mask.total())) {
      appendName(rig[c].name(), &result.full_names);
    }
  }
  return result;
}

bool refuseMasks(const MaskSurvey& masks, int min_views, VisualHull* hull) {
  if (masks.present < size_t(min_views)) {
    hull->status = HullStatus::kNoCameras;
    hull->reason = std::to_string(masks.present) + " of " +
                   std::to_string(masks.set_pixels.size()) + " cameras are present, " +
                   std::to_string(min_views) + " are needed";
  } else if (masks.empty == masks.present) {
    hull->status = HullStatus::kEmptyMasks;
    hull->reason = "the masks of all " + std::to_string(masks.present) + " cameras are empty";
  } else if (!masks.full_names.empty()) {
    hull->status = HullStatus::kFullMask;
    hull->reason =
        "the mask of " + masks.full_names + " is full: nobody stands out from the background there";
  } else {
    return false;
  }
  return true;
}

std::vector<uint32_t> selectPerson(std::vector<std::vector<uint32_t>> components,
                                   const HullOptions& options, const MaskSurvey& masks,
                                   VisualHull* hull) {
  const double voxel_litres = std::pow(options.pitch * 10, 3);
  for (const auto& component : components)
    hull->component_litres.push_back(double(component.size()) * voxel_litres);
  const std::vector<double>& litres = hull->component_litres;
  if (litres.empty() || litres[0] < options.min_component_litres) {
    hull->status = HullStatus::kNobody;
    hull->reason = litres.empty() ? "the silhouettes meet nowhere in the volume"
                                  : "the largest component has " + oneDecimal(litres[0]) +
                                        " litres, a body has at least " +
                                        oneDecimal(options.min_component_litres);
    if (!masks.empty_names.empty())
      hull->reason += "; the mask of " + masks.empty_names + " is empty";
    return {};
  }
  if (litres.size() > 1 && litres[1] >= kSecondBodyShare * litres[0] &&
      litres[1] >= kSecondBodyLitres) {
    hull->status = HullStatus::kSeveralBodies;
    hull->reason = "there are several bodies: components of " + oneDecimal(litres[0]) + " and " +
                   oneDecimal(litres[1]) + " litres";
    return {};
  }
  hull->status = HullStatus::kOk;
  return std::move(components[0]);
}

}  // namespace markerless_mocap
