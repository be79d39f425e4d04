#pragma once

#include <utility>

#include "markerless_mocap/products/body_parts.h"
#include "markerless_mocap/products/pose_tree.h"
#include "markerless_mocap/products/visual_hull.h"

namespace markerless_mocap {

/// What the earlier stages make of one frame set. What a stage has not made is empty.
struct FrameProducts {
  VisualHull hull;
  BodyParts parts;
  PoseTree tree;
};

/// Where a tracker gets the products of a frame set from, when it needs them: masks are enough to
/// follow a person.
class ProductSource {
 public:
  virtual ~ProductSource() = default;
  /// The products of this frame set. Waits until they are made, or cannot be made any more.
  virtual const FrameProducts& ofThisFrame() = 0;
  /// As ofThisFrame(), for a search after which the person is followed; it may take as long as many
  /// frame sets.
  virtual const FrameProducts& forStart() { return ofThisFrame(); }
  /// The newest hull, of this frame set or of one up to half a second before. Does not wait.
  virtual const VisualHull& newestHull() = 0;
};

/// Products that are made already.
class ReadyProducts : public ProductSource {
 public:
  explicit ReadyProducts(FrameProducts products = {}) : products_(std::move(products)) {}
  const FrameProducts& ofThisFrame() override { return products_; }
  const VisualHull& newestHull() override { return products_.hull; }

 private:
  FrameProducts products_;
};

}  // namespace markerless_mocap
