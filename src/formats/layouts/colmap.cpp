// COLMAP's text model: colmap.github.io/format.html. Pixel centres are at half numbers there, one
// half more than here; the pose takes world points to camera points, quaternion first its w.
#include <algorithm>
#include <map>
#include <sstream>

#include "formats/parts/camera_parts.h"
#include "text/joined.h"
#include "text/number_text.h"

namespace markerless_mocap {
namespace {

constexpr const char* kFormat = "COLMAP text model";
constexpr double kPixelCentre = 0.5;
constexpr double kRounded = 1e-2;  // of a quaternion's length

/// Indices of the parameters: fx, fy, cx, cy, then the lens in OpenCV's order; -1 is zero.
struct Model {
  int count;
  int fx, fy, cx, cy;
  std::vector<int> lens;
  LensType type = LensType::kPolynomial;
};

const std::map<std::string, Model>& models() {
  static const std::map<std::string, Model> kModels = {
      {"SIMPLE_PINHOLE", {3, 0, 0, 1, 2, {}}},
      {"PINHOLE", {4, 0, 1, 2, 3, {}}},
      {"SIMPLE_RADIAL", {4, 0, 0, 1, 2, {3, -1, -1, -1}}},
      {"RADIAL", {5, 0, 0, 1, 2, {3, 4, -1, -1}}},
      {"OPENCV", {8, 0, 1, 2, 3, {4, 5, 6, 7}}},
      {"OPENCV_FISHEYE", {8, 0, 1, 2, 3, {4, 5, 6, 7}, LensType::kFisheye}},
      {"FULL_OPENCV", {12, 0, 1, 2, 3, {4, 5, 6, 7, 8, 9, 10, 11}}}};
  return kModels;
}

struct Line {
  std::string text;
  std::string where;  ///< of sentences about it

  bool blank() const { return text.find_first_not_of(" \t\r") == std::string::npos; }
};

/// Without comments.
std::vector<Line> linesOf(const TextFile& file) {
  std::istringstream stream(file.text);
  std::vector<Line> lines;
  std::string text;
  for (int number = 1; std::getline(stream, text); ++number)
    if (text.empty() || text[0] != '#')
      lines.push_back({text, file.path + ", line " + std::to_string(number)});
  return lines;
}

std::string firstLine(const std::string& text) {
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);)
    if (line[0] != '#' && line.find_first_not_of(" \t\r") != std::string::npos) return line;
  return "";
}

/// ID MODEL WIDTH HEIGHT PARAMS
bool isCameras(const std::string& text) {
  std::istringstream line(firstLine(text));
  int id = 0, width = 0, height = 0;
  std::string model;
  double parameter = 0.0;
  return (line >> id >> model >> width >> height >> parameter) &&
         std::isalpha(static_cast<unsigned char>(model[0])) &&
         std::all_of(model.begin(), model.end(), [](unsigned char c) {
           return std::isupper(c) || std::isdigit(c) || c == '_';
         });
}

struct Image {
  double q[4] = {}, t[3] = {};
  int camera = 0;
  std::string name;
};

/// ID QW QX QY QZ TX TY TZ CAMERA_ID NAME
bool parseImage(const std::string& text, Image* image) {
  std::istringstream line(text);
  int id = 0;
  line >> id;
  for (double& value : image->q) line >> value;
  for (double& value : image->t) line >> value;
  line >> image->camera >> std::ws;
  std::getline(line, image->name);
  while (!image->name.empty() && std::isspace(static_cast<unsigned char>(image->name.back())))
    image->name.pop_back();
  return !line.fail() && !image->name.empty();
}

bool isImages(const std::string& text) {
  Image image;
  return parseImage(firstLine(text), &image) &&
         std::abs(Eigen::Vector4d(image.q).norm() - 1.0) < kRounded;
}

CameraCalibration lensFrom(const Line& line, int* id) {
  const std::string& where = line.where;
  std::istringstream stream(line.text);
  std::string name, rest;
  double width = 0.0, height = 0.0;
  CameraCalibration camera;
  if (!(stream >> *id >> name >> width >> height))
    throwFormatError(where, "it is not CAMERA_ID MODEL WIDTH HEIGHT PARAMS");
  camera.width = pixelsFrom(width, "WIDTH", where);
  camera.height = pixelsFrom(height, "HEIGHT", where);
  std::getline(stream, rest);
  const auto model = models().find(name);
  if (model == models().end())
    throwFormatError(where, "the camera model is " + name + ", allowed are " +
                                joined(models(), [](const auto& entry) { return entry.first; }));
  const Model& m = model->second;
  const std::vector<double> p = numbersIn(rest);
  if (p.empty()) throwFormatError(where, "behind WIDTH HEIGHT is something that is no number");
  checkNumbers(p, m.count, name, where);
  camera.K = cameraMatrixFrom(
      {p[m.fx], 0, p[m.cx] - kPixelCentre, 0, p[m.fy], p[m.cy] - kPixelCentre, 0, 0, 1}, where);
  camera.lens = m.type;
  for (const int index : m.lens) camera.D.push_back(index < 0 ? 0.0 : p[index]);
  return camera;
}

std::map<int, CameraCalibration> lensesIn(const TextFile& file) {
  std::map<int, CameraCalibration> lenses;
  for (const Line& line : linesOf(file)) {
    if (line.blank()) continue;
    int id = 0;
    const CameraCalibration lens = lensFrom(line, &id);
    lenses[id] = lens;
  }
  return lenses;
}

CameraCalibration cameraFrom(const Image& image, const std::map<int, CameraCalibration>& lenses,
                             const std::string& path) {
  const std::string where = path + ", image '" + image.name + "'";
  const auto lens = lenses.find(image.camera);
  if (lens == lenses.end())
    throwFormatError(where, "camera " + std::to_string(image.camera) + " is not in cameras.txt");
  const Eigen::Quaterniond q(image.q[0], image.q[1], image.q[2], image.q[3]);
  if (!(std::abs(q.norm() - 1.0) < kRounded))
    throwFormatError(where, "the quaternion has length " + numberText(q.norm()) + ", allowed is 1");
  CameraCalibration camera = lens->second;
  camera.T_world_camera = poseFromWorldToCamera(q.normalized().toRotationMatrix(),
                                                {image.t[0], image.t[1], image.t[2]});
  return camera;
}

std::string lensText(const CameraCalibration& camera) {
  checkNoSkew(camera, kFormat);
  const Eigen::Matrix3d& K = camera.K;
  std::vector<double> p = {K(0, 0), K(1, 1), K(0, 2) + kPixelCentre, K(1, 2) + kPixelCentre};
  const bool full = camera.D.size() > 4, fisheye = camera.lens == LensType::kFisheye;
  if (fisheye)
    for (const double d : fisheyeDistortion(camera)) p.push_back(d);
  else if (!camera.D.empty())
    for (const double d : distortionOfLength(camera, full ? 8 : 4, kFormat)) p.push_back(d);
  std::string out = fisheye            ? "OPENCV_FISHEYE"
                    : camera.D.empty() ? "PINHOLE"
                    : full             ? "FULL_OPENCV"
                                       : "OPENCV";
  out += ' ' + std::to_string(camera.width) + ' ' + std::to_string(camera.height);
  for (const double value : p) out += ' ' + numberText(value);
  return out + '\n';
}

std::string poseText(const CameraCalibration& camera) {
  const Eigen::Isometry3d T = camera.T_world_camera.inverse();
  const Eigen::Quaterniond q(T.linear());
  const Eigen::Vector3d t = T.translation();
  std::string out;
  for (const double value : {q.w(), q.x(), q.y(), q.z(), t.x(), t.y(), t.z()})
    out += numberText(value) + ' ';
  return out;
}

}  // namespace

bool isColmapText(const std::string& text) {
  return isCameras(text) || isImages(text);
}

CalibrationSet readColmapFiles(const std::vector<TextFile>& files) {
  const TextFile *cameras = nullptr, *images = nullptr;
  for (const TextFile& file : files) {
    const TextFile*& role = isCameras(file.text) ? cameras : images;
    if (role)
      throwFormatError(file.path, "this is a second file like " + role->path + ", allowed is one");
    role = &file;
  }
  if (!cameras || !images)
    throwFormatError(files[0].path, std::string("this is only half of a model, ") +
                                        (cameras ? "images.txt" : "cameras.txt") + " is missing");
  const auto lenses = lensesIn(*cameras);
  std::vector<TextFile> names;
  CalibrationSet set;
  const std::vector<Line> lines = linesOf(*images);
  for (size_t i = 0; i < lines.size(); i += 2) {  // every second line lists points
    if (lines[i].text.empty() && i + 1 == lines.size()) break;
    Image image;
    if (!parseImage(lines[i].text, &image))
      throwFormatError(lines[i].where,
                       "it is not ID QW QX QY QZ TX TY TZ CAMERA_ID NAME; every second line lists "
                       "points, and may be empty");
    set.cameras.push_back(cameraFrom(image, lenses, images->path));
    names.push_back({image.name, ""});
  }
  const auto from_images = cameraNamesOf(names);
  for (size_t i = 0; i < names.size(); ++i) set.cameras[i].name = from_images[i];
  return set;
}

std::vector<TextFile> writeColmapFiles(const std::vector<CameraCalibration>& rig) {
  std::string cameras = "# CAMERA_ID, MODEL, WIDTH, HEIGHT, PARAMS[]\n";
  std::string images =
      "# IMAGE_ID, QW, QX, QY, QZ, TX, TY, TZ, CAMERA_ID, NAME\n# POINTS2D[] as (X, Y, "
      "POINT3D_ID)\n";
  for (size_t i = 0; i < rig.size(); ++i) {
    const std::string id = std::to_string(i + 1);
    cameras += id + ' ' + lensText(rig[i]);
    images += id + ' ' + poseText(rig[i]) + id + ' ' + fileNameOf(rig[i]) + ".png\n\n";
  }
  return {{"cameras.txt", cameras},
          {"images.txt", images},
          {"points3D.txt", "# POINT3D_ID, X, Y, Z, R, G, B, ERROR, TRACK[]\n"}};
}

}  // namespace markerless_mocap
