#pragma once

#include <Eigen/Core>
#include <map>
#include <opencv2/core/mat.hpp>
#include <string>
#include <vector>

struct aiMaterial;
struct aiMesh;
struct aiScene;

namespace markerless_mocap {

/// What a model's meshes look like at their vertices.
class MaterialColors {
 public:
  /// \param path of the model: textures are looked for beside it
  MaterialColors(const aiScene& scene, const std::string& path) : scene_(scene), path_(path) {}

  /// Red green blue of each vertex, 0 to 1: the base colour texture's, else the vertex's own, else
  /// the material's. A texture that cannot be read counts as none.
  std::vector<Eigen::Vector3f> of(const aiMesh& mesh);

 private:
  /// Of the material's base colour; empty if there is none. \param channel of the coordinates
  const cv::Mat& texture(const aiMaterial& material, unsigned& channel);
  cv::Mat readTexture(const std::string& name) const;

  const aiScene& scene_;
  std::string path_;
  std::map<std::string, cv::Mat> textures_;
};

}  // namespace markerless_mocap
