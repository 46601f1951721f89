#include <fmt/format.h>

#include "case_choices.hpp"
#include "case_parts.hpp"

namespace sundrape {

ShellCase resolve_shell(const CaseSection& section) {
  ShellCase shell;
  shell.membrane = choices::membrane.value(section.text("membrane"));
  shell.hourglass_factor = section.maybe_number("hourglass_factor");
  shell.bending = choices::bending.value(section.text("bending"));
  shell.shear_correction = section.number("shear_correction");
  shell.director = choices::director.value(section.text("director"));
  shell.rotary_inertia = section.number("rotary_inertia");
  return shell;
}

void require_shell_model(const CaseSection& top, const Case& resolved) {
  if (resolved.model == Model::shell) return;
  if (top.has("shell")) top.fail("shell", R"(belongs to model = "shell", not to "particle")");
}

void require_scheme_of_shell(const CaseSection& top, const Case& resolved) {
  if (resolved.model == Model::shell && resolved.analysis == Analysis::relaxation &&
      resolved.relaxation.scheme == "chapter")
    top.table("relaxation").fail("scheme", R"("chapter" moves the nodes of a particle net; a shell needs "implicit")");
}

void require_damping_of_massless_directors(const CaseSection& top, const Case& resolved) {
  if (resolved.model != Model::shell || resolved.analysis != Analysis::dynamics ||
      resolved.shell.director != ShellDirector::massless)
    return;
  for (const auto& piece : resolved.pieces) {
    const auto& damping = piece.fabric.damping;
    const auto of_piece = resolved.pieces.size() == 1 ? "" : fmt::format(" for cloth '{}'", piece.name);
    for (const auto& [key, value] : {std::pair{"membrane", damping.membrane}, std::pair{"bending", damping.bending}})
      if (value == 0)
        top.table("shell").fail(
            "director", fmt::format("\"massless\" needs material.damping.{} > 0{}, which makes the rates of directors "
                                    "follow from the forces; take some, or director = \"inertia\"",
                                    key, of_piece));
  }
}

void require_integrator_of_director(const CaseSection& top, const Case& resolved) {
  if (resolved.model != Model::shell || resolved.analysis != Analysis::dynamics) return;
  if (resolved.shell.director == ShellDirector::massless && resolved.dynamics.integrator != IntegratorKind::ida)
    top.table("shell").fail(
        "director", fmt::format("\"massless\" makes a DAE, which dynamics.integrator = \"{}\" cannot solve; take "
                                "\"ida\", or director = \"inertia\"",
                                choices::integrator.name(resolved.dynamics.integrator)));
}

}  // namespace sundrape
