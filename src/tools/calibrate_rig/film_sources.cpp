#include <sensor_msgs/CompressedImage.h>
#include <sensor_msgs/Image.h>

#include <filesystem>
#include <set>
#include <stdexcept>

#include "text/joined.h"
#include "tools/calibrate_rig/film.h"
#include "tools/common/bag_io.h"
#include "tools/common/film_files.h"
#include "tools/common/foreign_topic.h"
#include "tools/common/recorded_cameras.h"

namespace markerless_mocap {
namespace {

namespace fs = std::filesystem;

/// The camera whose images a folder holds; no path if there are none.
FilmSource cameraFolder(const fs::path& folder, const std::string& video) {
  FilmSource source{folder.filename().string(), "", ""};
  if (!video.empty()) {
    if (isVideo(folder / video)) source.path = (folder / video).string();
    return source;
  }
  if (!entriesOf(folder, isPicture).empty()) {
    source.path = folder.string();
    return source;
  }
  const std::vector<fs::path> videos = entriesOf(folder, isVideo);
  if (videos.size() > 1)
    throw std::runtime_error(
        "the folder " + folder.string() + " has several videos (" +
        joined(videos, [](const fs::path& one) { return one.filename().string(); }) +
        "): name that of the board, --video NAME");
  if (!videos.empty()) source.path = videos[0].string();
  return source;
}

std::vector<FilmSource> filmsOfBag(const std::string& path) {
  rosbag::Bag bag;
  openForReading(path, bag);
  std::vector<FilmSource> films;
  for (const RecordedCamera& camera : findCameras(bag, {}, true))
    if (!camera.image_topic.empty()) films.push_back({camera.name, path, camera.image_topic});
  if (films.empty()) throw std::runtime_error("the bag " + path + " has no image topics");
  const std::string foreign = foreignTopic<sensor_msgs::Image, sensor_msgs::CompressedImage>(bag);
  if (!foreign.empty()) throw std::runtime_error("not all images can be read" + foreign);
  return films;
}

std::vector<FilmSource> filmsOfFolder(const fs::path& folder, const std::string& video) {
  std::vector<FilmSource> films;
  for (const fs::path& inner :
       entriesOf(folder, [](const fs::path& p) { return fs::is_directory(p); }))
    if (const FilmSource source = cameraFolder(inner, video); !source.path.empty())
      films.push_back(source);
  if (!films.empty()) return films;
  for (const fs::path& file : entriesOf(folder, isVideo))
    films.push_back({file.stem().string(), file.string(), ""});
  if (films.empty() && !entriesOf(folder, isPicture).empty())
    films.push_back(
        {fs::absolute(folder / "").parent_path().filename().string(), folder.string(), ""});
  if (films.empty())
    throw std::runtime_error(
        "the folder " + folder.string() +
        " has no films: wanted are a folder "
        "with pictures or a video for each camera, or a video for each camera");
  return films;
}

}  // namespace

std::vector<FilmSource> findFilms(const std::vector<std::string>& inputs,
                                  const std::string& video) {
  std::vector<FilmSource> films;
  for (const std::string& input : inputs) {
    std::vector<FilmSource> found;
    if (!fs::exists(input)) throw std::runtime_error("there is no file or folder " + input);
    if (fs::is_directory(input))
      found = filmsOfFolder(input, video);
    else if (isCalledBag(input))
      found = filmsOfBag(input);
    else
      found = {{cameraOfFilm(input, inputs), input, ""}};
    films.insert(films.end(), found.begin(), found.end());
  }
  std::set<std::string> names;
  for (const FilmSource& film : films)
    if (!names.insert(film.camera).second)
      throw std::runtime_error("two films are of a camera " + film.camera +
                               ": name the files or folders after their cameras");
  return films;
}

}  // namespace markerless_mocap
