#include "markerless_mocap/silhouette/network_options.h"

namespace markerless_mocap {

void NetworkOptions::visit(OptionVisitor& v) {
  v.field("file", file, {}, "path of the ONNX file; the model network needs it");
  v.field("width_px", width_px, 8, 4096, "width that each image is scaled to for the net, px");
  v.field("height_px", height_px, 8, 4096, "height that each image is scaled to for the net, px");
  v.field("layout", layout, {"nchw", "nhwc"},
          "order of the net's input and output; nchw: plane by plane; nhwc: pixel by pixel");
  v.field("swap_red_and_blue", swap_red_and_blue,
          "give the net red, green, blue; false: blue, green, red");
  v.field("mean", mean, 0, 255,
          "grey levels that are subtracted from the net's three input channels, in their order");
  v.field("deviation", deviation, 0.01, 1000,
          "grey levels that the three input channels are then divided by");
  v.field("output", output, {}, "name of the net's output; empty: the net has only one");
  v.field("output_values", output_values, {"probabilities", "logits", "labels"},
          "what the output holds; probabilities: 0 to 1; logits: before a sigmoid (one plane) or a "
          "softmax (several); labels: one plane with the number of the class");
  v.field("person_class", person_class, 0, 10000,
          "number of the class of people, from 0; a single plane of probabilities or logits is of "
          "people");
  v.field("threshold", threshold, 0, 1, "a pixel with at least this probability is foreground");
}

}  // namespace markerless_mocap
