#include "silhouette/network/person_net.h"

#include <filesystem>
#include <opencv2/imgproc.hpp>
#include <stdexcept>
#include <vector>

namespace markerless_mocap {
namespace {

std::string joinedNames(const std::vector<cv::String>& names) {
  std::string list;
  for (const cv::String& name : names) list += (list.empty() ? "" : ", ") + name;
  return list;
}

std::string shapeText(const cv::Mat& values) {
  std::string text;
  for (int i = 0; i < values.dims; ++i)
    text += (i > 0 ? " x " : "") + std::to_string(values.size[i]);
  return text;
}

/// First line of OpenCV's error.
std::string reasonOf(const cv::Exception& error) {
  return error.err.substr(0, error.err.find('\n'));
}

/// The output as planes by row by column, whatever ones of size 1 are around.
struct Planes {
  int count, height, width;
  bool interleaved;  ///< values of one pixel follow each other
  cv::Mat values;    ///< CV_32F, continuous

  cv::Mat plane(int number) const {
    const float* const first = values.ptr<float>();
    if (!interleaved)
      return cv::Mat(height, width, CV_32FC1,
                     const_cast<float*>(first) + size_t(number) * height * width)
          .clone();
    cv::Mat plane(height, width, CV_32FC1);
    for (int i = 0; i < height * width; ++i)
      plane.ptr<float>()[i] = first[size_t(i) * count + number];
    return plane;
  }
};

/// \return count 0 if the shape has another number of sizes
Planes planesOf(const cv::Mat& output, bool interleaved) {
  Planes planes{0, 0, 0, interleaved, {}};
  output.convertTo(planes.values, CV_32F);
  std::vector<int> sizes(output.size.p, output.size.p + output.dims);
  while (sizes.size() > 2 && sizes.front() == 1) sizes.erase(sizes.begin());
  if (interleaved && sizes.size() > 2 && sizes.back() == 1) sizes.pop_back();
  if (sizes.size() == 2) {
    planes.count = 1;
    planes.height = sizes[0];
    planes.width = sizes[1];
  } else if (sizes.size() == 3) {
    const int at = interleaved ? 2 : 0;
    planes.count = sizes[at];
    planes.height = sizes[interleaved ? 0 : 1];
    planes.width = sizes[interleaved ? 1 : 2];
  }
  return planes;
}

cv::Mat sigmoid(const cv::Mat& logits) {
  cv::Mat odds;
  cv::exp(-logits, odds);
  return 1.0 / (1.0 + odds);
}

/// One of the planes of a softmax over all.
cv::Mat softmax(const Planes& logits, int number) {
  cv::Mat highest = logits.plane(0);
  for (int i = 1; i < logits.count; ++i) highest = cv::max(highest, logits.plane(i));
  cv::Mat sum = cv::Mat::zeros(logits.height, logits.width, CV_32FC1), person;
  for (int i = 0; i < logits.count; ++i) {
    cv::Mat term;
    cv::exp(logits.plane(i) - highest, term);
    sum += term;
    if (i == number) person = term;
  }
  return person / sum;
}

}  // namespace

PersonNet::PersonNet(const NetworkOptions& options) : options_(options) {
  if (options_.file.empty())
    throw std::invalid_argument(
        "silhouette/network/file is empty, the model network needs the path of an ONNX file");
  if (!std::filesystem::is_regular_file(options_.file)) throwError("cannot be opened");
  try {
    net_ = cv::dnn::readNetFromONNX(options_.file);
  } catch (const cv::Exception& error) {
    throwError("cannot be loaded by OpenCV's dnn: " + reasonOf(error));
  }
  if (net_.empty()) throwError("holds no net");
  net_.setPreferableBackend(cv::dnn::DNN_BACKEND_OPENCV);
  net_.setPreferableTarget(cv::dnn::DNN_TARGET_CPU);
  chooseOutput();
  probability(cv::Mat::zeros(options_.height_px, options_.width_px, CV_8UC3));
}

void PersonNet::throwError(const std::string& what) const {
  throw std::invalid_argument("the network file " + options_.file + " " + what);
}

void PersonNet::chooseOutput() {
  const std::vector<cv::String> names = net_.getUnconnectedOutLayersNames();
  output_ = options_.output;
  if (output_.empty() && names.size() > 1)
    throwError("has several outputs, name one of them in silhouette/network/output: " +
               joinedNames(names));
  if (output_.empty() && !names.empty()) output_ = names.front();
}

cv::Mat PersonNet::inputOf(const cv::Mat& image) const {
  cv::Mat color = image;
  if (image.channels() == 1) cv::cvtColor(image, color, cv::COLOR_GRAY2BGR);
  if (options_.swap_red_and_blue) cv::cvtColor(color, color, cv::COLOR_BGR2RGB);
  cv::resize(color, color, {options_.width_px, options_.height_px}, 0, 0, cv::INTER_AREA);
  cv::Mat input;
  color.convertTo(input, CV_32FC3);
  const Eigen::Vector3d &mean = options_.mean, &deviation = options_.deviation;
  cv::subtract(input, cv::Scalar(mean[0], mean[1], mean[2]), input);
  cv::divide(input, cv::Scalar(deviation[0], deviation[1], deviation[2]), input);
  if (options_.layout == "nchw") return cv::dnn::blobFromImage(input);
  return input.reshape(1, {1, options_.height_px, options_.width_px, 3});
}

cv::Mat PersonNet::run(const cv::Mat& image) {
  const cv::Mat input = inputOf(image);
  try {
    net_.setInput(input);
    return net_.forward(output_);
  } catch (const cv::Exception& error) {
    throwError("fails on an input of " + shapeText(input) + (output_.empty() ? "" : " at output ") +
               output_ + ": " + reasonOf(error));
  }
}

cv::Mat PersonNet::personPlane(const cv::Mat& output) const {
  const Planes planes = planesOf(output, options_.layout == "nhwc");
  const bool labels = options_.output_values == "labels";
  const int person = planes.count == 1 ? 0 : options_.person_class;
  if (planes.count == 0 || (labels && planes.count != 1) || person >= planes.count)
    throwError(
        "gives an output of " + shapeText(output) + ", expected is " +
        (labels ? "one plane of labels"
                : "one plane, or several with the class " + std::to_string(options_.person_class)) +
        " in the order " + options_.layout);
  if (labels) {
    const cv::Mat is_person = planes.plane(0) == double(options_.person_class);
    cv::Mat probability;
    is_person.convertTo(probability, CV_32F, 1.0 / 255.0);
    return probability;
  }
  if (options_.output_values == "probabilities") return planes.plane(person);
  return planes.count == 1 ? sigmoid(planes.plane(0)) : softmax(planes, person);
}

cv::Mat PersonNet::probability(const cv::Mat& image) {
  cv::Mat scaled;
  cv::resize(personPlane(run(image)), scaled, image.size(), 0, 0, cv::INTER_LINEAR);
  return scaled;
}

}  // namespace markerless_mocap
