#include "markerless_mocap/hull/hull_carver.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>
#include <string>

#include "hull/bridging.h"
#include "hull/coloring.h"
#include "hull/components.h"
#include "hull/person_selection.h"
#include "hull/voting.h"

namespace markerless_mocap {
namespace {

constexpr size_t kMaxTableEntries = 512u << 20;
/// Pieces of more than this are several bodies and are not bridged.
constexpr double kMostLitresOfOneBody = 120;

int32_t pixelOffset(const Camera& camera, const Eigen::Vector3d& point) {
  const auto pixel = camera.projectInside(point);
  if (!pixel) return -1;
  const int x = int(std::floor(pixel->x() + 0.5)), y = int(std::floor(pixel->y() + 0.5));
  return y * camera.width() + x;
}

/// The union, sorted.
std::vector<uint32_t> withAll(std::vector<uint32_t> voxels,
                              const std::vector<std::vector<uint32_t>>& pieces) {
  for (const auto& piece : pieces) voxels.insert(voxels.end(), piece.begin(), piece.end());
  std::sort(voxels.begin(), voxels.end());
  voxels.erase(std::unique(voxels.begin(), voxels.end()), voxels.end());
  return voxels;
}

/// Pixel offsets need rows without gaps.
cv::Mat continuous(const cv::Mat& mat) {
  return mat.isContinuous() ? mat : mat.clone();
}

}  // namespace

HullCarver::HullCarver(CameraRig rig, const HullOptions& options)
    : rig_(std::move(rig)), options_(options) {
  options_.validate();
  lattice_ = options_.lattice();
  checkRig();
  buildProjectionTable();
}

void HullCarver::checkRig() const {
  if (rig_.size() < 2 || rig_.size() > 32)
    throw std::invalid_argument("a rig has " + std::to_string(rig_.size()) +
                                " cameras, allowed are 2 to 32");
  std::set<std::string> names;
  for (const Camera& camera : rig_)
    if (!names.insert(camera.name()).second)
      throw std::invalid_argument("two cameras of the rig are named '" + camera.name() + "'");
  if (size_t(options_.min_views) > rig_.size())
    throw std::invalid_argument("visual_hull/min_views is " + std::to_string(options_.min_views) +
                                ", allowed is at most the number of cameras, " +
                                std::to_string(rig_.size()));
  if (rig_.size() * size_t(lattice_.count()) > kMaxTableEntries)
    throw std::invalid_argument("visual_hull has too many voxels for " +
                                std::to_string(rig_.size()) + " cameras (" +
                                std::to_string(lattice_.count()) + ", allowed are " +
                                std::to_string(kMaxTableEntries / rig_.size()) +
                                "): make the volume smaller or the pitch larger");
}

void HullCarver::buildProjectionTable() {
  const uint32_t count = lattice_.count();
  for (const Camera& camera : rig_) {
    std::vector<int32_t>& pixels = pixel_of_voxel_.emplace_back(count);
    tbb::parallel_for(tbb::blocked_range<uint32_t>(0, count),
                      [&](const tbb::blocked_range<uint32_t>& range) {
                        for (uint32_t v = range.begin(); v != range.end(); ++v)
                          pixels[v] = pixelOffset(camera, lattice_.center(v));
                      });
  }
  for (uint32_t v = 0; v < count; ++v)
    if (std::count_if(pixel_of_voxel_.begin(), pixel_of_voxel_.end(),
                      [v](const auto& pixels) { return pixels[v] >= 0; }) >= options_.min_views)
      return;
  throw std::invalid_argument("no voxel of the volume is seen by " +
                              std::to_string(options_.min_views) +
                              " cameras: check volume_min, volume_max and the cameras' poses");
}

void HullCarver::checkViews(const std::vector<HullView>& views) const {
  if (views.size() != rig_.size())
    throw std::invalid_argument("the hull got " + std::to_string(views.size()) +
                                " views for a rig of " + std::to_string(rig_.size()) + " cameras");
  const auto check = [](const Camera& camera, const cv::Mat& mat, bool type_ok, const char* what,
                        const char* types) {
    const std::string subject = std::string(what) + " of camera '" + camera.name() + "' ";
    if (mat.cols != camera.width() || mat.rows != camera.height())
      throw std::invalid_argument(subject + "is " + std::to_string(mat.cols) + " x " +
                                  std::to_string(mat.rows) + " pixels, its calibration says " +
                                  std::to_string(camera.width()) + " x " +
                                  std::to_string(camera.height()));
    if (!type_ok) throw std::invalid_argument(subject + "must be " + types);
  };
  for (size_t c = 0; c < views.size(); ++c) {
    const cv::Mat &mask = views[c].mask, &image = views[c].image;
    if (!mask.empty()) check(rig_[c], mask, mask.type() == CV_8UC1, "mask", "8 bit grey");
    if (!image.empty())
      check(rig_[c], image, image.type() == CV_8UC1 || image.type() == CV_8UC3, "image",
            "8 bit grey or BGR");
  }
}

VisualHull HullCarver::carve(const std::vector<HullView>& views) const {
  checkViews(views);
  VisualHull hull;
  hull.lattice = lattice_;
  const MaskSurvey masks = surveyMasks(rig_, views);
  if (refuseMasks(masks, options_.min_views, &hull)) return hull;

  std::vector<Voter> voters;
  for (size_t c = 0; c < views.size(); ++c)
    if (!views[c].mask.empty())
      voters.push_back({&pixel_of_voxel_[c], continuous(views[c].mask), masks.set_pixels[c]});
  const std::vector<uint32_t> person = selectPerson(carvePieces(voters), options_, masks, &hull);
  describeVoxels(views, person, &hull);
  return hull;
}

std::vector<std::vector<uint32_t>> HullCarver::carvePieces(const std::vector<Voter>& voters) const {
  const double voxel_litres = std::pow(options_.pitch * 10, 3);
  const size_t least = size_t(std::ceil(options_.min_component_litres / voxel_litres));
  const auto isWhole = [&](const auto& pieces) {
    return pieces.size() < 2 || pieces[1].size() < std::max<size_t>(least, 1);
  };
  const auto vote = [&](int more) {  // as many more cameras must see a voxel as may miss it
    return voteForeground(voters, lattice_.count(), options_.min_views + more,
                          options_.missing_votes_allowed + more);
  };
  std::vector<std::vector<uint32_t>> pieces = connectedComponents(lattice_, vote(0));
  double litres = 0;
  for (const auto& piece : pieces) litres += double(piece.size()) * voxel_litres;
  if (litres > kMostLitresOfOneBody) return pieces;
  for (int more = 1; more <= options_.bridging_votes && !isWhole(pieces); ++more) {
    const std::vector<uint32_t> loose = withAll(vote(more), pieces);
    pieces = bridgePieces(lattice_, loose, std::move(pieces), least);
  }
  return pieces;
}

void HullCarver::describeVoxels(const std::vector<HullView>& views,
                                const std::vector<uint32_t>& person, VisualHull* hull) const {
  hull->voxels.resize(person.size());
  std::vector<cv::Mat> images(views.size());
  for (size_t c = 0; c < views.size(); ++c)
    if (!views[c].mask.empty() && !views[c].image.empty()) images[c] = continuous(views[c].image);
  for (size_t i = 0; i < person.size(); ++i) {
    HullVoxel& voxel = hull->voxels[i];
    voxel.index = person[i];
    for (size_t c = 0; c < views.size(); ++c)
      voxel.views += !views[c].mask.empty() && pixel_of_voxel_[c][person[i]] >= 0;
  }
  colorVoxels(lattice_, pixel_of_voxel_, images, options_.color_vote_distance, &hull->voxels);
}

}  // namespace markerless_mocap
