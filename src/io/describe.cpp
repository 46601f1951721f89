#include <span>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "sundrape/io/case_reader.hpp"

#include "case_choices.hpp"
#include "case_description.hpp"
#include "describe_parts.hpp"

namespace sundrape {
namespace {

void describe_place(CaseDescription& out, const std::string& path, const Place& place) {
  out.enter("place", path + ".place");
  out.vector3("translate", place.translate);
  if (place.angle == 0) return;
  out.enter("rotate", path + ".place.rotate");
  out.vector3("axis", place.axis);
  out.number("angle", place.angle);
}

/// @param path  what the keys of the sheet begin with
void describe_cloth(CaseDescription& out, const ClothCase& cloth, const std::string& path) {
  const auto enter = [&](const char* shape) {
    out.enter("cloth", path, shape);
    out.text("shape", shape);
  };
  if (const auto* rectangle = std::get_if<RectangleShape>(&cloth.shape)) {
    enter("rectangle");
    out.numbers("size", {rectangle->length, rectangle->width});
    out.verbatim("cells", fmt::format("[{}, {}]", rectangle->cells_warp, rectangle->cells_weft));
  } else if (const auto* disc = std::get_if<DiscShape>(&cloth.shape)) {
    enter("disc");
    out.number("radius", disc->radius);
    out.verbatim("cells", fmt::format("{}", disc->cells));
  } else if (const auto* annulus = std::get_if<AnnulusShape>(&cloth.shape)) {
    enter("annulus");
    out.number("inner_radius", annulus->inner_radius);
    out.number("outer_radius", annulus->outer_radius);
    out.verbatim("cells", fmt::format("[{}, {}]", annulus->cells_radial, annulus->cells_around));
  } else if (const auto* mesh = std::get_if<MeshShape>(&cloth.shape)) {
    enter("mesh");
    out.text("file", mesh->file.string());
    out.verbatim("units", fmt::format("{:.10g} m", mesh->unit));
  }
  describe_place(out, path, cloth.place);
  if (cloth.start) {
    out.enter("cloth", path);
    out.text("start", cloth.start->file.string());
  }
  if (cloth.waviness_given.value_or(false)) {
    out.enter("waviness", path + ".waviness");
    out.number("amplitude", cloth.waviness_amplitude);
    out.verbatim("seed", fmt::format("{}", cloth.waviness_seed));
    if (cloth.waviness_at_rest) out.verbatim("at_rest", *cloth.waviness_at_rest ? "true" : "false");
  }
}

std::string list_text(std::span<const double> numbers) {
  std::vector<std::string> printed;
  for (const double number : numbers) printed.push_back(fmt::format("{:.10g}", number));
  return fmt::format("[{}]", fmt::join(printed, ", "));
}

void describe_bending(CaseDescription& out, const Fabric::MeasuredBending& bending, const std::string& path) {
  out.enter("material.bending", path + ".bending", "polynomial");
  out.text("law", "polynomial");
  out.verbatim("coefficients", fmt::format("[{}, {}] of N over powers of 1/m", list_text(bending.warp.coefficients()),
                                           list_text(bending.weft.coefficients())));
  out.numbers("max_curvature", {bending.warp.max_curvature(), bending.weft.max_curvature()});
  out.text("form", bending.form == PlateBending::Form::paper ? "paper" : "energy");
}

void describe_net(CaseDescription& out, const Fabric::Net& net, const std::string& path) {
  out.enter("material.net", path + ".net");
  out.number("compression_factor", net.compression_factor);
  out.number("shear_factor", net.shear_factor);
  out.text("shear", net.diagonal_springs ? "diagonals" : "cell");
  out.number("diagonal_compression_factor", net.diagonal_compression_factor);
}

/// @param path  what the keys of the fabric begin with
void describe_fabric(CaseDescription& out, const Case& resolved, const PieceCase& piece, const std::string& path) {
  const auto& fabric = piece.fabric;
  const auto& title = piece.fabric_title;
  const auto model = resolved.model;
  out.enter("material", path);
  if (!title.empty()) out.text("title", title);
  out.number("thickness", fabric.thickness);
  out.number("density_area", fabric.area_density);
  out.number("poisson", fabric.poisson);
  out.maybe_number("breaking_strain", resolved.breaking_strain);
  if (fabric.measured_bending) describe_bending(out, *fabric.measured_bending, path);
  out.enter("material.damping", path + ".damping");
  out.number("mass", fabric.damping.mass);
  out.number("membrane", fabric.damping.membrane);
  out.number("bending", fabric.damping.bending);
  if (model == Model::particle) describe_net(out, fabric.net, path);
  out.heading("what follows for the sheet, per unit width");
  out.derived("membrane stiffness, warp", fabric.warp_membrane, "N/m");
  out.derived("membrane stiffness, weft", fabric.weft_membrane, "N/m");
  out.derived("shear stiffness", fabric.shear_membrane, "N/m");
  out.derived("transverse shear stiffness", fabric.transverse_shear, "N/m");
  const std::string when = fabric.measured_bending ? " at K = 0" : "";
  out.derived("bending rigidity, warp" + when, fabric.warp_bending, "N m");
  out.derived("bending rigidity, weft" + when, fabric.weft_bending, "N m");
  if (!fabric.measured_bending) {
    const double product = fabric.bending_coupling * fabric.bending_coupling;
    out.derived("bending rigidity of a strip, warp", fabric.warp_bending - product / fabric.weft_bending, "N m");
    out.derived("bending rigidity of a strip, weft", fabric.weft_bending - product / fabric.warp_bending, "N m");
  }
  out.derived("bending coupling" + when, fabric.bending_coupling, "N m");
  out.derived("twist rigidity" + when, fabric.twist_bending, "N m");
  out.derived("mass per area", fabric.area_density, "kg/m^2");
}

void describe_shell(CaseDescription& out, const ShellCase& shell) {
  out.heading("the elements");
  out.enter("shell", "shell");
  out.text("membrane", choices::membrane.name(shell.membrane));
  if (shell.membrane == ShellMembrane::centre) out.maybe_number("hourglass_factor", shell.hourglass_factor);
  out.text("bending", choices::bending.name(shell.bending));
  out.number("shear_correction", shell.shear_correction);
  out.text("director", choices::director.name(shell.director));
  out.number("rotary_inertia", shell.rotary_inertia);
}

void describe_obstacle(CaseDescription& out, const ObstacleCase& obstacle, std::size_t index) {
  const std::string path = fmt::format("obstacle.{}", index);
  const auto enter = [&](const char* kind) {
    out.enter("obstacle", path, kind);
    out.text("name", obstacle.name);
    out.text("kind", kind);
  };
  if (const auto* plane = std::get_if<PlaneShape>(&obstacle.shape)) {
    enter("plane");
    out.vector3("point", plane->point);
    out.vector3("normal", plane->normal);
  } else if (const auto* box = std::get_if<BoxShape>(&obstacle.shape)) {
    enter("box");
    out.vector3("size", box->size);
    out.number("edge_radius", box->edge_radius);
  } else if (const auto* cylinder = std::get_if<CylinderShape>(&obstacle.shape)) {
    enter("cylinder");
    out.number("radius", cylinder->radius);
    out.number("length", cylinder->length);
    out.vector3("axis", cylinder->axis);
    out.number("edge_radius", cylinder->edge_radius);
  } else if (const auto* sphere = std::get_if<SphereShape>(&obstacle.shape)) {
    enter("sphere");
    out.number("radius", sphere->radius);
  } else if (const auto* capsule = std::get_if<CapsuleShape>(&obstacle.shape)) {
    enter("capsule");
    out.number("radius", capsule->radius);
    out.number("length", capsule->length);
    out.vector3("axis", capsule->axis);
  } else if (const auto* disc = std::get_if<DiscPedestalShape>(&obstacle.shape)) {
    enter("disc");
    out.number("radius", disc->radius);
    out.number("height", disc->height);
    out.number("edge_radius", disc->edge_radius);
  }
  if (const auto* mesh = std::get_if<MeshBodyShape>(&obstacle.shape)) {
    enter("mesh");
    out.text("file", mesh->file.string());
    out.verbatim("units", fmt::format("{:.10g} m", mesh->unit));
    out.maybe_number("voxel", mesh->voxel);
  }
  out.number("friction", obstacle.friction);
  describe_place(out, path, obstacle.place);
  if (obstacle.motion) describe_course(out, "obstacle.motion", path + ".motion", *obstacle.motion);
}

void describe_contact(CaseDescription& out, const ContactCase& contact) {
  out.heading("contact");
  out.enter("contact", "contact");
  out.verbatim("self", contact.self ? "true" : "false");
  if (contact.self) out.number("friction", contact.friction);
  out.number("thickness", contact.thickness);
  out.maybe_number("stiffness", contact.stiffness);
  out.number("smoothing", contact.smoothing);
  out.number("penetration", contact.penetration);
  out.number("friction_speed", contact.friction_speed);
  out.maybe_number("restitution", contact.restitution);
  if (contact.restitution) out.number("restitution_speed", contact.restitution_speed);
}

}  // namespace

std::string describe(const Case& resolved) {
  CaseDescription out;
  out.enter("", "");
  out.text("title", resolved.title);
  out.text("model", choices::model.name(resolved.model));
  out.text("analysis", to_string(resolved.analysis));
  const bool several = resolved.pieces.size() > 1;
  for (std::size_t k = 0; k < resolved.pieces.size(); ++k) {
    const auto& piece = resolved.pieces[k];
    const std::string path = several ? fmt::format("cloth.{}", k) : "cloth";
    out.heading(several ? fmt::format("sheet '{}'", piece.name) : "the sheet");
    describe_cloth(out, piece.cloth, path);
    out.heading(several ? fmt::format("the fabric of '{}'", piece.name) : "the fabric");
    describe_fabric(out, resolved, piece, several ? path + ".material" : "material");
  }
  if (resolved.model == Model::shell) describe_shell(out, resolved.shell);
  if (!resolved.fixes.empty()) out.heading("supports");
  for (std::size_t i = 0; i < resolved.fixes.size(); ++i) describe_fix(out, resolved.fixes[i], i);
  for (std::size_t i = 0; i < resolved.motions.size(); ++i) describe_motion(out, resolved.motions[i], i);
  if (!resolved.loads.empty()) out.heading("loads");
  for (std::size_t i = 0; i < resolved.loads.size(); ++i) describe_load(out, resolved.loads[i], i);
  if (!resolved.obstacles.empty()) out.heading("obstacles");
  for (std::size_t i = 0; i < resolved.obstacles.size(); ++i) describe_obstacle(out, resolved.obstacles[i], i);
  if (!resolved.obstacles.empty()) describe_contact(out, resolved.contact);
  out.heading("the analysis");
  if (resolved.analysis == Analysis::dynamics)
    describe_dynamics(out, resolved.dynamics);
  else if (resolved.analysis == Analysis::relaxation)
    describe_relaxation(out, resolved.relaxation);
  else
    describe_arc_length(out, resolved.arc_length, resolved.stages());
  if (!resolved.sensitivities.empty()) out.heading("differentiated by");
  for (const auto& parameter : resolved.sensitivities) out.derived(parameter.key, parameter.value, parameter.unit);
  describe_output(out, resolved.output, resolved.model);
  return out.print();
}

}  // namespace sundrape
