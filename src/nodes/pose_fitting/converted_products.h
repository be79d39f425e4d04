#pragma once

#include <sensor_msgs/PointCloud2.h>

#include <exception>
#include <string>
#include <vector>

#include "markerless_mocap/ros/messages.h"
#include "markerless_mocap/tracking/product_source.h"
#include "nodes/common/hull_grids.h"
#include "ros/pose_tree_conversions.h"
#include "ros/segmentation_conversions.h"

namespace markerless_mocap {

/// What the other stages have sent for one frame set; each may be missing.
struct ProductMessages {
  sensor_msgs::PointCloud2ConstPtr hull, labels;
  BodyPartsMsg::ConstPtr parts;
  PoseTreeMsg::ConstPtr tree;
  HullGrids grids;
};

/// Runs a conversion. What it throws becomes a sentence, and the product is as if it were missing.
template <class ConvertT>
void convertOrTell(const char* topic, std::vector<std::string>* faults, const ConvertT& convert) {
  try {
    convert();
  } catch (const std::exception& error) {
    faults->push_back(std::string(topic) + " has sent what cannot be used: " + error.what());
  }
}

/// A message that cannot be used costs its product only.
/// \param faults a sentence is appended for each
inline FrameProducts convertedProducts(const ProductMessages& messages,
                                       std::vector<std::string>* faults) {
  FrameProducts products;
  if (messages.hull)
    convertOrTell("hull/points", faults,
                  [&] { products.hull = messages.grids.hullOf(*messages.hull); });
  if (messages.parts && messages.labels) {
    convertOrTell("segmentation/parts", faults,
                  [&] { products.parts = partsFromMessage(*messages.parts); });
    convertOrTell("segmentation/points", faults,
                  [&] { products.parts.labels = labelsFromMessage(*messages.labels); });
  }
  if (messages.tree)
    convertOrTell("pose_tree", faults,
                  [&] { products.tree = poseTreeFromMessage(*messages.tree); });
  return products;
}

}  // namespace markerless_mocap
