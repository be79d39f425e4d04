#pragma once

#include <unistd.h>

#include <filesystem>
#include <stdexcept>
#include <string>

namespace markerless_mocap {

/// Before work that takes long: throws std::runtime_error unless files can be written into the
/// folder, or it can be made. Makes nothing.
inline void checkOutputFolder(const std::string& folder) {
  namespace fs = std::filesystem;
  std::error_code error;
  fs::path there = fs::absolute(folder, error);
  if (folder.empty() || error) throw std::runtime_error("the name of the output folder is empty");
  while (fs::symlink_status(there, error).type() == fs::file_type::not_found &&
         there.has_relative_path())
    there = there.parent_path();
  if (!fs::is_directory(there, error))
    throw std::runtime_error("cannot write the folder " + folder + ": " + there.string() +
                             " is no folder");
  if (access(there.c_str(), W_OK | X_OK) != 0)
    throw std::runtime_error("cannot write the folder " + folder + ": " + there.string() +
                             " may not be written");
}

}  // namespace markerless_mocap
