#include "sundrape/io/case_reader.hpp"

#include <sstream>

#include <fmt/format.h>

#include "sundrape/io/fingerprint.hpp"

#include "case_choices.hpp"
#include "case_document.hpp"
#include "case_parts.hpp"
#include "read_text.hpp"

namespace sundrape {
namespace {

/// The cloth as a table; [[cloth]] with one entry has become one already.
CaseSection cloth_section(const CaseSection& top, const toml::table& root) {
  if (const auto* pieces = root.get_as<toml::array>("cloth"))
    top.fail("cloth", fmt::format("{} pieces are not available in this version; accepted: one", pieces->size()));
  return top.table("cloth");
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
  if (top.has("cloth")) (void)cloth_section(top, root);
  top.check();

  Case resolved;
  resolved.file = file;
  resolved.text = print(root);
  resolved.title = top.has("title") ? top.text("title") : file.stem().string();
  resolved.model = choices::model.value(top.text("model"));
  resolved.analysis = choices::analysis.value(top.text("analysis"));
  resolved.cloth = resolve_cloth(cloth_section(top, root), file.parent_path());
  const CaseSection material = top.table("material");
  if (material.has("title")) resolved.fabric_title = material.text("title");
  resolved.fabric = resolve_fabric(material);
  resolved.breaking_strain = material.maybe_number("breaking_strain");
  resolved.shell = resolve_shell(top.table("shell"));
  require_shell_model(top, resolved);
  resolved.fixes = resolve_fixes(top.tables("fix"), resolved.model, resolved.analysis);
  resolved.motions = resolve_motions(top.tables("motion"), resolved.fixes, resolved.model, resolved.analysis);
  resolved.loads = resolve_loads(top.tables("load"));
  resolved.obstacles = resolve_obstacles(top.tables("obstacle"), resolved.analysis, file.parent_path());
  resolved.contact = resolve_contact(top.table("contact"), resolved.fabric.thickness);
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
  if (const auto* mesh = std::get_if<MeshShape>(&resolved.cloth.shape))
    resolved.inputs = "mesh " + fingerprint(mesh->file);
  for (const auto& obstacle : resolved.obstacles)
    if (const auto* mesh = std::get_if<MeshBodyShape>(&obstacle.shape))
      resolved.inputs += " " + obstacle.name + " " + fingerprint(mesh->file);
  if (resolved.cloth.start) resolved.inputs += " start " + fingerprint(resolved.cloth.start->file);
  return resolved;
}

Case read_case(const std::filesystem::path& file, const std::vector<std::string>& sets) {
  return parse_case(read_text(file), file, sets);
}

}  // namespace sundrape
