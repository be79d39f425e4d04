#include "markerless_mocap/formats/calibration_files.h"

#include <string.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>
#include <sstream>

#include "files/text_file.h"
#include "files/whole_file.h"
#include "formats/parts/camera_parts.h"
#include "markerless_mocap/camera/rig_file.h"
#include "text/joined.h"

namespace markerless_mocap {
namespace {

namespace fs = std::filesystem;

constexpr uintmax_t kLargestFile = 64u << 20;  // bytes; COLMAP's images.txt lists points

const CalibrationLayout& layoutOf(CalibrationFormat format) {
  const auto& layouts = calibrationLayouts();
  return *std::find_if(layouts.begin(), layouts.end(),
                       [&](const CalibrationLayout& layout) { return layout.format == format; });
}

std::string titles() {
  return joined(calibrationLayouts(), [](const CalibrationLayout& one) { return one.title; });
}

std::string textOf(const std::string& path) {
  return readTextFile(path, path);
}

/// The layout that a text belongs to; nullptr if there is none.
const CalibrationLayout* layoutOfText(const std::string& text) {
  if (text.find('\0') != std::string::npos) return nullptr;
  for (const CalibrationLayout& layout : calibrationLayouts())
    if (layout.recognises(text)) return &layout;
  return nullptr;
}

/// Files and their one layout.
struct Found {
  const CalibrationLayout* layout = nullptr;
  std::vector<TextFile> files;

  /// Throws if the layout is not that of the files before.
  void add(const std::string& path, const CalibrationLayout* other, std::string text) {
    if (layout && other != layout)
      throwFormatError(path, std::string("this is ") + other->title + ", but " + files[0].path +
                                 " is " + layout->title + ": name the one to read");
    layout = other;
    files.push_back({path, std::move(text)});
  }
};

/// In the order of names with numbers by their value.
std::vector<fs::path> entriesOf(const std::string& folder) {
  std::vector<fs::path> entries;
  for (const auto& entry : fs::directory_iterator(folder)) entries.push_back(entry.path());
  std::sort(entries.begin(), entries.end(), [](const fs::path& a, const fs::path& b) {
    return strverscmp(a.c_str(), b.c_str()) < 0;
  });
  return entries;
}

/// Adds the calibrations among the files of a folder; returns whether there are any.
bool addFilesOf(const std::string& folder, Found* found) {
  const size_t before = found->files.size();
  for (const fs::path& path : entriesOf(folder)) {
    std::error_code error;
    if (!fs::is_regular_file(path) || fs::file_size(path, error) > kLargestFile) continue;
    std::string text = textOf(path.string());
    if (const CalibrationLayout* layout = layoutOfText(text))
      found->add(path.string(), layout, std::move(text));
  }
  return found->files.size() > before;
}

void addFolder(const std::string& folder, Found* found) {
  bool any = addFilesOf(folder, found);
  if (!any)
    for (const fs::path& path : entriesOf(folder))
      if (fs::is_directory(path)) any = addFilesOf(path.string(), found) || any;
  if (any) return;
  const bool binary_model = fs::exists(fs::path(folder) / "cameras.bin");
  throwFormatError(folder, binary_model
                               ? "COLMAP's model is binary, allowed is text: colmap "
                                 "model_converter --output_type TXT"
                               : "there is no calibration in this folder, allowed are " + titles());
}

void addFile(const std::string& path, Found* found) {
  std::string text = textOf(path);
  const CalibrationLayout* layout = layoutOfText(text);
  if (!layout)
    throwFormatError(path, "this is no calibration of a known format, allowed are " + titles());
  found->add(path, layout, std::move(text));
}

void writeText(const TextFile& file) {
  const fs::path folder = fs::path(file.path).parent_path();
  std::error_code error;
  if (!folder.empty()) fs::create_directories(folder, error);
  writeWholeFile(file.path, file.text);
}

/// Coefficients that are zero, and lists shorter than OpenCV's.
void tidyLens(CameraCalibration* camera) {
  std::vector<double>& D = camera->D;
  if (camera->lens == LensType::kFisheye) {
    while (D.size() > 4 && D.back() == 0.0) D.pop_back();
    return;
  }
  while (D.size() > 8 && D.back() == 0.0) D.pop_back();
  if (!D.empty() && D.size() < 4) D.resize(4, 0.0);
  if (D.size() == 6 || D.size() == 7) D.resize(8, 0.0);
}

/// For a lens to be judged where the format leaves the size open: the lens's centre is that of the
/// image, nearly.
void guessSize(CameraCalibration* camera) {
  constexpr double kMost = 10000;
  const auto twice = [&](double centre) {
    return std::isfinite(centre) ? int(std::clamp(std::round(2 * centre), 1.0, kMost)) : 1;
  };
  camera->width = twice(camera->K(0, 2));
  camera->height = twice(camera->K(1, 2));
}

/// Throws if a camera is not valid or two have one name. The size may be unknown.
void check(const std::vector<CameraCalibration>& cameras, const std::string& where) {
  if (cameras.empty()) throwFormatError(where, "the calibration has no cameras");
  std::set<std::string> names;
  for (CameraCalibration camera : cameras) {
    if (!names.insert(camera.name).second)
      throwFormatError(where, "two cameras are named '" + camera.name + "'");
    if (camera.width == 0 && camera.height == 0) guessSize(&camera);
    try {
      camera.validate();
    } catch (const std::invalid_argument& error) {
      throwFormatError(where, error.what());
    }
  }
}

CalibrationSet readFiles(const std::vector<std::string>& paths, bool with_poses) {
  if (paths.empty()) throw std::invalid_argument("no calibration is given");
  Found found;
  for (const std::string& path : paths)
    fs::is_directory(path) ? addFolder(path, &found) : addFile(path, &found);
  const CalibrationLayout& layout = *found.layout;
  CalibrationSet set = !with_poses && layout.read_lenses ? layout.read_lenses(found.files)
                                                         : layout.read(found.files);
  if (set.format == CalibrationFormat::kRig) set.format = found.layout->format;
  for (CameraCalibration& camera : set.cameras) tidyLens(&camera);
  check(set.cameras, paths.front());
  return set;
}

}  // namespace

const char* nameOf(CalibrationFormat format) {
  return layoutOf(format).name;
}

const char* titleOf(CalibrationFormat format) {
  return layoutOf(format).title;
}

CalibrationFormat calibrationFormatNamed(const std::string& name) {
  std::string known;
  for (const CalibrationLayout& layout : calibrationLayouts()) {
    if (name == layout.name) return layout.format;
    addWord(&known, layout.name);
  }
  throw std::invalid_argument("there is no calibration format '" + name + "', allowed are " +
                              known);
}

CalibrationSet readCalibration(const std::vector<std::string>& paths) {
  return readFiles(paths, true);
}

CalibrationSet readLenses(const std::vector<std::string>& paths) {
  return readFiles(paths, false);
}

CameraCalibration readCameraCalibration(const std::string& path) {
  const CalibrationSet set = readCalibration({path});
  if (set.cameras.size() != 1)
    throwFormatError(path,
                     "this has " + std::to_string(set.cameras.size()) + " cameras, allowed is one");
  return set.cameras.front();
}

std::vector<std::string> writeCalibration(const std::string& path, CalibrationFormat format,
                                          const std::vector<CameraCalibration>& rig,
                                          bool overwrite) {
  rigText(rig);  // throws if the rig is not valid
  std::vector<TextFile> files = layoutOf(format).write(rig);
  for (TextFile& file : files) {
    file.path = (file.path.empty() ? fs::path(path) : fs::path(path) / file.path).string();
    if (!overwrite && fs::exists(file.path))
      throw std::runtime_error(file.path + " exists and is not overwritten");
  }
  std::vector<std::string> written;
  for (const TextFile& file : files) {
    writeText(file);
    written.push_back(file.path);
  }
  return written;
}

}  // namespace markerless_mocap
