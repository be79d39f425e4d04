#pragma once

#include <Eigen/Core>
#include <string>

#include "markerless_mocap/options/options.h"

namespace markerless_mocap {

/// Settings of the model `network`: a network that segments people, in an ONNX file. The defaults
/// are those of nets that take RGB from 0 to 1 and give one plane of probabilities.
struct NetworkOptions {
  static constexpr const char* kStage = "silhouette/network";
  /// path of the ONNX file; the model network needs it
  std::string file;
  /// width that each image is scaled to for the net, px
  int width_px = 256;
  /// height that each image is scaled to for the net, px
  int height_px = 256;
  /// order of the net's input and output; nchw: plane by plane; nhwc: pixel by pixel
  std::string layout = "nchw";
  /// give the net red, green, blue; false: blue, green, red
  bool swap_red_and_blue = true;
  /// grey levels that are subtracted from the net's three input channels, in their order
  Eigen::Vector3d mean{0, 0, 0};
  /// grey levels that the three input channels are then divided by
  Eigen::Vector3d deviation{255, 255, 255};
  /// name of the net's output; empty: the net has only one
  std::string output;
  /// what the output holds; probabilities: 0 to 1; logits: before a sigmoid (one plane) or a
  /// softmax (several); labels: one plane with the number of the class
  std::string output_values = "probabilities";
  /// number of the class of people, from 0; a single plane of probabilities or logits is of people
  int person_class = 0;
  /// a pixel with at least this probability is foreground
  double threshold = 0.5;

  void visit(OptionVisitor& v);
};

}  // namespace markerless_mocap
