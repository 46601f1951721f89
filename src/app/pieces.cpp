#include "pieces.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "sundrape/app/model.hpp"
#include "sundrape/io/case_error.hpp"
#include "sundrape/mesh/builders.hpp"
#include "sundrape/mesh/import.hpp"
#include "sundrape/mesh/waviness.hpp"

#include "overload.hpp"

namespace sundrape {
namespace {

QuadMesh build_mesh(const ClothCase& cloth) {
  return std::visit(
      Overload{
          [](const RectangleShape& s) { return rectangle(s.length, s.width, s.cells_warp, s.cells_weft); },
          [](const DiscShape& s) { return disc(s.radius, s.cells); },
          [](const AnnulusShape& s) { return annulus(s.inner_radius, s.outer_radius, s.cells_radial, s.cells_around); },
          [](const MeshShape& s) {
            try {
              return read_obj(s.file, s.unit);
            } catch (const std::exception& problem) {
              throw CaseError(s.source, problem.what());
            }
          }},
      cloth.shape);
}

double longest_side(const std::vector<Vector3>& positions) {
  Eigen::AlignedBox3d box;
  for (const auto& x : positions) box.extend(x);
  return box.sizes().maxCoeff();
}

/// Of the start; only relaxation from the rest shape has some where the case does not say.
double waviness(const Case& c, const PieceCase& piece) {
  const auto& cloth = piece.cloth;
  if (is_wavy_at_rest(c, piece)) return 0;
  const bool said = cloth.waviness_given.value_or(false) || cloth.waviness_amplitude > 0;
  if (said || c.sheet().cloth.start || c.analysis != Analysis::relaxation) return cloth.waviness_amplitude;
  return default_waviness(piece);
}

void require_own_names(const Case& c, const std::vector<QuadMesh>& sheets, const std::vector<std::string>& names) {
  for (const auto& name : names)
    for (const auto& sheet : sheets)
      if (sheet.sets.contains(name))
        throw CaseError({.file = c.file.string(), .key = "cloth"},
                        fmt::format("a piece cannot be called '{}', which is a node set of its mesh", name));
}

}  // namespace

Cloth build_cloth(const Case& c) {
  std::vector<QuadMesh> sheets;
  std::vector<std::string> names;
  Cloth cloth;
  for (const auto& piece : c.pieces) {
    auto mesh = build_mesh(piece.cloth);
    const auto amplitude = piece.cloth.waviness_amplitude;
    const auto seed = piece.cloth.waviness_seed;
    if (is_wavy_at_rest(c, piece)) mesh.reference = wavy(mesh, mesh.reference, amplitude, seed);
    const auto placed = place(mesh.reference, piece.cloth.place);
    const auto initial = wavy(mesh, placed, waviness(c, piece), seed);
    cloth.placed.insert(cloth.placed.end(), placed.begin(), placed.end());
    cloth.initial.insert(cloth.initial.end(), initial.begin(), initial.end());
    cloth.size = std::max(cloth.size, longest_side(mesh.reference));
    cloth.diagonal = std::max(cloth.diagonal, diagonal(mesh));
    if (c.pieces.size() > 1) mesh.reference = placed;
    sheets.push_back(std::move(mesh));
    names.push_back(piece.name);
  }
  cloth.pieces = pieces_of(sheets, names);
  if (sheets.size() == 1) {
    cloth.mesh = std::move(sheets.front());
    cloth.placement = placement(c.sheet().cloth.place);
  } else {
    require_own_names(c, sheets, names);
    cloth.mesh = joined(sheets, names);
  }
  return cloth;
}

}  // namespace sundrape
