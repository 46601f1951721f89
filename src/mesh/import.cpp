#include "sundrape/mesh/import.hpp"

#include <algorithm>
#include <fstream>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <sstream>
#include <stdexcept>
#include <string_view>

#include <fmt/format.h>

#define TINYOBJLOADER_USE_DOUBLE
#define TINYOBJLOADER_IMPLEMENTATION
#include <tiny_obj_loader.h>

namespace sundrape {
namespace {

/// Collects what tinyobjloader reports.
///
/// The library keeps no line numbers and reads words that are no numbers as zero: it is fed one line at a time, and
/// the words of the line are looked at here.
class ObjReader {
 public:
  explicit ObjReader(double unit) : unit_(unit) {}

  QuadMesh read(std::istream& file) {
    tinyobj::callback_t callbacks;
    callbacks.vertex_cb = [](void* self, double x, double y, double z, double) { of(self).vertex({x, y, z}); };
    callbacks.texcoord_cb = [](void* self, double u, double v, double) { of(self).texture_coordinate({u, v}); };
    callbacks.index_cb = [](void* self, tinyobj::index_t* corners, int count) {
      of(self).face({corners, static_cast<std::size_t>(count)});
    };
    callbacks.group_cb = [](void* self, const char** names, int count) { of(self).groups({names, names + count}); };
    callbacks.object_cb = [](void* self, const char* name) { of(self).object(name); };
    NoMaterials no_materials;
    while (std::getline(file, text_)) {
      ++line_;
      std::istringstream line(text_ + '\n');
      tinyobj::LoadObjWithCallback(line, callbacks, this, &no_materials);
    }
    return finish();
  }

 private:
  struct NoMaterials final : tinyobj::MaterialReader {
    bool operator()(const std::string&, std::vector<tinyobj::material_t>*, std::map<std::string, int>*, std::string*,
                    std::string*) override {
      return true;
    }
  };

  static ObjReader& of(void* self) { return *static_cast<ObjReader*>(self); }

  [[noreturn]] void refuse(const std::string& what) const {
    throw std::invalid_argument(fmt::format("{}: {}", line_, what));
  }

  /// Refuses a line `key number number …` with fewer than `least` numbers or with anything else in it.
  void require_numbers(std::string_view allowed, int least) const {
    std::istringstream words(text_);
    std::string key, word;
    words >> key;
    int count = 0;
    for (; words >> word && !word.starts_with('#'); ++count)
      if (word.find_first_not_of(allowed) != std::string::npos)
        refuse(fmt::format(R"("{}" in a line of "{}" is not a number)", word, key));
    if (count < least) refuse(fmt::format("a line of \"{}\" needs {} numbers, not {}", key, least, count));
  }

  void vertex(const Vector3& x) {
    require_numbers(decimal, 3);
    mesh_.reference.emplace_back(unit_ * x);
    mesh_.material.emplace_back(unit_ * x.head<2>());
    textured_.emplace_back();
  }

  void texture_coordinate(const Eigen::Vector2d& uv) {
    require_numbers(decimal, 2);
    texture_.emplace_back(unit_ * uv);
  }

  void face(std::span<const tinyobj::index_t> corners) {
    require_numbers("0123456789-/", 1);
    if (corners.size() != 4) refuse(fmt::format("a face with {} corners; sundrape takes quads only", corners.size()));
    std::array<int, 4> quad{};
    for (std::size_t k = 0; k < 4; ++k) {
      quad[k] = resolve(corners[k].vertex_index, mesh_.nodes(), "vertex");
      if (std::count(quad.begin(), quad.begin() + static_cast<long>(k), quad[k]) > 0)
        refuse(fmt::format("a face that names vertex {} twice", quad[k] + 1));
      for (auto* const names : {&groups_, &objects_})
        for (const auto& name : *names) sets_[name].insert(quad[k]);
      if (corners[k].texcoord_index != 0) texture_node(quad[k], corners[k].texcoord_index);
    }
    untextured_faces_ |= corners[0].texcoord_index == 0;
    mesh_.quads.push_back(quad);
  }

  void texture_node(int node, int texture_index) {
    const int t = resolve(texture_index, static_cast<int>(texture_.size()), "texture coordinate");
    auto& known = textured_[static_cast<std::size_t>(node)];
    const auto& uv = texture_[static_cast<std::size_t>(t)];
    if (known && *known != uv) refuse(fmt::format("vertex {} gets a second texture coordinate: a seam", node + 1));
    known = uv;
  }

  /// From OBJ's counting, 1 … count or −1 … −count backwards from the latest, to 0 … count − 1.
  int resolve(int number, int count, const char* what) const {
    const int i = number > 0 ? number - 1 : count + number;
    if (number == 0 || i < 0 || i >= count)
      refuse(fmt::format("a face names {} {}, but the file has {} up to here", what, number, count));
    return i;
  }

  void groups(const std::vector<std::string>& names) {
    groups_ = names;
    require_free(names);
  }
  void object(const std::string& name) {
    objects_ = {name};
    require_free(objects_);
  }
  void require_free(const std::vector<std::string>& names) const {
    for (const char* own : {"all", "boundary"})
      if (std::ranges::find(names, own) != names.end())
        refuse(fmt::format("the set name \"{}\" is the mesh's own; call the group something else", own));
  }

  QuadMesh finish() {
    if (mesh_.quads.empty()) throw std::invalid_argument(" there is no face in it");
    const auto textured = std::ranges::count_if(textured_, [](const auto& uv) { return uv.has_value(); });
    if (textured > 0 && untextured_faces_)
      throw std::invalid_argument(" some faces have texture coordinates and some have none");
    for (std::size_t i = 0; i < textured_.size(); ++i)
      if (textured_[i]) mesh_.material[i] = *textured_[i];
    try {
      require_sound(mesh_);
    } catch (const std::invalid_argument& problem) {
      throw std::invalid_argument(fmt::format(" {} (counted from 0)", problem.what()));
    }
    for (const auto& [name, nodes] : sets_) mesh_.sets[name].assign(nodes.begin(), nodes.end());
    auto& all = mesh_.sets["all"];
    for (int i = 0; i < mesh_.nodes(); ++i) all.push_back(i);
    mesh_.sets["boundary"] = boundary_nodes(mesh_);
    return std::move(mesh_);
  }

  static constexpr std::string_view decimal = "0123456789+-.eE";

  double unit_;
  std::string text_;  // the line at hand
  int line_ = 0;      // and its number
  QuadMesh mesh_;
  std::vector<Eigen::Vector2d> texture_;                  // as the file lists them
  std::vector<std::optional<Eigen::Vector2d>> textured_;  // of each node
  bool untextured_faces_ = false;
  std::vector<std::string> groups_, objects_;  // those that the next face belongs to
  std::map<std::string, std::set<int>> sets_;
};

}  // namespace

QuadMesh read_obj(const std::filesystem::path& file, double unit) {
  if (!(unit > 0)) throw std::invalid_argument("the unit of a mesh file must be positive");
  std::ifstream stream(file);
  if (!stream || std::filesystem::is_directory(file))
    throw std::runtime_error(fmt::format("{}: cannot be read", file.string()));
  try {
    return ObjReader(unit).read(stream);
  } catch (const std::invalid_argument& problem) {
    throw std::invalid_argument(fmt::format("{}:{}", file.string(), problem.what()));
  }
}

}  // namespace sundrape
