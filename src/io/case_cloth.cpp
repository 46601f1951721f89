#include <fmt/format.h>

#include "case_parts.hpp"

namespace sundrape {
namespace {

AnnulusShape resolve_annulus(const CaseSection& cloth) {
  const AnnulusShape shape{cloth.number("inner_radius"), cloth.number("outer_radius"),
                           static_cast<int>(cloth.integers("cells")[0]), static_cast<int>(cloth.integers("cells")[1])};
  if (!(shape.inner_radius < shape.outer_radius))
    cloth.fail("inner_radius", fmt::format("{:.10g} m is not smaller than the outer radius, {:.10g} m",
                                           shape.inner_radius, shape.outer_radius));
  if (shape.cells_around < 3)
    cloth.fail("cells", fmt::format("{} cells do not close around the hole, 3 do", shape.cells_around));
  return shape;
}

MeshShape resolve_mesh(const CaseSection& cloth, const std::filesystem::path& folder) {
  return {file_beside(cloth, "file", folder), cloth.unit("units"), cloth.source("file")};
}

}  // namespace

std::filesystem::path file_beside(const CaseSection& cloth, const char* key, const std::filesystem::path& folder) {
  auto file = std::filesystem::absolute(folder / cloth.text(key)).lexically_normal();
  if (!std::filesystem::is_regular_file(file))
    cloth.fail(key, fmt::format("'{}' is not there (sought beside the case file)", cloth.text(key)));
  return file;
}

Place resolve_place(const CaseSection& place) {
  Place resolved;
  resolved.translate = place.vector3("translate");
  if (place.has("rotate")) {
    const CaseSection rotate = place.table("rotate");
    resolved.axis = rotate.direction("axis");
    resolved.angle = rotate.number("angle");
  }
  return resolved;
}

ClothCase resolve_cloth(const CaseSection& cloth, const std::filesystem::path& folder) {
  ClothCase resolved;
  const std::string shape = cloth.text("shape");
  if (shape == "rectangle") {
    const auto size = cloth.numbers("size");
    const auto cells = cloth.integers("cells");
    resolved.shape = RectangleShape{size[0], size[1], static_cast<int>(cells[0]), static_cast<int>(cells[1])};
  } else if (shape == "disc") {
    resolved.shape = DiscShape{cloth.number("radius"), cloth.integer("cells")};
  } else if (shape == "annulus") {
    resolved.shape = resolve_annulus(cloth);
  } else {
    resolved.shape = resolve_mesh(cloth, folder);
  }
  resolved.place = resolve_place(cloth.table("place"));
  if (cloth.has("start")) resolved.start = {file_beside(cloth, "start", folder), cloth.source("start")};
  if (cloth.has("waviness")) {
    const CaseSection waviness = cloth.table("waviness");
    resolved.waviness_given = true;
    resolved.waviness_amplitude = waviness.number("amplitude");
    resolved.waviness_seed = static_cast<unsigned>(waviness.integers("seed").front());
    if (waviness.has("at_rest")) resolved.waviness_at_rest = waviness.boolean("at_rest");
  }
  return resolved;
}

}  // namespace sundrape
