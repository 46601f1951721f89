#include <iterator>

#include <fmt/format.h>

#include "sundrape/export/writers.hpp"
#include "sundrape/version.hpp"

#include "obj_text.hpp"
#include "output_file.hpp"
#include "sequence.hpp"

namespace sundrape {
namespace {

using Text = std::back_insert_iterator<std::string>;

void vertices(Text out, const std::vector<Vector3>& points, const char* keyword) {
  for (const auto& p : points) fmt::format_to(out, "{} {} {} {}\n", keyword, p.x(), p.y(), p.z());
}

/// OBJ separates names by blanks.
std::string object_name(std::string name) {
  for (auto& c : name)
    if (c == ' ' || c == '\t' || c == '\n') c = '_';
  return name;
}

}  // namespace

std::string obj_text(const ExportScene& scene, std::size_t frame, bool with_obstacles) {
  const auto f = scene.frame(frame);
  auto text = fmt::format("# sundrape {}: frame {} at {:g}; metres, z up\no cloth\n", version(),
                          scene.frame_numbers()[frame], f.variable);
  const auto out = std::back_inserter(text);
  vertices(out, f.positions, "v");
  for (const auto& s : scene.texture()) fmt::format_to(out, "vt {} {}\n", s.x(), s.y());
  vertices(out, f.normals, "vn");
  for (const auto& quad : scene.mesh().quads) {
    text += 'f';
    for (const int node : quad) fmt::format_to(out, " {0}/{0}/{0}", node + 1);
    text += '\n';
  }
  if (!with_obstacles) return text;
  std::size_t first = f.positions.size() + 1;
  for (std::size_t b = 0; b < scene.bodies().size(); ++b) {
    const auto& [name, surface, moves] = scene.bodies()[b];
    fmt::format_to(out, "o {}\n", object_name(name));
    for (const auto& v : surface.vertices) vertices(out, {f.bodies[b](v)}, "v");
    for (std::size_t i = 0; i < surface.vertices.size(); ++i) text += "vt 0 0\n";  // some readers want one a vertex
    for (const auto& n : surface.normals) vertices(out, {f.bodies[b].rotation * n}, "vn");
    for (const auto& triangle : surface.triangles) {
      text += 'f';
      for (const int v : triangle) fmt::format_to(out, " {0}/{0}/{0}", first + static_cast<std::size_t>(v));
      text += '\n';
    }
    first += surface.vertices.size();
  }
  return text;
}

WrittenFiles write_obj(const ExportScene& scene, const std::filesystem::path& file) {
  return write_sequence(scene, file, [&](std::size_t frame, const std::filesystem::path& path) {
    OutputFile output(path);
    output.write(obj_text(scene, frame, true));
    output.commit();
  });
}

}  // namespace sundrape
