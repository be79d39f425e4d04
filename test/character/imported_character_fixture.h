#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <assimp/Exporter.hpp>
#include <filesystem>
#include <stdexcept>
#include <string>

#include "character/imported_character.h"
#include "character/imported_character_scene.h"
#include "error_text_of.h"

namespace markerless_mocap {

constexpr double kStature = 1.7;

struct Format {
  const char* id;
  const char* ending;
};
inline void PrintTo(const Format& format, std::ostream* stream) {
  *stream << format.ending;
}
constexpr Format kGltf{"gltf2", ".gltf"}, kGlb{"glb2", ".glb"}, kCollada{"collada", ".dae"},
    kFbx{"fbxa", ".fbx"};

class Imported : public testing::Test {
 protected:
  Imported() : folder_(testing::TempDir() + "imported_" + std::to_string(getpid())) {
    std::filesystem::create_directory(folder_);
  }
  ~Imported() override { std::filesystem::remove_all(folder_); }

  std::string file(const std::string& name) const { return folder_ + "/" + name; }

  std::string write(const BoxMan& man, const Format& format = kGltf) const {
    const std::string path = file(std::string("man") + format.ending);
    const BoxManScene scene(man);
    Assimp::Exporter exporter;
    EXPECT_EQ(exporter.Export(&scene.scene(), format.id, path), AI_SUCCESS)
        << exporter.GetErrorString();
    return path;
  }

  Character import(const BoxMan& man, const Format& format = kGltf) const {
    return importCharacter(write(man, format), kStature);
  }

  std::string faultOf(const std::string& path, double stature = kStature) const {
    const std::string sentence = errorTextOf([&] { importCharacter(path, stature); });
    EXPECT_EQ(sentence.rfind(path + ": ", 0), 0u) << sentence;
    return sentence.substr(std::min(path.size() + 2, sentence.size()));
  }

 private:
  std::string folder_;
};

inline Bone heaviest(const VertexWeights& vertex) {
  const auto most = std::max_element(vertex.weights.begin(), vertex.weights.end());
  return vertex.bones[size_t(most - vertex.weights.begin())];
}

}  // namespace markerless_mocap
