#include "markerless_mocap/pipeline/pipeline.h"

#include <tbb/parallel_for.h>
#include <tbb/parallel_pipeline.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "markerless_mocap/products/silhouette_mask.h"
#include "pipeline/held_results.h"
#include "pipeline/lost_frame_sets.h"

namespace markerless_mocap {
namespace {

constexpr size_t kMaxFramesInFlight = 6;  // frame sets; each keeps its images in memory

void checkSize(const Camera& camera, const cv::Mat& pixels, const char* what) {
  if (pixels.empty() || (pixels.cols == camera.width() && pixels.rows == camera.height())) return;
  throw std::invalid_argument(std::string(what) + " of camera " + camera.name() + " is " +
                              std::to_string(pixels.cols) + " x " + std::to_string(pixels.rows) +
                              " pixels, its calibration says " + std::to_string(camera.width()) +
                              " x " + std::to_string(camera.height()));
}

std::vector<HullView> viewsOf(const std::vector<CameraFrame>& frames,
                              const std::vector<cv::Mat>& masks) {
  std::vector<HullView> views(frames.size());
  for (size_t i = 0; i < frames.size(); ++i)
    if (!masks[i].empty()) views[i] = {masks[i], frames[i].image};
  return views;
}

/// The masks without those that the hull found to be wrong. Where it left out one because too
/// little of its background is known, fitting goes by the colours.
std::vector<cv::Mat> trustedMasks(const CameraRig& rig, const PipelineResult& result) {
  std::vector<cv::Mat> masks = result.masks;
  for (const LeftOutCamera& camera : result.hull.cameras_left_out)
    for (size_t i = 0; i < rig.size(); ++i)
      if (rig[i].name() == camera.name && !hasUnknownBackground(masks[i])) masks[i] = cv::Mat();
  return masks;
}

}  // namespace

/// The products of one frame set; they are made now if they have not been yet.
class Pipeline::Products : public ProductSource {
 public:
  Products(Pipeline* pipeline, Work* work) : pipeline_(*pipeline), work_(*work) {}
  const FrameProducts& ofThisFrame() override {
    newestHull();
    if (pipeline_.on_demand_ != OnDemand::kNothing && !made_) pipeline_.makeParts(work_);
    made_ = true;
    return work_.result;
  }
  const VisualHull& newestHull() override {
    if (work_.draft.found) pipeline_.completeHull(work_);
    return work_.result.hull;
  }

 private:
  Pipeline& pipeline_;
  Work& work_;
  bool made_ = false;
};

Pipeline::Pipeline(CameraRig rig, const PersonResources& resources, const PipelineOptions& options)
    : min_views_(options.hull.min_views),
      carver_(std::move(rig), options.hull),
      segmenter_(options.segmentation),
      tree_builder_(options.pose_tree),
      tracker_(makeBodyTracker(carver_.rig(), resources, options.fitting)) {
  for (size_t i = 0; i < carver_.rig().size(); ++i) silhouettes_.emplace_back(options.silhouette);
}

Pipeline::~Pipeline() = default;

void Pipeline::followBack() {
  lost_ = std::make_unique<LostFrameSets>();
}

struct Pipeline::Stage {
  const char* name;
  void (Pipeline::*make)(Work&);
  bool may_wait;  ///< until the tracker asks for its product
};

const std::vector<Pipeline::Stage>& Pipeline::stages() {
  static const std::vector<Stage> stages = {
      {SilhouetteOptions::kStage, &Pipeline::extractSilhouettes, false},
      {HullOptions::kStage, &Pipeline::carve, false},
      {SegmentationOptions::kStage, &Pipeline::segment, true},
      {PoseTreeOptions::kStage, &Pipeline::buildTree, true},
      {TrackerOptions::kStage, &Pipeline::track, false}};
  return stages;
}

void Pipeline::run(const Stage& stage, Work& work) {
  if (work.result.learning || (stage.may_wait && on_demand_ != OnDemand::kNothing)) return;
  watch_(stage.name, [&] { (this->*stage.make)(work); });
}

PipelineResult Pipeline::process(int64_t stamp_ns, const std::vector<CameraFrame>& frames) {
  Work work{{stamp_ns, frames, {}}, {}, {}};
  for (const Stage& stage : stages()) run(stage, work);
  return std::move(work.result);
}

void Pipeline::processStream(const Source& source, const Sink& sink) {
  using Item = std::shared_ptr<Work>;
  constexpr auto kInOrder = tbb::filter_mode::serial_in_order;
  tbb::filter<void, Item> chain =
      tbb::make_filter<void, Item>(kInOrder, [&](tbb::flow_control& control) -> Item {
        std::optional<FrameSet> frame_set = source();
        if (frame_set) return std::make_shared<Work>(Work{std::move(*frame_set), {}, {}});
        control.stop();
        return nullptr;
      });
  for (const Stage& stage : stages())
    chain &= tbb::make_filter<Item, Item>(kInOrder, [&](const Item& item) {
      // While a stage waits for its own parallel loops, its thread must not start the work of
      // another stage.
      tbb::this_task_arena::isolate([&] { run(stage, *item); });
      return item;
    });
  HeldResults held(sink);
  tbb::parallel_pipeline(kMaxFramesInFlight,
                         chain & tbb::make_filter<Item, void>(kInOrder, [&](const Item& item) {
                           tbb::this_task_arena::isolate([&] {
                             if (!lost_) return sink(item->frame_set, item->result);
                             held.add(item->frame_set, std::move(item->result));
                           });
                         }));
  held.passOn();
}

void Pipeline::useBackgrounds(const std::vector<SharedBackground>& backgrounds) {
  if (backgrounds.empty()) return;
  if (backgrounds.size() != silhouettes_.size())
    throw std::invalid_argument("pipeline got " + std::to_string(backgrounds.size()) +
                                " backgrounds, the rig has " + std::to_string(rig().size()) +
                                " cameras");
  for (size_t i = 0; i < backgrounds.size(); ++i) silhouettes_[i].useBackground(backgrounds[i]);
}

void Pipeline::followLight(const FrameSet& frame_set) {
  Work ignored{frame_set, {}, {}};
  extractSilhouettes(ignored);
}

std::vector<SharedBackground> Pipeline::backgrounds() const {
  std::vector<SharedBackground> backgrounds;
  for (const SilhouetteExtractor& extractor : silhouettes_)
    backgrounds.push_back(extractor.background());
  return backgrounds;
}

void Pipeline::checkFrames(const std::vector<CameraFrame>& frames) const {
  if (frames.size() != rig().size())
    throw std::invalid_argument("pipeline got " + std::to_string(frames.size()) +
                                " frames, the rig has " + std::to_string(rig().size()) +
                                " cameras");
  for (size_t i = 0; i < frames.size(); ++i) {
    checkSize(rig()[i], frames[i].image, "image");
    checkSize(rig()[i], frames[i].mask, "mask");
  }
}

void Pipeline::extractSilhouettes(Work& work) {
  const std::vector<CameraFrame>& frames = work.frame_set.frames;
  checkFrames(frames);
  std::vector<cv::Mat> found(frames.size());
  std::vector<char> learning(frames.size(), false);
  tbb::parallel_for(size_t(0), frames.size(), [&](size_t i) {
    if (!frames[i].mask.empty()) {
      found[i] = frames[i].mask;
    } else if (!frames[i].image.empty()) {
      SilhouetteResult silhouette = silhouettes_[i].update(frames[i].image);
      found[i] = silhouette.mask;
      learning[i] = silhouette.state == SilhouetteState::kLearning;
    }
  });
  const auto ready =
      std::count_if(found.begin(), found.end(), [](const cv::Mat& mask) { return !mask.empty(); });
  const bool any_learning = std::count(learning.begin(), learning.end(), true) > 0;
  work.result.learning = any_learning && ready < min_views_;
  if (!work.result.learning) work.result.masks = std::move(found);
}

void Pipeline::carve(Work& work) {
  const std::vector<HullView> views = viewsOf(work.frame_set.frames, work.result.masks);
  if (on_demand_ != OnDemand::kPartsAndVoxels) {
    work.result.hull = carver_.carve(views);
    return;
  }
  work.draft = carver_.draft(views);
  work.result.hull = work.draft.hull;
}

void Pipeline::completeHull(Work& work) {
  watch_(HullOptions::kStage,
         [&] { work.result.hull = carver_.complete(std::exchange(work.draft, {})); });
}

void Pipeline::segment(Work& work) {
  work.result.parts = segmenter_.segment(work.result.hull, work.frame_set.stamp_ns, &part_tracker_);
}

void Pipeline::buildTree(Work& work) {
  work.result.tree = tree_builder_.build(work.result.hull);
}

void Pipeline::makeParts(Work& work) {
  for (const Stage& stage : stages())
    if (stage.may_wait) watch_(stage.name, [&] { (this->*stage.make)(work); });
}

void Pipeline::track(Work& work) {
  const FrameSet& frame_set = work.frame_set;
  const std::vector<cv::Mat> masks = trustedMasks(rig(), work.result);
  const std::vector<cv::Mat> images = imagesOf(frame_set.frames);
  Products products(this, &work);
  BodyPose& pose = work.result.pose;
  pose = tracker_->update(
      {frame_set.stamp_ns, masks, images, products, {}, false, latenessOf(frame_set.frames)});
  work.result.body = tracker_->body();
  if (!lost_) return;
  if (pose.status == PoseStatus::kLost) {
    products.newestHull();  // who follows the person back may ask for it
    lost_->add(frame_set, masks, work.result);
  } else {
    work.result.earlier_poses = lost_->followedBackBy(*tracker_);
  }
}

}  // namespace markerless_mocap
