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

/// Vertex colours of a model's meshes.
class MaterialColors {
 public:
  /// \param path path of the model; textures are searched beside it
  MaterialColors(const aiScene& scene, const std::string& path) : scene_(scene), path_(path) {}

  /// Red, green and blue of each vertex, 0 to 1: from the base colour texture, else the vertex's
  /// own colour, else the material's. A texture that cannot be read is ignored.
  std::vector<Eigen::Vector3f> of(const aiMesh& mesh);

 private:
  /// Texture of the material's base colour; empty if there is none.
  /// \param channel output, channel of the texture coordinates
  const cv::Mat& texture(const aiMaterial& material, unsigned& channel);
  cv::Mat readTexture(const std::string& name) const;

  const aiScene& scene_;
  std::string path_;
  std::map<std::string, cv::Mat> textures_;
};

}  // namespace markerless_mocap
