#include "sundrape/export/writers.hpp"

#include "obj_text.hpp"
#include "output_file.hpp"

namespace sundrape {
namespace {

template <class Number>
void append(std::string& bytes, Number number) {
  append_bytes<std::endian::big>(bytes, number);
}

}  // namespace

WrittenFiles write_mdd(const ExportScene& scene, const std::filesystem::path& file) {
  OutputFile cache(file);
  std::string bytes;  // numbers of frames and points, times [s], then all points frame by frame
  append(bytes, static_cast<std::int32_t>(scene.frames()));
  append(bytes, static_cast<std::int32_t>(scene.mesh().nodes()));
  for (std::size_t k = 0; k < scene.frames(); ++k) append(bytes, static_cast<float>(scene.shown_at(k)));
  for (std::size_t k = 0; k < scene.frames(); ++k) {
    for (const auto& p : scene.positions(k))
      for (const double component : p) append(bytes, static_cast<float>(component));
    cache.write(bytes);
    bytes.clear();
  }
  auto mesh_path = file;
  mesh_path.replace_extension(".obj");
  OutputFile mesh(mesh_path);
  mesh.write(obj_text(scene, 0, false));
  mesh.commit();
  cache.commit();
  return {file, mesh_path};
}

}  // namespace sundrape
