#include <algorithm>
#include <cctype>
#include <cmath>
#include <fstream>
#include <map>
#include <stdexcept>
#include <string>

#include <assimp/Importer.hpp>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <fmt/format.h>

#include "sundrape/mesh/triangle_mesh.hpp"

namespace sundrape {
namespace {

/// Collects triangles whose vertices are known by their places.
class Joiner {
 public:
  explicit Joiner(double unit) : unit_(unit) {}

  void add(const aiMesh& part) {
    for (unsigned f = 0; f < part.mNumFaces; ++f) {
      const auto& face = part.mFaces[f];
      if (face.mNumIndices != 3) continue;  // points and lines
      std::array<int, 3> triangle{};
      for (unsigned k = 0; k < 3; ++k) triangle[k] = vertex(part.mVertices[face.mIndices[k]]);
      const auto& [a, b, c] = triangle;
      if (a != b && b != c && c != a) mesh_.triangles.push_back(triangle);
    }
  }
  TriangleMesh finish() { return std::move(mesh_); }

 private:
  int vertex(const aiVector3D& place) {
    if (!std::isfinite(place.x) || !std::isfinite(place.y) || !std::isfinite(place.z))
      throw std::invalid_argument("a vertex is no finite number");
    const std::array<float, 3> key = {place.x, place.y, place.z};
    const auto [known, is_new] = numbers_.try_emplace(key, static_cast<int>(mesh_.vertices.size()));
    if (is_new) mesh_.vertices.emplace_back(unit_ * Vector3(place.x, place.y, place.z));
    return known->second;
  }

  double unit_;
  TriangleMesh mesh_;
  std::map<std::array<float, 3>, int> numbers_;
};

void require_known_kind(const std::filesystem::path& file) {
  std::string ending = file.extension().string();
  std::ranges::transform(ending, ending.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (ending != ".obj" && ending != ".ply" && ending != ".stl")
    throw std::invalid_argument("triangle meshes are read from .obj, .ply and .stl files");
}

TriangleMesh read(const std::filesystem::path& file, double unit) {
  Assimp::Importer importer;
  const auto* const scene = importer.ReadFile(file.string(), aiProcess_Triangulate);
  if (scene == nullptr) throw std::invalid_argument(importer.GetErrorString());
  Joiner joiner(unit);
  for (unsigned m = 0; m < scene->mNumMeshes; ++m) joiner.add(*scene->mMeshes[m]);
  auto mesh = joiner.finish();
  if (mesh.triangles.empty()) throw std::invalid_argument("there is no triangle in it");
  return mesh;
}

}  // namespace

TriangleMesh read_triangle_mesh(const std::filesystem::path& file, double unit) {
  if (!(unit > 0)) throw std::invalid_argument("the unit of a mesh file must be positive");
  if (!std::ifstream(file) || std::filesystem::is_directory(file))
    throw std::runtime_error(fmt::format("{}: cannot be read", file.string()));
  try {
    require_known_kind(file);
    return read(file, unit);
  } catch (const std::invalid_argument& problem) {
    throw std::invalid_argument(fmt::format("{}: {}", file.string(), problem.what()));
  }
}

}  // namespace sundrape
