#pragma once

#include <map>
#include <string>
#include <vector>

namespace markerless_mocap {

/// Times of the images of each film, by its name, seconds, ascending.
using FrameTimes = std::map<std::string, std::vector<double>>;

/// The table of times that other programs write beside films.
constexpr char kTimesBesideFilms[] = "timestamps.csv";

/// Times of the frames of each film: a CSV file with a head line and the columns cam_id (or port,
/// or camera) and frame_time; others are ignored. Films and cameras belong together as
/// matchNames() says. Throws std::runtime_error if the file cannot be read, and
/// std::invalid_argument with the line if it is something else.
FrameTimes readFrameTimes(const std::string& path, const std::vector<std::string>& films);

/// The names of `wanted` among `names`, each one once: the same name, or else the one with the same
/// number ("cam_0" and "0", "cam01" and "Camera_001"). Throws std::invalid_argument with both lists
/// if a name has none.
/// \param what such as "camera of the calibration", for the message
std::vector<std::string> matchNames(const std::vector<std::string>& wanted,
                                    const std::vector<std::string>& names, const std::string& what);

/// Whether a name is called like one of others, as matchNames() means it.
bool isCalledLikeOne(const std::string& name, const std::vector<std::string>& others);

/// The first of some files that is there in a folder of the inputs; empty if there is none.
std::string fileBesideFilms(const std::vector<std::string>& inputs,
                            const std::vector<std::string>& names);

}  // namespace markerless_mocap
