#include "character/import/material_colors.h"

#include <assimp/material.h>
#include <assimp/scene.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <opencv2/imgcodecs.hpp>

namespace markerless_mocap {
namespace {

using Eigen::Vector3f;

/// Converts a linear colour for display. Base colours of glTF are linear; colours of images and
/// other formats are not.
Vector3f displayed(const aiColor4D& linear) {
  const auto channel = [](float c) { return std::pow(std::clamp(c, 0.0f, 1.0f), 1.0f / 2.2f); };
  return {channel(linear.r), channel(linear.g), channel(linear.b)};
}

/// The material's own colour; white if it has a texture.
Vector3f plainColor(const aiMaterial& material, bool textured) {
  aiColor4D color;
  if (material.Get(AI_MATKEY_BASE_COLOR, color) == AI_SUCCESS) return displayed(color);
  if (textured) return Vector3f::Ones();
  if (material.Get(AI_MATKEY_COLOR_DIFFUSE, color) == AI_SUCCESS)
    return Vector3f(color.r, color.g, color.b).cwiseMax(0.0f).cwiseMin(1.0f);
  return Vector3f::Constant(0.6f);
}

/// Colour of an image at texture coordinates u, v, which start at the lower left corner; the image
/// repeats.
Vector3f sampled(const cv::Mat& image, float u, float v) {
  if (!std::isfinite(u) || !std::isfinite(v)) return Vector3f::Ones();
  const auto pixel = [](float fraction, int size) {
    return std::min(int((fraction - std::floor(fraction)) * float(size)), size - 1);
  };
  const cv::Vec3b& bgr = image.at<cv::Vec3b>(pixel(1.0f - v, image.rows), pixel(u, image.cols));
  return Vector3f(bgr[2], bgr[1], bgr[0]) / 255.0f;
}

cv::Mat embeddedImage(const aiTexture& texture) {
  if (texture.mHeight == 0) {
    const cv::Mat bytes(1, int(texture.mWidth), CV_8U, texture.pcData);
    try {
      return cv::imdecode(bytes, cv::IMREAD_COLOR);
    } catch (const cv::Exception&) {  // too large
      return cv::Mat();
    }
  }
  cv::Mat image(int(texture.mHeight), int(texture.mWidth), CV_8UC3);
  for (int i = 0; i < image.rows * image.cols; ++i) {
    const aiTexel& texel = texture.pcData[i];
    image.at<cv::Vec3b>(i / image.cols, i % image.cols) = {texel.b, texel.g, texel.r};
  }
  return image;
}

/// "skin%20colour.png" -> "skin colour.png"
std::string withoutEscapes(const std::string& name) {
  std::string plain;
  for (size_t i = 0; i < name.size(); ++i) {
    if (name[i] == '%' && i + 2 < name.size() &&
        isxdigit(static_cast<unsigned char>(name[i + 1])) &&
        isxdigit(static_cast<unsigned char>(name[i + 2]))) {
      plain += char(std::stoi(name.substr(i + 1, 2), nullptr, 16));
      i += 2;
    } else {
      plain += name[i] == '\\' ? '/' : name[i];
    }
  }
  return plain;
}

}  // namespace

cv::Mat MaterialColors::readTexture(const std::string& name) const {
  if (const aiTexture* embedded = scene_.GetEmbeddedTexture(name.c_str()))
    return embeddedImage(*embedded);
  // If the path does not exist on this machine, the file of that name beside the model is used.
  const std::filesystem::path folder = std::filesystem::path(path_).parent_path();
  for (const std::string& file_name : {name, withoutEscapes(name)})
    for (const std::filesystem::path& file :
         {folder / file_name, folder / std::filesystem::path(file_name).filename()})
      if (std::filesystem::is_regular_file(file)) return cv::imread(file, cv::IMREAD_COLOR);
  return {};
}

const cv::Mat& MaterialColors::texture(const aiMaterial& material, unsigned& channel) {
  aiString name;
  for (aiTextureType type : {aiTextureType_BASE_COLOR, aiTextureType_DIFFUSE}) {
    if (material.GetTexture(type, 0, &name, nullptr, &channel) != AI_SUCCESS) continue;
    const auto known = textures_.find(name.C_Str());
    if (known != textures_.end()) return known->second;
    return textures_[name.C_Str()] = readTexture(name.C_Str());
  }
  return textures_[""];
}

std::vector<Vector3f> MaterialColors::of(const aiMesh& mesh) {
  const aiMaterial& material = *scene_.mMaterials[mesh.mMaterialIndex];
  unsigned channel = 0;
  const cv::Mat& image = texture(material, channel);
  if (channel >= AI_MAX_NUMBER_OF_TEXTURECOORDS) channel = 0;
  const bool textured = !image.empty() && mesh.HasTextureCoords(channel);
  std::vector<Vector3f> colors(mesh.mNumVertices, plainColor(material, textured));
  for (unsigned v = 0; v < mesh.mNumVertices; ++v) {
    if (textured) {
      const aiVector3D& place = mesh.mTextureCoords[channel][v];
      colors[v] = colors[v].cwiseProduct(sampled(image, place.x, place.y));
    } else if (mesh.HasVertexColors(0)) {
      const aiColor4D& own = mesh.mColors[0][v];
      colors[v] = Vector3f(own.r, own.g, own.b).cwiseMax(0.0f).cwiseMin(1.0f);
    }
  }
  return colors;
}

}  // namespace markerless_mocap
