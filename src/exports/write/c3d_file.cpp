#include <algorithm>
#include <cmath>
#include <cstring>

#include "exports/export_formats.h"

// The C3D file format, https://www.c3d.org/docs/C3D_User_Guide.pdf
namespace markerless_mocap {
namespace {

constexpr size_t kBlock = 512;        // bytes
constexpr double kMillimetres = 1e3;  // per metre
constexpr size_t kMaxPoints = 255;    // a dimension is a byte
constexpr char kIntel = 84;
constexpr size_t kMaxFrames = 65535;  // of the 16 bit counts; longer films have 32 bits beside them

template <class Value>
void append(Value value, std::string* bytes) {
  bytes->append(reinterpret_cast<const char*>(&value), sizeof value);
}

template <class Value>
void put(Value value, size_t word, std::string* bytes) {  // words count from 1
  std::memcpy(&(*bytes)[2 * (word - 1)], &value, sizeof value);
}

void padToBlock(std::string* bytes) {
  bytes->resize((bytes->size() + kBlock - 1) / kBlock * kBlock, '\0');
}

std::vector<std::string> namesOf(const std::vector<NamedPoint>& points) {
  std::vector<std::string> names;
  for (const NamedPoint& point : points) names.push_back(point.name);
  return names;
}

/// Groups and their parameters.
class ParameterSection {
 public:
  void group(const std::string& name) {
    entry(name, -++groups_);
    finish("");
  }
  void integers(const std::string& name, const std::vector<uint16_t>& values) {
    std::string data;
    for (const uint16_t value : values) append(value, &data);
    parameter(name, 2, values.size() == 1 ? "" : std::string(1, char(values.size())), data);
  }
  void number(const std::string& name, float value) {
    std::string data;
    append(value, &data);
    parameter(name, 4, "", data);
  }
  void texts(const std::string& name, const std::vector<std::string>& texts) {
    size_t length = 1;
    for (const std::string& text : texts) length = std::max(length, text.size());
    std::string data;
    for (std::string text : texts) {
      text.resize(length, ' ');
      data += text;
    }
    parameter(name, -1, {char(length), char(texts.size())}, data);
  }
  /// With its header of four bytes, in whole blocks.
  std::string bytes() const {
    std::string out{1, 0x50, 0, kIntel};
    out += entries_;
    out += std::string(2, '\0');  // no name: the end
    padToBlock(&out);
    out[2] = char(out.size() / kBlock);
    return out;
  }

 private:
  void entry(const std::string& name, int group) {
    entries_ += char(name.size());
    entries_ += char(group);
    entries_ += name;
  }
  /// The offset to the next entry, the content, an empty description.
  void finish(const std::string& content) {
    append(uint16_t(2 + content.size() + 1), &entries_);
    entries_ += content + '\0';
  }
  void parameter(const std::string& name, int type, const std::string& sizes,
                 const std::string& data) {
    entry(name, groups_);
    finish(std::string{char(type), char(sizes.size())} + sizes + data);
  }

  int groups_ = 0;
  std::string entries_;
};

std::string parametersOf(const PersonMotion& motion, const std::vector<NamedPoint>& points,
                         uint16_t data_block) {
  const size_t frames = motion.frames.size();
  const float rate = float(1.0 / motion.frameTime());
  ParameterSection out;
  out.group("POINT");
  out.integers("USED", {uint16_t(points.size())});
  out.number("SCALE", -1.0f);  // negative: numbers are floats
  out.number("RATE", rate);
  out.integers("DATA_START", {data_block});
  out.integers("FRAMES", {uint16_t(std::min(frames, kMaxFrames))});
  out.number("LONG_FRAMES", float(frames));
  out.texts("LABELS", namesOf(points));
  out.texts("DESCRIPTIONS", namesOf(points));
  out.texts("UNITS", {"mm"});
  out.texts("X_SCREEN", {"+X"});
  out.texts("Y_SCREEN", {"+Z"});
  out.group("ANALOG");
  out.integers("USED", {0});
  out.number("GEN_SCALE", 1.0f);
  out.number("RATE", rate);
  out.group("FORCE_PLATFORM");
  out.integers("USED", {0});
  out.group("TRIAL");  // 32 bits, the low word first
  out.integers("ACTUAL_START_FIELD", {1, 0});
  out.integers("ACTUAL_END_FIELD", {uint16_t(frames & 0xffff), uint16_t(frames >> 16)});
  out.number("CAMERA_RATE", rate);
  return out.bytes();
}

std::string headerOf(const PersonMotion& motion, size_t points, uint16_t data_block) {
  std::string out(kBlock, '\0');
  out[0] = 2;  // block of the parameters
  out[1] = 0x50;
  put(uint16_t(points), 2, &out);
  put(uint16_t(1), 4, &out);
  put(uint16_t(std::min(motion.frames.size(), kMaxFrames)), 5, &out);
  put(uint16_t(std::lround(motion.fill_s / motion.frameTime())), 6, &out);
  put(-1.0f, 7, &out);
  put(data_block, 9, &out);
  put(float(1.0 / motion.frameTime()), 11, &out);
  return out;
}

float residualOf(const NamedPoint& point, const BodyModel& body, const PersonFrame& frame) {
  constexpr double kLargest = 255.0;
  if (frame.filled[size_t(linkOf(point, body))]) return 0.0f;
  const double error = kMillimetres * expectedError(point, frame);
  return std::isfinite(error) ? float(std::clamp(std::round(error), 1.0, kLargest)) : 1.0f;
}

}  // namespace

std::string c3dOf(const PersonMotion& motion, const std::vector<NamedPoint>& points) {
  if (points.size() > kMaxPoints) throw std::invalid_argument("a C3D file holds up to 255 points");
  const uint16_t data_block = uint16_t(2 + parametersOf(motion, points, 0).size() / kBlock);
  std::string out =
      headerOf(motion, points.size(), data_block) + parametersOf(motion, points, data_block);
  for (const PersonFrame& frame : motion.frames) {
    const Eigen::Matrix3Xd places = kMillimetres * placesOf(points, *motion.body, frame);
    for (size_t i = 0; i < points.size(); ++i) {
      const Eigen::Vector3d place = places.col(Eigen::Index(i));
      const bool known = place.allFinite();
      for (int axis = 0; axis < 3; ++axis) append(known ? float(place[axis]) : 0.0f, &out);
      append(known ? residualOf(points[i], *motion.body, frame) : -1.0f, &out);
    }
  }
  padToBlock(&out);
  return out;
}

}  // namespace markerless_mocap
