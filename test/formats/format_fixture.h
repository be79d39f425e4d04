#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "error_text_of.h"
#include "markerless_mocap/formats/calibration_files.h"

namespace markerless_mocap {

/// A folder of its own for each test, removed afterwards.
class FormatTest : public ::testing::Test {
 protected:
  FormatTest() : folder_(std::filesystem::temp_directory_path() / name()) {
    std::filesystem::create_directories(folder_);
  }
  ~FormatTest() override { std::filesystem::remove_all(folder_); }

  std::string path(const std::string& file) const { return (folder_ / file).string(); }
  std::string write(const std::string& file, const std::string& text) const {
    std::filesystem::create_directories((folder_ / file).parent_path());
    std::ofstream(path(file)) << text;
    return path(file);
  }
  /// What reading these files is refused with, without the folder's name.
  std::string refusal(const std::vector<std::string>& paths) const {
    std::string text = errorTextOf<std::exception>([&] { readCalibration(paths); });
    const std::string folder = folder_.string() + "/";
    for (size_t at = text.find(folder); at != std::string::npos; at = text.find(folder))
      text.erase(at, folder.size());
    return text;
  }

 private:
  static std::string name() {
    const auto* info = ::testing::UnitTest::GetInstance()->current_test_info();
    std::string name = std::string("mocap_") + info->test_suite_name() + "_" + info->name() + "_" +
                       std::to_string(getpid());
    for (char& c : name)
      if (c == '/') c = '_';
    return name;
  }

  std::filesystem::path folder_;
};

}  // namespace markerless_mocap
