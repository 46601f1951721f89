#include "sundrape/io/case_reader.hpp"

#include <algorithm>
#include <sstream>

#include <fmt/format.h>

#include "sundrape/io/case_error.hpp"
#include "sundrape/io/fingerprint.hpp"

#include "case_choices.hpp"
#include "case_document.hpp"
#include "case_parts.hpp"
#include "read_text.hpp"

namespace sundrape {
namespace {

/// The pieces of cloth, each with its fabric.
std::vector<PieceCase> resolve_pieces(const CaseSection& top, const std::filesystem::path& folder) {
  const auto sections = top.tables("cloth");
  if (sections.empty()) top.fail("cloth", "a case needs at least one piece of cloth");
  std::vector<PieceCase> pieces;
  for (const auto& section : sections) {
    PieceCase piece;
    piece.name = section.has("name")    ? section.text("name")
                 : sections.size() == 1 ? "cloth"
                                        : fmt::format("cloth{}", pieces.size());
    for (const auto& earlier : pieces)
      if (earlier.name == piece.name)
        section.fail("name", fmt::format("'{}' is already the name of another piece", piece.name));
    piece.cloth = resolve_cloth(section, folder);
    if (sections.size() > 1 && section.has("start"))
      section.fail("start", "belongs to cases of a single piece of cloth");
    if (!section.has("material") && !top.has("material"))
      throw CaseError(top.source("").file, top.source("").line, "material", "missing: Its fabric.");
    const CaseSection material = section.has("material") ? section.table("material") : top.table("material");
    if (material.has("title")) piece.fabric_title = material.text("title");
    piece.fabric = resolve_fabric(material);
    pieces.push_back(std::move(piece));
  }
  return pieces;
}

/// The least of those that fabrics have, if any.
std::optional<double> breaking_strain(const CaseSection& top) {
  std::optional<double> least = top.table("material").maybe_number("breaking_strain");
  for (const auto& section : top.tables("cloth"))
    if (const auto own = section.table("material").maybe_number("breaking_strain"))
      least = std::min(*own, least.value_or(*own));
  return least;
}

double thickest(const Case& c) {
  double most = 0;
  for (const auto& piece : c.pieces) most = std::max(most, piece.fabric.thickness);
  return most;
}

std::string print(const toml::table& root) {
  std::ostringstream text;
  text << root << '\n';
  return text.str();
}

}  // namespace

Case parse_case(std::string_view text, const std::filesystem::path& file, const std::vector<std::string>& sets) {
  const toml::table root = parse_document(text, file.string(), sets);
  const ReadingContext context;
  const CaseSection top(context, key_section(""), &root, {file.string(), 1, ""});
  top.check();

  Case resolved;
  resolved.file = file;
  resolved.text = print(root);
  resolved.title = top.has("title") ? top.text("title") : file.stem().string();
  resolved.model = choices::model.value(top.text("model"));
  resolved.analysis = choices::analysis.value(top.text("analysis"));
  resolved.pieces = resolve_pieces(top, file.parent_path());
  resolved.breaking_strain = breaking_strain(top);
  resolved.shell = resolve_shell(top.table("shell"));
  require_shell_model(top, resolved);
  resolved.fixes = resolve_fixes(top.tables("fix"), resolved.model, resolved.analysis);
  resolved.motions = resolve_motions(top.tables("motion"), resolved.fixes, resolved.model, resolved.analysis);
  resolved.loads = resolve_loads(top.tables("load"));
  resolved.obstacles = resolve_obstacles(top.tables("obstacle"), resolved.analysis, file.parent_path());
  resolved.contact = resolve_contact(top.table("contact"), thickest(resolved), resolved.pieces.size() > 1);
  const CaseSection dynamics = top.table("dynamics");
  resolved.dynamics = resolve_dynamics(dynamics);
  require_integrator_of_director(top, resolved);
  require_damping_of_massless_directors(top, resolved);
  resolved.relaxation = resolve_relaxation(top.table("relaxation"));
  require_scheme_of_shell(top, resolved);
  resolved.arc_length = resolve_arc_length(top.table("arc-length"));
  resolve_moving_defaults(top, resolved);
  if (resolved.analysis == Analysis::dynamics && !dynamics.has("duration")) {
    const SourceLine where = top.has("dynamics") ? dynamics.source() : top.source("analysis");
    throw CaseError(where.file, where.line, "dynamics.duration", "missing: how long the motion lasts");
  }
  resolved.output =
      resolve_output(top.table("output"), resolved.analysis == Analysis::dynamics ? resolved.dynamics.duration : 0);
  resolved.sensitivities = resolve_sensitivities(top, resolved);
  for (const auto& piece : resolved.pieces)
    if (const auto* mesh = std::get_if<MeshShape>(&piece.cloth.shape))
      resolved.inputs += (&piece == &resolved.sheet() ? "mesh " : " " + piece.name + " ") + fingerprint(mesh->file);
  for (const auto& obstacle : resolved.obstacles)
    if (const auto* mesh = std::get_if<MeshBodyShape>(&obstacle.shape))
      resolved.inputs += " " + obstacle.name + " " + fingerprint(mesh->file);
  if (const auto& start = resolved.sheet().cloth.start) resolved.inputs += " start " + fingerprint(start->file);
  return resolved;
}

Case read_case(const std::filesystem::path& file, const std::vector<std::string>& sets) {
  return parse_case(read_text(file), file, sets);
}

}  // namespace sundrape
