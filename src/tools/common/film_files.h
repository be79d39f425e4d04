#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace markerless_mocap {

/// Whether a path is a file that is called like a video.
bool isVideo(const std::filesystem::path& path);

/// Whether a path is a file that is called like a picture.
bool isPicture(const std::filesystem::path& path);

/// Whether a path is called like a bag.
bool isCalledBag(const std::filesystem::path& path);

/// The camera of a film among others: named as the file, or as its folder if another film has a
/// file of that name (cam1/video.avi, cam2/video.avi).
std::string cameraOfFilm(const std::string& film, const std::vector<std::string>& films);

/// What a folder holds, in the order of names; numbers in them count as numbers ("9" before "10").
/// Throws std::runtime_error if the folder cannot be read.
std::vector<std::filesystem::path> entriesOf(
    const std::filesystem::path& folder,
    const std::function<bool(const std::filesystem::path&)>& accepts);

}  // namespace markerless_mocap
