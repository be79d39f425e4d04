#pragma once

#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include "markerless_mocap/formats/calibration_files.h"

namespace markerless_mocap {

/// A file of a calibration.
struct TextFile {
  std::string path;
  std::string text;
};

/// How one format is told, read and written. Functions throw std::invalid_argument.
struct CalibrationLayout {
  CalibrationFormat format;
  const char* name;
  const char* title;
  /// Whether a text is a file of this format, right or wrong in detail.
  bool (*recognises)(const std::string& text);
  CalibrationSet (*read)(const std::vector<TextFile>& files);
  /// Files with paths relative to the folder, or one with an empty path.
  std::vector<TextFile> (*write)(const std::vector<CameraCalibration>& rig);
  /// As read, but without poses where the files have none; nullptr: this format always has poses.
  CalibrationSet (*read_lenses)(const std::vector<TextFile>& files) = nullptr;
};

/// In the order in which they are tried.
const std::vector<CalibrationLayout>& calibrationLayouts();

bool isRigText(const std::string& text);
CalibrationSet readRigFiles(const std::vector<TextFile>& files);
std::vector<TextFile> writeRigFiles(const std::vector<CameraCalibration>& rig);

bool isRosText(const std::string& text);
CalibrationSet readRosFiles(const std::vector<TextFile>& files);
CalibrationSet readRosLenses(const std::vector<TextFile>& files);
std::vector<TextFile> writeRosFiles(const std::vector<CameraCalibration>& rig);

bool isKalibrText(const std::string& text);
CalibrationSet readKalibrFiles(const std::vector<TextFile>& files);
std::vector<TextFile> writeKalibrFiles(const std::vector<CameraCalibration>& rig);

bool isEasyMocapText(const std::string& text);
CalibrationSet readEasyMocapFiles(const std::vector<TextFile>& files);
std::vector<TextFile> writeEasyMocapFiles(const std::vector<CameraCalibration>& rig);

bool isOpenCvText(const std::string& text);
CalibrationSet readOpenCvFiles(const std::vector<TextFile>& files);
CalibrationSet readOpenCvLenses(const std::vector<TextFile>& files);
std::vector<TextFile> writeOpenCvFiles(const std::vector<CameraCalibration>& rig);

bool isMatrixText(const std::string& text);
CalibrationSet readMatrixFiles(const std::vector<TextFile>& files);
std::vector<TextFile> writeMatrixFiles(const std::vector<CameraCalibration>& rig);

bool isQualisysText(const std::string& text);
CalibrationSet readQualisysFiles(const std::vector<TextFile>& files);
std::vector<TextFile> writeQualisysFiles(const std::vector<CameraCalibration>& rig);

/// All four TOML layouts are told apart while they are read.
bool isTomlText(const std::string& text);
CalibrationSet readTomlFiles(const std::vector<TextFile>& files);
std::vector<TextFile> writeAniposeFiles(const std::vector<CameraCalibration>& rig);
std::vector<TextFile> writeCaliscopeFiles(const std::vector<CameraCalibration>& rig);
std::vector<TextFile> writeFreeMoCapFiles(const std::vector<CameraCalibration>& rig);
std::vector<TextFile> writePose2SimFiles(const std::vector<CameraCalibration>& rig);

bool isColmapText(const std::string& text);
CalibrationSet readColmapFiles(const std::vector<TextFile>& files);
std::vector<TextFile> writeColmapFiles(const std::vector<CameraCalibration>& rig);

}  // namespace markerless_mocap
