#include "tools/export_motion/export_motion.h"

#include <algorithm>
#include <filesystem>
#include <functional>
#include <stdexcept>
#include <system_error>

#include "exports/export_formats.h"
#include "files/whole_file.h"
#include "text/joined.h"
#include "tools/common/number_format.h"
#include "tools/common/person_motion_reader.h"

namespace markerless_mocap {
namespace {

struct Format {
  const char *suffix, *help;
  const char* names;  ///< the usual ones; empty: the format has its own
  bool points;        ///< a list of points, not a skeleton
  bool says_gaps;     ///< in the file
  std::function<std::string(const PersonMotion&, const MotionExportOptions&)> write;
};

std::vector<NamedPoint> pointsOf(const MotionExportOptions& what) {
  return what.joints.empty() ? pointNames(what.names) : choosePoints(what.names, what.joints);
}

std::string stemOf(const MotionExportOptions& what) {
  return std::filesystem::path(what.output).stem().string();
}

std::string csvOf(const PersonMotion& motion, const MotionExportOptions& what) {
  return what.angles ? anglesCsvOf(motion) : pointsCsvOf(motion, pointsOf(what));
}

const std::vector<Format>& formats() {
  using Options = MotionExportOptions;
  static const std::vector<Format> all{
      {".bvh", "skeleton and motion for Blender, MotionBuilder, Maya", "motionbuilder", false,
       false,
       [](const PersonMotion& motion, const Options& what) {
         return bvhOf(motion, exportSkeleton(*motion.body, what.names), what.metres ? 1.0 : 100.0);
       }},
      {".glb", "glTF: skinned person, skeleton and motion", "motionbuilder", false, true,
       [](const PersonMotion& motion, const Options& what) {
         return glbOf(motion, exportSkeleton(*motion.body, what.names));
       }},
      {".trc", "joints as markers for OpenSim", "package", true, false,
       [](const PersonMotion& motion, const Options& what) {
         return trcOf(motion, pointsOf(what), std::filesystem::path(what.output).filename());
       }},
      {".c3d", "joints as markers for biomechanics programs", "package", true, true,
       [](const PersonMotion& motion, const Options& what) {
         return c3dOf(motion, pointsOf(what));
       }},
      {".mot", "joint angles for OpenSim", "", false, true,
       [](const PersonMotion& motion, const Options& what) { return motOf(motion, stemOf(what)); }},
      {".csv", "a table of places and rotations, or with --angles of joint angles", "package", true,
       true, csvOf},
  };
  return all;
}

const Format& formatOf(const std::string& output) {
  const std::string suffix = std::filesystem::path(output).extension();
  std::string allowed;
  for (const Format& format : formats()) {
    if (suffix == format.suffix) return format;
    addWord(&allowed, format.suffix);
  }
  throw std::invalid_argument("output is " + output + ", allowed are names that end in " + allowed);
}

void checkOptions(const Format& format, const MotionExportOptions& what) {
  const std::string suffix = format.suffix;
  const auto refuse = [&](bool given, bool has, const char* option) {
    if (given && !has)
      throw std::invalid_argument(std::string(option) + " does not apply to " + suffix + " files");
  };
  refuse(!what.names.empty(), *format.names != '\0', "--names");
  refuse(!what.joints.empty(), format.points, "--joints");
  refuse(what.metres, suffix == ".bvh", "--metres");
  refuse(what.angles, suffix == ".csv", "--angles");
  refuse(what.angles && !(what.joints.empty() && what.names.empty()), false,
         "--angles with --names or --joints");
  if (!what.names.empty()) pointNames(what.names);
  if (!what.joints.empty())
    choosePoints(what.names.empty() ? format.names : what.names, what.joints);
}

/// What a user would otherwise find out late.
void remarkOn(const PersonMotion& motion, bool animation, const std::vector<JointGap>& gaps,
              std::ostream& notes) {
  constexpr double kNoticeable_s = 1e-3, kNoticeable_m = 1e-3;
  if (motion.start_s > 0)
    notes << "the file begins at the first pose, " << formatNumber("%.3f", motion.start_s)
          << " s after the first frame of the results\n";
  const auto open = [](const JointGap& gap) { return !gap.filled; };
  if (const auto count = std::count_if(gaps.begin(), gaps.end(), open))
    notes << "joints are not seen in " << count << " stretches; "
          << (animation ? "there they keep their last rotation" : "there the file has gaps")
          << ": see --fill\n";
  if (motion.irregularity() > kNoticeable_s)
    notes << "the frames come up to " << formatNumber("%.1f", 1e3 * motion.irregularity())
          << " ms before or after equal steps, which .bvh and .c3d files have\n";
  if (const double distance = misfit(motion); distance > kNoticeable_m)
    notes << "the joints of the recording are up to " << formatNumber("%.1f", 1e3 * distance)
          << " mm from where the URDF's lengths put them: it is that of another measurement\n";
}

}  // namespace

std::string motionFormats() {
  std::string text;
  for (const Format& format : formats())
    text += std::string("  ") + format.suffix + "  " + format.help + '\n';
  return text;
}

void exportMotion(const MotionExportOptions& what, std::ostream& notes) {
  const Format& format = formatOf(what.output);
  checkOptions(format, what);
  MotionExportOptions with_names = what;
  if (what.names.empty()) with_names.names = format.names;
  PersonMotion motion = readPersonMotion(what.input, what.body_id, what.urdf);
  if (what.fill_ms > 0) fillGaps(1e-3 * what.fill_ms, &motion);
  const std::string usual = "motionbuilder";
  const ExportSkeleton skeleton =
      exportSkeleton(*motion.body, with_names.names.empty() ? usual : with_names.names);
  const std::vector<JointGap> gaps = jointGaps(motion, skeleton);
  const std::string content = format.write(motion, with_names);
  writeWholeFile(what.output, content);
  const std::string table = what.output + ".gaps.csv";
  std::error_code ignored;
  if (!format.says_gaps && !gaps.empty())
    writeWholeFile(table, gapsCsvOf(motion, skeleton));
  else
    std::filesystem::remove(table, ignored);  // of an earlier file of this name
  remarkOn(motion, !format.points && *format.names != '\0', gaps, notes);
}

}  // namespace markerless_mocap
