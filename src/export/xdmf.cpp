#include "sundrape/io/xdmf.hpp"

#include <iterator>
#include <span>

#include <fmt/format.h>

#include "sundrape/export/writers.hpp"
#include "sundrape/io/hdf5.hpp"

#include "output_file.hpp"

namespace sundrape {
namespace {

constexpr int compression = 4;

/// The data of an XDMF file in an HDF5 file beside it. Each put gives the XML that finds it again.
class HeavyData {
 public:
  HeavyData(const std::filesystem::path& path, std::string name)
      : file_(hdf5::File::create(path)), name_(std::move(name)) {}

  std::string put(const std::string& path, const std::vector<double>& values, std::uint64_t columns) {
    return put(path, hdf5::Element::real64, std::as_bytes(std::span(values)), values.size() / columns, columns);
  }
  std::string put(const std::string& path, const std::vector<float>& values, std::uint64_t columns) {
    return put(path, hdf5::Element::real32, std::as_bytes(std::span(values)), values.size() / columns, columns);
  }
  std::string put(const std::string& path, const std::vector<std::int32_t>& values, std::uint64_t columns) {
    return put(path, hdf5::Element::int32, std::as_bytes(std::span(values)), values.size() / columns, columns);
  }
  void close() { file_.close(); }

 private:
  std::string put(const std::string& path, hdf5::Element element, std::span<const std::byte> bytes, std::uint64_t rows,
                  std::uint64_t columns) {
    hdf5::DatasetSpec spec{.element = element, .shape = {rows}, .chunk_rows = rows, .deflate = compression};
    if (columns > 1) spec.shape.push_back(columns);
    file_.create_dataset(path, spec).write_rows(0, rows, bytes);
    const bool integer = element == hdf5::Element::int32;
    return fmt::format(R"(<DataItem Dimensions="{}{}" NumberType="{}" Precision="{}" Format="HDF">{}:{}</DataItem>)",
                       rows, columns > 1 ? fmt::format(" {}", columns) : "", integer ? "Int" : "Float",
                       element == hdf5::Element::real64 ? 8 : 4, escaped_xml(name_), path);
  }

  hdf5::File file_;
  std::string name_;
};

template <class Number>
std::vector<Number> flat(const std::vector<Vector3>& points) {
  std::vector<Number> list;
  list.reserve(3 * points.size());
  for (const auto& p : points)
    for (const double component : p) list.push_back(static_cast<Number>(component));
  return list;
}

template <std::size_t corners>
std::vector<std::int32_t> flat(const std::vector<std::array<int, corners>>& faces) {
  std::vector<std::int32_t> list;
  for (const auto& face : faces) list.insert(list.end(), face.begin(), face.end());
  return list;
}

/// What a grid of the file has in every frame, or anew in each.
struct GridText {
  std::string name, kind;  // "Quadrilateral" or "Triangle"
  std::size_t cells = 0;
  std::string connectivity = {}, points = {}, attributes = {};
};

std::string xml(const GridText& grid) {
  return fmt::format(
      R"(<Grid Name="{}" GridType="Uniform"><Topology TopologyType="{}" NumberOfElements="{}">{}</Topology>)"
      R"(<Geometry GeometryType="XYZ">{}</Geometry>{}</Grid>)"
      "\n",
      escaped_xml(grid.name), grid.kind, grid.cells, grid.connectivity, grid.points, grid.attributes);
}

std::string attribute(const std::string& name, const char* type, const std::string& data) {
  return fmt::format(R"(<Attribute Name="{}" AttributeType="{}" Center="Node">{}</Attribute>)", escaped_xml(name), type,
                     data);
}

/// A body's points and normals where it stands.
void place(GridText& grid, HeavyData& data, const std::string& group, const ShadedSurface& surface, const Pose& pose) {
  std::vector<Vector3> points, normals;
  for (const auto& v : surface.vertices) points.push_back(pose(v));
  for (const auto& n : surface.normals) normals.emplace_back(pose.rotation * n);
  grid.points = data.put(group + "/points", flat<double>(points), 3);
  grid.attributes = attribute("Normals", "Vector", data.put(group + "/normals", flat<float>(normals), 3));
}

std::string cloth_fields(HeavyData& data, const std::string& group, const ExportFrame& frame) {
  auto text = attribute("Normals", "Vector", data.put(group + "/normals", flat<float>(frame.normals), 3));
  for (const auto& [name, units, values] : frame.fields)
    text += attribute(name, "Scalar",
                      data.put(fmt::format("{}/{}", group, name), std::vector<float>(values.begin(), values.end()), 1));
  return text;
}

std::string description(const ExportScene& scene, HeavyData& data) {
  GridText cloth{.name = "cloth", .kind = "Quadrilateral", .cells = scene.mesh().quads.size()};
  cloth.connectivity = data.put("/cloth/quads", flat(scene.mesh().quads), 4);
  std::vector<float> texture;
  for (const auto& s : scene.texture()) texture.insert(texture.end(), {float(s.x()), float(s.y()), 0.0F});
  const auto texture_item = attribute("texture", "Vector", data.put("/cloth/texture", texture, 3));
  std::vector<GridText> bodies;
  for (std::size_t b = 0; b < scene.bodies().size(); ++b) {
    const auto& [name, surface, moves] = scene.bodies()[b];
    bodies.push_back({.name = name, .kind = "Triangle", .cells = surface.triangles.size()});
    bodies[b].connectivity = data.put(fmt::format("/obstacle_{}/triangles", b), flat(surface.triangles), 3);
  }
  std::string text =
      "<?xml version=\"1.0\" ?>\n<Xdmf Version=\"3.0\">\n<Domain>\n"
      "<Grid Name=\"motion\" GridType=\"Collection\" CollectionType=\"Temporal\">\n";
  for (std::size_t k = 0; k < scene.frames(); ++k) {
    const auto frame = scene.frame(k);
    const auto group = fmt::format("/cloth/frame_{:05}", k);
    cloth.points = data.put(group + "/points", flat<double>(frame.positions), 3);
    cloth.attributes = cloth_fields(data, group, frame) + texture_item;
    const double value = scene.result().frame_variable() == FrameVariable::time
                             ? frame.variable
                             : static_cast<double>(scene.frame_numbers()[k]);  // load factors may fall
    fmt::format_to(std::back_inserter(text),
                   R"(<Grid Name="frame" GridType="Collection" CollectionType="Spatial"><Time Value="{}"/>)"
                   "\n{}",
                   value, xml(cloth));
    for (std::size_t b = 0; b < bodies.size(); ++b) {
      const auto& body = scene.bodies()[b];
      if (k == 0 || body.moves)
        place(bodies[b], data, fmt::format("/obstacle_{}/frame_{:05}", b, k), body.surface, frame.bodies[b]);
      text += xml(bodies[b]);
    }
    text += "</Grid>\n";
  }
  return text + "</Grid>\n</Domain>\n</Xdmf>\n";
}

}  // namespace

WrittenFiles write_xdmf(const ExportScene& scene, const std::filesystem::path& file) {
  auto data_path = file;
  data_path.replace_filename(file.stem().string() + "-xdmf.h5");
  ReplaceFile data_replacement(data_path);
  OutputFile light(file);
  HeavyData data(data_replacement.temporary(), data_path.filename().string());
  light.write(description(scene, data));
  data.close();
  data_replacement.commit(ReplaceFile::Durability::process);
  light.commit();
  return {file, data_path};
}

}  // namespace sundrape
