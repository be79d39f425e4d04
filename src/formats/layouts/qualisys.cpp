// Qualisys .qca.txt: XML. Focal lengths and centres in 1/64 pixel, positions in mm, the rotation by
// columns; the camera looks along -z of its frame, with y up. The coefficients of the lens have no
// unit: with them as they stand, chessboards agree with a calibration of the same cameras.
#include <tinyxml2.h>

#include <sstream>

#include "files/xml_text.h"
#include "formats/parts/camera_parts.h"
#include "text/number_text.h"

namespace markerless_mocap {
namespace {

using tinyxml2::XMLElement;

constexpr const char* kFormat = "Qualisys .qca.txt";
constexpr double kSubpixels = 64.0;
constexpr double kMillimetre = 0.001;

const XMLElement& child(const XMLElement& parent, const char* name, const std::string& where) {
  const XMLElement* element = parent.FirstChildElement(name);
  if (!element) throwFormatError(where, std::string("there is no element <") + name + ">");
  return *element;
}

double number(const XMLElement& element, const char* name, const std::string& where) {
  const char* text = element.Attribute(name);
  const auto values = numbersIn(text ? text : "");
  if (values.size() != 1)
    throwFormatError(where, std::string("<") + element.Name() + "> has " + name + "=\"" +
                                (text ? text : "") + "\", allowed is one number");
  checkNumbers(values, 1, name, where);
  return values[0];
}

/// From OpenCV's optical axes to those of Qualisys: half a turn about x.
Eigen::Matrix3d halfTurn() {
  return Eigen::Vector3d(1.0, -1.0, -1.0).asDiagonal();
}

void readLens(const XMLElement& element, const std::string& where, CameraCalibration* camera) {
  const XMLElement& view = child(element, "fov_video", where);
  const double left = number(view, "left", where), top = number(view, "top", where);
  camera->width = pixelsFrom(number(view, "right", where) - left + 1, "right - left + 1", where);
  camera->height = pixelsFrom(number(view, "bottom", where) - top + 1, "bottom - top + 1", where);
  const XMLElement& lens = child(element, "intrinsic", where);
  const auto pixels = [&](const char* name) { return number(lens, name, where) / kSubpixels; };
  camera->K =
      cameraMatrixFrom({pixels("focalLengthU"), pixels("skew"), pixels("centerPointU") - left, 0,
                        pixels("focalLengthV"), pixels("centerPointV") - top, 0, 0, 1},
                       where);
  for (const char* name : {"radialDistortion1", "radialDistortion2", "tangentalDistortion1",
                           "tangentalDistortion2", "radialDistortion3"})
    camera->D.push_back(number(lens, name, where));
}

void readPose(const XMLElement& element, const std::string& where, CameraCalibration* camera) {
  const XMLElement& pose = child(element, "transform", where);
  std::vector<double> by_columns;
  for (const char* name : {"r11", "r21", "r31", "r12", "r22", "r32", "r13", "r23", "r33"})
    by_columns.push_back(number(pose, name, where));
  camera->T_world_camera.linear() = rotationFrom(by_columns, where) * halfTurn();
  camera->T_world_camera.translation() << number(pose, "x", where), number(pose, "y", where),
      number(pose, "z", where);
}

void pushNumbers(tinyxml2::XMLPrinter* out,
                 const std::vector<std::pair<const char*, double>>& values) {
  for (const auto& [name, value] : values) out->PushAttribute(name, numberText(value).c_str());
}

void writeCamera(const CameraCalibration& camera, tinyxml2::XMLPrinter* out) {
  const Eigen::Matrix3d R = camera.T_world_camera.linear() * halfTurn();
  const Eigen::Vector3d t = camera.T_world_camera.translation() / kMillimetre;
  const Eigen::Matrix3d K = kSubpixels * camera.K;
  const auto D = distortionOfLength(camera, 5, kFormat);
  out->OpenElement("camera");
  out->PushAttribute("active", "1");
  out->PushAttribute("model", "none");
  out->PushAttribute("serial", camera.name.c_str());
  out->PushAttribute("viewrotation", "0");
  for (const char* name : {"fov_marker", "fov_marker_max", "fov_video", "fov_video_max"}) {
    out->OpenElement(name);
    pushNumbers(
        out,
        {{"left", 0}, {"top", 0}, {"right", camera.width - 1.0}, {"bottom", camera.height - 1.0}});
    out->CloseElement();
  }
  out->OpenElement("transform");
  pushNumbers(out, {{"x", t.x()},
                    {"y", t.y()},
                    {"z", t.z()},
                    {"r11", R(0, 0)},
                    {"r12", R(1, 0)},
                    {"r13", R(2, 0)},
                    {"r21", R(0, 1)},
                    {"r22", R(1, 1)},
                    {"r23", R(2, 1)},
                    {"r31", R(0, 2)},
                    {"r32", R(1, 2)},
                    {"r33", R(2, 2)}});
  out->CloseElement();
  out->OpenElement("intrinsic");
  pushNumbers(out, {{"sensorMinU", 0},
                    {"sensorMaxU", kSubpixels * (camera.width - 1)},
                    {"sensorMinV", 0},
                    {"sensorMaxV", kSubpixels * (camera.height - 1)},
                    {"focalLengthU", K(0, 0)},
                    {"focalLengthV", K(1, 1)},
                    {"centerPointU", K(0, 2)},
                    {"centerPointV", K(1, 2)},
                    {"skew", K(0, 1)},
                    {"radialDistortion1", D[0]},
                    {"radialDistortion2", D[1]},
                    {"radialDistortion3", D[4]},
                    {"tangentalDistortion1", D[2]},
                    {"tangentalDistortion2", D[3]}});
  out->CloseElement();
  out->CloseElement();
}

}  // namespace

bool isQualisysText(const std::string& text) {
  return text.find("<calibration") != std::string::npos &&
         text.find("focalLengthU") != std::string::npos;
}

CalibrationSet readQualisysFiles(const std::vector<TextFile>& files) {
  if (files.size() != 1)
    throwFormatError(files[1].path,
                     "this is a second calibration beside " + files[0].path + ", allowed is one");
  tinyxml2::XMLDocument document;
  readXml(files[0].text, files[0].path, &document);
  CalibrationSet set;
  set.metres_per_unit = kMillimetre;
  const XMLElement& cameras = child(*document.RootElement(), "cameras", files[0].path);
  for (const XMLElement* e = cameras.FirstChildElement("camera"); e;
       e = e->NextSiblingElement("camera")) {
    const char* serial = e->Attribute("serial");
    const char* model = e->Attribute("model");
    const std::string name = serial ? serial : std::to_string(set.cameras.size() + 1);
    CameraCalibration camera;
    camera.name = name;
    const std::string where = files[0].path + ", camera '" + name + "'";
    readLens(*e, where, &camera);
    readPose(*e, where, &camera);
    set.cameras.push_back(camera);
    if (model && std::string(model).find("Marker") != std::string::npos)
      set.remarks.push_back("camera " + name + " is a marker camera (" + model + ")");
  }
  return set;
}

std::vector<TextFile> writeQualisysFiles(const std::vector<CameraCalibration>& rig) {
  tinyxml2::XMLPrinter out;
  out.PushHeader(false, true);
  out.OpenElement("calibration");
  out.PushAttribute("type", "regular");
  out.OpenElement("cameras");
  for (const CameraCalibration& camera : rig) writeCamera(camera, &out);
  out.CloseElement();
  out.CloseElement();
  return {{"", out.CStr()}};
}

}  // namespace markerless_mocap
