#include "tools/common/film_files.h"

#include <string.h>

#include <algorithm>
#include <cctype>
#include <set>
#include <stdexcept>

namespace markerless_mocap {
namespace {

namespace fs = std::filesystem;

bool hasEnding(const fs::path& path, const std::set<std::string>& endings) {
  std::string ending = path.extension().string();
  for (char& c : ending) c = char(std::tolower(static_cast<unsigned char>(c)));
  return endings.count(ending) > 0;
}

}  // namespace

bool isVideo(const fs::path& path) {
  static const std::set<std::string> endings{".mp4", ".avi",  ".mov", ".mkv",  ".webm", ".m4v",
                                             ".mpg", ".mpeg", ".mts", ".m2ts", ".wmv",  ".3gp"};
  return fs::is_regular_file(path) && hasEnding(path, endings);
}

bool isPicture(const fs::path& path) {
  static const std::set<std::string> endings{".png",  ".jpg", ".jpeg", ".bmp", ".tif",
                                             ".tiff", ".pgm", ".pbm",  ".ppm", ".webp"};
  return fs::is_regular_file(path) && hasEnding(path, endings);
}

bool isCalledBag(const fs::path& path) {
  return hasEnding(path, {".bag"});
}

std::string cameraOfFilm(const std::string& film, const std::vector<std::string>& films) {
  const fs::path path = film;
  const auto alike = std::count_if(films.begin(), films.end(), [&](const fs::path& other) {
    return other.stem() == path.stem();
  });
  return (alike > 1 ? fs::absolute(path).parent_path().filename() : path.stem()).string();
}

std::vector<fs::path> entriesOf(const fs::path& folder,
                                const std::function<bool(const fs::path&)>& accepts) {
  std::vector<fs::path> entries;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error))
    if (accepts(entry.path())) entries.push_back(entry.path());
  if (error) throw std::runtime_error("cannot read the folder " + folder.string());
  std::sort(entries.begin(), entries.end(), [](const fs::path& a, const fs::path& b) {
    return strverscmp(a.c_str(), b.c_str()) < 0;
  });
  return entries;
}

}  // namespace markerless_mocap
