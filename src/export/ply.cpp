#include <limits>

#include <fmt/format.h>

#include "sundrape/export/writers.hpp"
#include "sundrape/version.hpp"

#include "output_file.hpp"
#include "sequence.hpp"

namespace sundrape {
namespace {

constexpr auto not_a_number = std::numeric_limits<float>::quiet_NaN();

template <class Number>
void append(std::string& bytes, Number number) {
  append_bytes<std::endian::little>(bytes, number);
}

void append(std::string& bytes, const Vector3& v) {
  for (const double component : v) append(bytes, static_cast<float>(component));
}

template <std::size_t corners>
void append_face(std::string& bytes, const std::array<int, corners>& face, int first) {
  append(bytes, static_cast<std::uint8_t>(corners));
  for (const int corner : face) append(bytes, static_cast<std::int32_t>(first + corner));
}

std::string header(const ExportScene& scene, const ExportFrame& f, std::size_t frame) {
  auto vertices = f.positions.size(), faces = scene.mesh().quads.size();
  for (const auto& body : scene.bodies()) {
    vertices += body.surface.vertices.size();
    faces += body.surface.triangles.size();
  }
  auto text = fmt::format(
      "ply\nformat binary_little_endian 1.0\ncomment sundrape {}: frame {} at {:g}; metres, z up\n"
      "comment part 0 is the cloth",
      version(), scene.frame_numbers()[frame], f.variable);
  for (std::size_t b = 0; b < scene.bodies().size(); ++b)
    text += fmt::format(", {} is {}", b + 1, scene.bodies()[b].name);
  for (const auto& field : f.fields) text += fmt::format("\ncomment {} in {}", field.name, field.units);
  text += fmt::format("\nelement vertex {}\n", vertices);
  for (const auto* const name : {"x", "y", "z", "nx", "ny", "nz", "s", "t"})
    text += fmt::format("property float {}\n", name);
  for (const auto& field : f.fields) text += fmt::format("property float {}\n", field.name);
  text +=
      fmt::format("property int part\nelement face {}\nproperty list uchar int vertex_indices\nend_header\n", faces);
  return text;
}

std::string ply(const ExportScene& scene, std::size_t frame) {
  const auto f = scene.frame(frame);
  auto bytes = header(scene, f, frame);
  for (std::size_t i = 0; i < f.positions.size(); ++i) {
    append(bytes, f.positions[i]);
    append(bytes, f.normals[i]);
    for (const double s : scene.texture()[i]) append(bytes, static_cast<float>(s));
    for (const auto& field : f.fields) append(bytes, static_cast<float>(field.values[static_cast<Eigen::Index>(i)]));
    append(bytes, std::int32_t{0});
  }
  for (std::size_t b = 0; b < scene.bodies().size(); ++b) {
    const auto& surface = scene.bodies()[b].surface;
    for (std::size_t i = 0; i < surface.vertices.size(); ++i) {
      append(bytes, f.bodies[b](surface.vertices[i]));
      append(bytes, Vector3(f.bodies[b].rotation * surface.normals[i]));
      for (std::size_t k = 0; k < 2 + f.fields.size(); ++k) append(bytes, k < 2 ? 0.0F : not_a_number);
      append(bytes, static_cast<std::int32_t>(b + 1));
    }
  }
  for (const auto& quad : scene.mesh().quads) append_face(bytes, quad, 0);
  auto first = static_cast<int>(f.positions.size());
  for (const auto& body : scene.bodies()) {
    for (const auto& triangle : body.surface.triangles) append_face(bytes, triangle, first);
    first += static_cast<int>(body.surface.vertices.size());
  }
  return bytes;
}

}  // namespace

WrittenFiles write_ply(const ExportScene& scene, const std::filesystem::path& file) {
  return write_sequence(scene, file, [&](std::size_t frame, const std::filesystem::path& path) {
    OutputFile output(path);
    output.write(ply(scene, frame));
    output.commit();
  });
}

}  // namespace sundrape
