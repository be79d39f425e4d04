#include "tools/common/film_files.h"

#include "tools/calibrate_rig/film.h"
#include "tools/import/film.h"
#include "tools/tool_fixture.h"

namespace markerless_mocap {
namespace {

class FilmFiles : public ToolTest {
 protected:
  std::vector<std::string> namesOf(const std::vector<std::filesystem::path>& paths) const {
    std::vector<std::string> names;
    for (const auto& one : paths) names.push_back(one.filename().string());
    return names;
  }
};

TEST_F(FilmFiles, PicturesComeInTheOrderOfTheirNumbers) {
  for (const char* name : {"view10.png", "view9.JPG", "view100.webp", "notes.txt", "film.mp4"})
    writeText(name, "");
  std::filesystem::create_directories(path("folder.png"));
  EXPECT_EQ(namesOf(entriesOf(folder_, isPicture)),
            (std::vector<std::string>{"view9.JPG", "view10.png", "view100.webp"}));
}

/// As a shell writes them: cam*/video.avi.
TEST_F(FilmFiles, FilmsOfOneNameAreOfTheCamerasOfTheirFolders) {
  std::vector<std::string> films;
  for (const char* camera : {"cam1", "cam2"}) {
    writeText(std::string(camera) + "/video.avi", "");
    films.push_back(path(std::string(camera) + "/video.avi"));
  }
  for (size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(findFilms(films, "").at(i).camera, "cam" + std::to_string(i + 1));
    EXPECT_EQ(filmsIn(films).at(i).name, "cam" + std::to_string(i + 1));
  }
  EXPECT_EQ(filmsIn({films[0]}).at(0).name, "video");
}

TEST_F(FilmFiles, ImportAndCalibrationFindTheSameFilms) {
  for (const char* name : {"films/cam9.mpeg", "films/cam10.MTS", "films/cam11.wmv",
                           "films/notes.txt", "cameras/cam12/1.pbm", "cameras/cam13/1.webp"})
    writeText(name, "");
  const auto found = [&](const std::string& folder) {
    std::vector<std::string> names, of_import;
    for (const FilmSource& film : findFilms({folder}, "")) names.push_back(film.camera);
    for (const NamedFilm& film : filmsIn({folder})) of_import.push_back(film.name);
    EXPECT_EQ(names, of_import);
    return names;
  };
  EXPECT_EQ(found(path("films")), (std::vector<std::string>{"cam9", "cam10", "cam11"}));
  EXPECT_EQ(found(path("cameras")), (std::vector<std::string>{"cam12", "cam13"}));
}

}  // namespace
}  // namespace markerless_mocap
