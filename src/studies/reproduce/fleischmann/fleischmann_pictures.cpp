#include "studies/reproduce/fleischmann/fleischmann_pictures.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>

namespace markerless_mocap {
namespace {

constexpr int kMargin = 30;         // pixels around the person
constexpr int kCaption = 24;        // height of the text below a picture, pixels
const cv::Size kPicture(220, 420);  // of a strip

bool isLeft(int cone) {
  return cone == kLeftThighCone || cone == kLeftCalfCone || cone == kLeftUpperArmCone ||
         cone == kLeftLowerArmCone;
}

FleischmannFitness fitnessFor(const Capture& capture, const FilmTruth& truth) {
  const FleischmannOptions options = fleischmannOptions(publishedFleischmannYaml(), {}, 1);
  const FleischmannBodyModel body_model(*truth.body);
  return FleischmannFitness(FilmReader(capture.bag, true).rig(), body_model,
                            FleischmannBodyShape(*truth.body, body_model, options.body),
                            options.image);
}

/// The picture in the middle of a white one of the size of all.
cv::Mat framed(const cv::Mat& picture, const std::string& text) {
  cv::Mat out(kPicture.height + kCaption, kPicture.width, CV_8UC3, cv::Scalar::all(255));
  const double scale =
      std::min(double(kPicture.width) / picture.cols, double(kPicture.height) / picture.rows);
  cv::Mat scaled;
  cv::resize(picture, scaled, cv::Size(), scale, scale, cv::INTER_AREA);
  scaled.copyTo(out(cv::Rect((kPicture.width - scaled.cols) / 2,
                             (kPicture.height - scaled.rows) / 2, scaled.cols, scaled.rows)));
  cv::putText(out, text, cv::Point(6, out.rows - 7), cv::FONT_HERSHEY_SIMPLEX, 0.45,
              cv::Scalar::all(0), 1, cv::LINE_AA);
  return out;
}

}  // namespace

DrawnPose plainPose(const FleischmannVector& v, const cv::Scalar& color) {
  return {v, color, color, color};
}

DrawnPose truePose(const FleischmannVector& v) {
  return plainPose(v, cv::Scalar(60, 60, 255));
}

DrawnPose estimatedPose(const FleischmannVector& v) {
  return {v, cv::Scalar(255, 255, 0), cv::Scalar(0, 255, 255), cv::Scalar(255, 255, 255)};
}

FleischmannVector poseOf(const Json& list) {
  FleischmannVector v;
  for (int d = 0; d < kFleischmannParameterCount; ++d) v[d] = list.at(size_t(d)).get<double>();
  return v;
}

FilmPictures::FilmPictures(const Capture& capture, const FilmTruth& truth,
                           std::vector<size_t> numbers)
    : fitness_(fitnessFor(capture, truth)) {
  FilmReader film(capture.bag, true);
  std::sort(numbers.begin(), numbers.end());
  for (size_t i = 0; !numbers.empty() && i <= numbers.back(); ++i) {
    std::optional<FilmFrame> frame = film.next();
    if (!frame) break;
    if (std::binary_search(numbers.begin(), numbers.end(), i))
      views_[i] = std::move(frame->views.front());
  }
}

void FilmPictures::draw(const DrawnPose& pose, cv::Mat* image) const {
  const auto outlines = fitness_.outlines(pose.v.data(), 0);
  for (size_t cone = 0; cone < outlines.size(); ++cone) {
    std::vector<cv::Point> corners;
    for (const cv::Point2f& corner : outlines[cone]) corners.emplace_back(corner);
    const bool trunk = cone == size_t(kTorsoCone) || cone == size_t(kHeadCone);
    const cv::Scalar& color = trunk ? pose.middle : (isLeft(int(cone)) ? pose.left : pose.right);
    if (!corners.empty()) cv::polylines(*image, corners, true, color, 1, cv::LINE_AA);
  }
}

cv::Mat FilmPictures::picture(size_t number, const std::vector<DrawnPose>& poses) const {
  const FleischmannView& view = views_.at(number);
  if (view.image.empty()) return cv::Mat(kPicture, CV_8UC3, cv::Scalar::all(128));  // dropped
  cv::Mat image;
  cv::cvtColor(view.image, image, cv::COLOR_GRAY2BGR);
  for (const DrawnPose& pose : poses) draw(pose, &image);
  cv::Rect part = cv::boundingRect(view.silhouette);
  part = cv::Rect(part.x - kMargin, part.y - kMargin, part.width + 2 * kMargin,
                  part.height + 2 * kMargin) &
         cv::Rect(0, 0, image.cols, image.rows);
  return image(part).clone();
}

cv::Mat strip(const std::vector<cv::Mat>& pictures, const std::vector<std::string>& texts) {
  std::vector<cv::Mat> framed_ones;
  for (size_t i = 0; i < pictures.size(); ++i) framed_ones.push_back(framed(pictures[i], texts[i]));
  cv::Mat out;
  cv::hconcat(framed_ones, out);
  return out;
}

}  // namespace markerless_mocap
