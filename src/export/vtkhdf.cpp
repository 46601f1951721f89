#include <span>

#include <fmt/format.h>

#include "sundrape/export/writers.hpp"
#include "sundrape/io/hdf5.hpp"
#include "sundrape/io/replace_file.hpp"
#include "sundrape/version.hpp"

#include "whole_grid.hpp"

namespace sundrape {
namespace {

constexpr int compression = 4;
constexpr std::uint8_t vtk_triangle = 5, vtk_quad = 9;

template <class T>
constexpr hdf5::Element element_of() {
  if constexpr (std::is_same_v<T, double>) return hdf5::Element::real64;
  if constexpr (std::is_same_v<T, float>) return hdf5::Element::real32;
  if constexpr (std::is_same_v<T, std::int32_t>) return hdf5::Element::int32;
  if constexpr (std::is_same_v<T, std::int64_t>) return hdf5::Element::int64;
  if constexpr (std::is_same_v<T, std::uint8_t>) return hdf5::Element::uint8;
}

/// Paths are those of the specification, below /VTKHDF.
class VtkHdf {
 public:
  explicit VtkHdf(const std::filesystem::path& path) : file_(hdf5::File::create(path)) {
    file_.create_group("/VTKHDF/Steps");
    file_.set_attribute("/VTKHDF", "Version", std::vector<std::int64_t>{2, 0});
    file_.set_ascii_text("/VTKHDF", "Type", "UnstructuredGrid");  // VTK from 9.2 on refuses UTF-8
  }

  hdf5::File& file() { return file_; }

  /// A whole dataset of `columns` numbers a row.
  template <class T>
  void write(const std::string& name, const std::vector<T>& values, std::uint64_t columns = 1) {
    auto dataset = file_.create_dataset("/VTKHDF/" + name, spec<T>(values.size() / columns, columns));
    dataset.write_rows(0, values.size() / columns, std::as_bytes(std::span(values)));
  }
  /// A dataset with a block of rows for each step.
  template <class T>
  hdf5::Dataset blocks(const std::string& name, std::size_t rows, std::size_t steps, std::uint64_t columns) {
    auto s = spec<T>(rows * steps, columns);
    s.chunk_rows = rows;
    s.deflate = compression;
    return file_.create_dataset("/VTKHDF/" + name, s);
  }

 private:
  template <class T>
  static hdf5::DatasetSpec spec(std::uint64_t rows, std::uint64_t columns) {
    hdf5::DatasetSpec s{.element = element_of<T>(), .shape = {rows}};
    if (columns > 1) s.shape.push_back(columns);
    return s;
  }

  hdf5::File file_;
};

template <class T>
void write_block(hdf5::Dataset& dataset, std::size_t step, std::size_t rows, const std::vector<T>& values) {
  dataset.write_rows(step * rows, rows, std::as_bytes(std::span(values)));
}

/// Points and their fields, frame by frame; the fields' names.
std::vector<std::string> write_frames(VtkHdf& out, const ExportScene& scene, const WholeGrid& grid) {
  const auto steps = scene.frames();
  auto positions = out.blocks<double>("Points", grid.points, steps, 3);
  auto normals = out.blocks<float>("PointData/Normals", grid.points, steps, 3);
  std::vector<std::string> names{"Normals"};
  std::vector<hdf5::Dataset> fields;
  for (std::size_t k = 0; k < steps; ++k) {
    const auto frame = scene.frame(k);
    write_block(positions, k, grid.points, grid.positions(frame));
    write_block(normals, k, grid.points, grid.normals(frame));
    for (std::size_t i = 0; i < frame.fields.size(); ++i) {
      const auto& field = frame.fields[i];
      if (k == 0) {
        names.push_back(field.name);
        fields.push_back(out.blocks<float>("PointData/" + field.name, grid.points, steps, 1));
        out.file().set_attribute("/VTKHDF/PointData/" + field.name, "units", field.units);
      }
      write_block(fields[i], k, grid.points, grid.field(field.values));
    }
  }
  return names;
}

/// The grid is the same at every step but for its points and their fields, whose blocks follow each other.
void write_steps(VtkHdf& out, const ExportScene& scene, std::size_t points, const std::vector<std::string>& fields) {
  const auto steps = scene.frames();
  std::vector<double> values;
  std::vector<std::int64_t> moving, still(steps, 0);
  for (std::size_t k = 0; k < steps; ++k) {
    values.push_back(scene.result().frame_variable() == FrameVariable::time
                         ? scene.variable(k)
                         : static_cast<double>(scene.frame_numbers()[k]));  // load factors may fall
    moving.push_back(static_cast<std::int64_t>(k * points));
  }
  out.file().set_attribute("/VTKHDF/Steps", "NSteps", static_cast<std::int64_t>(steps));
  out.write("Steps/Values", values);
  out.write("Steps/PartOffsets", still);
  out.write("Steps/NumberOfParts", std::vector<std::int64_t>(steps, 1));
  out.write("Steps/PointOffsets", moving);
  for (const auto* const name : {"CellOffsets", "ConnectivityIdOffsets"}) {
    auto dataset = out.file().create_dataset(fmt::format("/VTKHDF/Steps/{}", name),
                                             {.element = hdf5::Element::int64, .shape = {steps, 1}});
    dataset.write_rows(0, steps, std::as_bytes(std::span(still)));
  }
  for (const auto& name : fields) out.write("Steps/PointDataOffsets/" + name, moving);
  out.write("Steps/PointDataOffsets/texture", still);
  out.write("Steps/CellDataOffsets/part", still);
}

}  // namespace

WrittenFiles write_vtkhdf(const ExportScene& scene, const std::filesystem::path& file) {
  const WholeGrid grid(scene);
  ReplaceFile replacement(file);
  {
    VtkHdf out(replacement.temporary());
    out.file().set_name(file.string());
    out.file().set_attribute("/", "description", fmt::format("{}, by sundrape {}", scene.result().title(), version()));
    std::string parts = "0 cloth";
    for (std::size_t b = 0; b < scene.bodies().size(); ++b)
      parts += fmt::format(", {} {}", b + 1, scene.bodies()[b].name);
    using Count = std::vector<std::int64_t>;
    out.write("NumberOfPoints", Count{static_cast<std::int64_t>(grid.points)});
    out.write("NumberOfCells", Count{static_cast<std::int64_t>(grid.cells())});
    out.write("NumberOfConnectivityIds", Count{static_cast<std::int64_t>(grid.connectivity.size())});
    out.write("Connectivity", grid.connectivity);
    out.write("Offsets", grid.offsets);
    std::vector<std::uint8_t> types;
    types.reserve(grid.cells());
    for (const int part : grid.part) types.push_back(part == 0 ? vtk_quad : vtk_triangle);
    out.write("Types", types);
    out.write("CellData/part", grid.part);
    out.file().set_attribute("/VTKHDF/CellData/part", "meaning", parts);
    out.write("PointData/texture", grid.texture(), 2);

    write_steps(out, scene, grid.points, write_frames(out, scene, grid));
    out.file().close();
  }
  replacement.commit(ReplaceFile::Durability::process);
  return {file};
}

}  // namespace sundrape
