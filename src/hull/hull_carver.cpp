#include "markerless_mocap/hull/hull_carver.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>

#include "hull/color/coloring.h"
#include "hull/selection/camera_faults.h"
#include "hull/selection/sure_views.h"
#include "hull/selection/unknown_views.h"

namespace markerless_mocap {
namespace {

constexpr size_t kMaxTableEntries = 512u << 20;
constexpr int kMaxPixels = 65535;  // along an edge of an image

void checkRig(const CameraRig& rig, const HullOptions& options) {
  if (rig.size() < 2 || rig.size() > 32)
    throw std::invalid_argument("a rig has " + std::to_string(rig.size()) +
                                " cameras, allowed are 2 to 32");
  std::set<std::string> names;
  for (const Camera& camera : rig) {
    if (!names.insert(camera.name()).second)
      throw std::invalid_argument("two cameras of the rig are named '" + camera.name() + "'");
    if (std::max(camera.width(), camera.height()) > kMaxPixels)
      throw std::invalid_argument("camera '" + camera.name() + "' has more than " +
                                  std::to_string(kMaxPixels) + " pixels in a row or column");
  }
  if (size_t(options.min_views) > rig.size())
    throw std::invalid_argument("visual_hull/min_views is " + std::to_string(options.min_views) +
                                ", allowed is at most the number of cameras, " +
                                std::to_string(rig.size()));
}

/// Checks the rig and returns its lattice.
VoxelLattice latticeOf(const CameraRig& rig, const HullOptions& options) {
  options.validate();
  checkRig(rig, options);
  VoxelLattice lattice = options.lattice(rig);
  if (rig.size() * size_t(lattice.count()) > kMaxTableEntries)
    throw std::invalid_argument("visual_hull has too many voxels for " +
                                std::to_string(rig.size()) + " cameras (" +
                                std::to_string(lattice.count()) + ", allowed are " +
                                std::to_string(kMaxTableEntries / rig.size()) +
                                "): make the volume smaller or the pitch larger");
  return lattice;
}

void checkMat(const Camera& camera, const cv::Mat& mat, bool type_ok, const char* what,
              const char* types) {
  const std::string subject = std::string(what) + " of camera '" + camera.name() + "' ";
  if (mat.cols != camera.width() || mat.rows != camera.height())
    throw std::invalid_argument(subject + "is " + std::to_string(mat.cols) + " x " +
                                std::to_string(mat.rows) + " pixels, its calibration says " +
                                std::to_string(camera.width()) + " x " +
                                std::to_string(camera.height()));
  if (!type_ok) throw std::invalid_argument(subject + "must be " + types);
}

void checkViews(const CameraRig& rig, const std::vector<HullView>& views) {
  if (views.size() != rig.size())
    throw std::invalid_argument("the hull got " + std::to_string(views.size()) +
                                " views for a rig of " + std::to_string(rig.size()) + " cameras");
  for (size_t c = 0; c < views.size(); ++c) {
    const cv::Mat &mask = views[c].mask, &image = views[c].image;
    if (!mask.empty()) checkMat(rig[c], mask, mask.type() == CV_8UC1, "mask", "8 bit grey");
    if (!image.empty())
      checkMat(rig[c], image, image.type() == CV_8UC1 || image.type() == CV_8UC3, "image",
               "8 bit grey or BGR");
  }
}

}  // namespace

/// The person among the voxels, and who has voted on them.
struct HullDraft::Found {
  VoxelComponent person;
  CameraSet voters;
  std::vector<HullView> views;  ///< without those of which too little is known
};

class HullCarver::State {
 public:
  State(CameraRig rig, const HullOptions& options)
      : rig_(std::move(rig)),
        options_(options),
        lattice_(latticeOf(rig_, options_)),
        voting_(rig_, options_, lattice_),
        faults_(rig_, options_.min_views, &voting_),
        coloring_(rig_, voting_.table(), options_.color_vote_distance,
                  options_.color_voters == "all") {}

  HullDraft draft(const std::vector<HullView>& views);
  /// Fills the hull's voxels: indices, views, colours and colour votes. Uses nothing that draft()
  /// changes.
  VisualHull complete(HullDraft draft);

  const CameraRig& rig() const { return rig_; }
  const VoxelLattice& lattice() const { return lattice_; }

 private:
  HullDraft draftIn(const VoxelBox& window, const std::vector<HullView>& views);
  FaultyCameraFinder::Result carveComponents(const MaskSummary& masks, const VoxelBox& window);
  /// Number of cameras that see all of a cell, and the cameras that see a part of it.
  struct CellViews {
    uint8_t whole;
    CameraSet in_part;
  };
  std::vector<CellViews> viewsOf(const VoxelComponent& person, CameraSet voters) const;

  CameraRig rig_;
  HullOptions options_;
  VoxelLattice lattice_;
  VoxelVoting voting_;
  FaultyCameraFinder faults_;
  VoxelColoring coloring_;            ///< used by complete() alone
  std::optional<VoxelBox> followed_;  ///< box around the last person
  std::optional<VoxelComponent> last_person_;
};

HullDraft HullCarver::State::draft(const std::vector<HullView>& all_views) {
  checkViews(rig_, all_views);
  std::vector<LeftOutCamera> unknown;
  const std::vector<HullView> views = withoutUnknownViews(all_views, rig_, &unknown);
  voting_.setMasks(views);
  HullDraft draft;
  if (followed_) draft = draftIn(*followed_, views);
  if (!followed_ || draft.hull.status != HullStatus::kOk) {
    followed_.reset();
    draft = draftIn(voting_.bounds(), views);
  }
  VisualHull& hull = draft.hull;
  if (hull.status == HullStatus::kNobody || hull.status == HullStatus::kEmptyMasks)
    last_person_.reset();
  hull.cameras_left_out.insert(hull.cameras_left_out.begin(), unknown.begin(), unknown.end());
  return draft;
}

FaultyCameraFinder::Result HullCarver::State::carveComponents(const MaskSummary& masks,
                                                              const VoxelBox& window) {
  if (options_.leave_out_bad_cameras) return faults_.carve(masks, window);
  return {voting_.carve(masks.present, window), masks.present, {}};
}

HullDraft HullCarver::State::draftIn(const VoxelBox& window, const std::vector<HullView>& views) {
  HullDraft draft;
  VisualHull& hull = draft.hull;
  hull.lattice = lattice_;
  const MaskSummary masks = summariseMasks(rig_, voting_);
  FaultyCameraFinder::Result found;
  found.voters = masks.present;
  if (masks.count() >= options_.min_views && masks.empty != masks.present)
    found = carveComponents(masks, window);
  if (rejectMasks(masks, found.voters, rig_, options_.min_views, &hull)) return draft;
  for (const CameraFault& fault : found.faults)
    hull.cameras_left_out.push_back({rig_[fault.camera].name(), fault.reason});

  markUnsure(voting_.table(), found.voters, views, &found.components);
  const std::vector<VoxelComponent> components =
      rankComponents(std::move(found.components), voting_.table(), found.voters,
                     options_.min_component_litres, &hull);
  MaskSummary left = masks;
  left.empty &= found.voters;
  const VoxelComponent* person = selectPerson(components, options_.min_component_litres, left, rig_,
                                              last_person_ ? &*last_person_ : nullptr, &hull);
  if (person == nullptr) return draft;
  last_person_ = *person;
  draft.found = std::make_shared<HullDraft::Found>(HullDraft::Found{*person, found.voters, views});
  if (options_.follow) {
    const int margin = int(std::ceil(options_.follow_margin / lattice_.pitch));
    followed_ = boxOf(*person, lattice_);
    followed_->low.array() -= margin;
    followed_->high.array() += margin;
  }
  return draft;
}

VisualHull HullCarver::State::complete(HullDraft draft) {
  VisualHull hull = std::move(draft.hull);
  if (!draft.found) return hull;
  const VoxelComponent& person = draft.found->person;
  const std::vector<HullView>& views = draft.found->views;
  const std::vector<CellViews> cell_views = viewsOf(person, draft.found->voters);
  HullVoxel unpainted;
  unpainted.rgb = {128, 128, 128};
  hull.voxels.assign(person.voxels, unpainted);
  HullVoxel* next = hull.voxels.data();
  forEachInLatticeOrder(person, lattice_, [&](uint32_t index, uint32_t slot) {
    const size_t cell = slot / 64;
    HullVoxel& voxel = *next++;
    voxel.index = index;
    voxel.views = cell_views[cell].whole;
    for (CameraSet part = cell_views[cell].in_part; part != 0; part &= part - 1) {
      const uint64_t seen =
          voting_.table().seen(person.cells[cell].brick, size_t(__builtin_ctz(part)));
      voxel.views = uint8_t(voxel.views + (seen >> slot % 64 & 1));
    }
  });
  std::vector<cv::Mat> images(views.size());
  bool any = false;
  for (size_t c = 0; c < views.size(); ++c)
    if (!views[c].mask.empty() && !views[c].image.empty()) {
      images[c] = views[c].image;
      any = true;
    }
  if (any) coloring_.paint(person, inLatticeOrder(person, lattice_), images, &hull.voxels);
  return hull;
}

std::vector<HullCarver::State::CellViews> HullCarver::State::viewsOf(const VoxelComponent& person,
                                                                     CameraSet voters) const {
  const BlockLevel& bricks = voting_.table().level(0);
  std::vector<CellViews> views;
  views.reserve(person.cells.size());
  for (const BrickVoxels& cell : person.cells) {
    const CameraSet all = bricks.sees_all[cell.brick] & voters;
    views.push_back(
        {uint8_t(__builtin_popcount(all)), bricks.sees_some[cell.brick] & voters & ~all});
  }
  return views;
}

HullCarver::HullCarver(CameraRig rig, const HullOptions& options)
    : state_(std::make_unique<State>(std::move(rig), options)) {}
HullCarver::~HullCarver() = default;
HullCarver::HullCarver(HullCarver&&) noexcept = default;
HullCarver& HullCarver::operator=(HullCarver&&) noexcept = default;

VisualHull HullCarver::carve(const std::vector<HullView>& views) {
  return complete(draft(views));
}

HullDraft HullCarver::draft(const std::vector<HullView>& views) {
  return state_->draft(views);
}

VisualHull HullCarver::complete(HullDraft draft) {
  return state_->complete(std::move(draft));
}

const CameraRig& HullCarver::rig() const {
  return state_->rig();
}

const VoxelLattice& HullCarver::lattice() const {
  return state_->lattice();
}

}  // namespace markerless_mocap
