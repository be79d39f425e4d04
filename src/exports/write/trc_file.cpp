#include "exports/export_formats.h"
#include "exports/write/axes.h"
#include "exports/write/number_text.h"

namespace markerless_mocap {
namespace {

constexpr double kMillimetres = 1e3;  // per metre

/// The four lines of the header after the first, and the empty one.
std::string headerText(const PersonMotion& motion, const std::vector<NamedPoint>& points) {
  const std::string rate = numberText(1.0 / motion.frameTime(), 4);
  const std::string frames = std::to_string(motion.frames.size());
  std::string out =
      "DataRate\tCameraRate\tNumFrames\tNumMarkers\tUnits\tOrigDataRate\tOrigDataStartFrame\t"
      "OrigNumFrames\n" +
      rate + '\t' + rate + '\t' + frames + '\t' + std::to_string(points.size()) + "\tmm\t" + rate +
      "\t1\t" + frames + "\nFrame#\tTime";
  for (const NamedPoint& point : points) out += '\t' + point.name + "\t\t";
  out += "\n\t";
  for (size_t i = 1; i <= points.size(); ++i)
    for (const char axis : {'X', 'Y', 'Z'}) out += '\t' + (axis + std::to_string(i));
  return out + "\n\n";
}

}  // namespace

std::string trcOf(const PersonMotion& motion, const std::vector<NamedPoint>& points,
                  const std::string& file_name) {
  std::string out = "PathFileType\t4\t(X/Y/Z)\t" + file_name + '\n' + headerText(motion, points);
  for (size_t f = 0; f < motion.frames.size(); ++f) {
    const Eigen::Matrix3Xd places =
        kMillimetres * opensimFromWorld() * placesOf(points, *motion.body, motion.frames[f]);
    out += std::to_string(f + 1) + '\t' + numberText(motion.seconds(f), 6);
    for (Eigen::Index i = 0; i < places.size(); ++i)
      out += '\t' + numberOrNothing(places.data()[i], 4);
    out += '\n';
  }
  return out;
}

}  // namespace markerless_mocap
