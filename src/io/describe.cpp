#include <span>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "sundrape/io/case_reader.hpp"

#include "case_choices.hpp"
#include "case_description.hpp"

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

void describe_cloth(CaseDescription& out, const ClothCase& cloth) {
  out.heading("the sheet");
  const auto enter = [&](const char* shape) {
    out.enter("cloth", "cloth", shape);
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
  describe_place(out, "cloth", cloth.place);
  if (cloth.start) {
    out.enter("cloth", "cloth");
    out.text("start", cloth.start->file.string());
  }
  if (cloth.waviness_given.value_or(false)) {
    out.enter("waviness", "cloth.waviness");
    out.number("amplitude", cloth.waviness_amplitude);
    out.verbatim("seed", fmt::format("{}", cloth.waviness_seed));
  }
}

std::string list_text(std::span<const double> numbers) {
  std::vector<std::string> printed;
  for (const double number : numbers) printed.push_back(fmt::format("{:.10g}", number));
  return fmt::format("[{}]", fmt::join(printed, ", "));
}

void describe_bending(CaseDescription& out, const Fabric::MeasuredBending& bending) {
  out.enter("material.bending", "material.bending", "polynomial");
  out.text("law", "polynomial");
  out.verbatim("coefficients", fmt::format("[{}, {}] of N over powers of 1/m", list_text(bending.warp.coefficients()),
                                           list_text(bending.weft.coefficients())));
  out.numbers("max_curvature", {bending.warp.max_curvature(), bending.weft.max_curvature()});
  out.text("form", bending.form == PlateBending::Form::paper ? "paper" : "energy");
}

void describe_net(CaseDescription& out, const Fabric::Net& net) {
  out.enter("material.net", "material.net");
  out.number("compression_factor", net.compression_factor);
  out.number("shear_factor", net.shear_factor);
  out.text("shear", net.diagonal_springs ? "diagonals" : "cell");
  out.number("diagonal_compression_factor", net.diagonal_compression_factor);
}

void describe_fabric(CaseDescription& out, const std::string& title, const Fabric& fabric, Model model) {
  out.heading("the fabric");
  out.enter("material", "material");
  if (!title.empty()) out.text("title", title);
  out.number("thickness", fabric.thickness);
  out.number("density_area", fabric.area_density);
  out.number("poisson", fabric.poisson);
  if (fabric.measured_bending) describe_bending(out, *fabric.measured_bending);
  out.enter("material.damping", "material.damping");
  out.number("mass", fabric.damping.mass);
  out.number("membrane", fabric.damping.membrane);
  out.number("bending", fabric.damping.bending);
  if (model == Model::particle) describe_net(out, fabric.net);
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

std::string point_text(const Vector3& p) { return fmt::format("[{:.10g}, {:.10g}, {:.10g}]", p.x(), p.y(), p.z()); }

struct SelectorText {
  std::string operator()(const NamedSet& set) const { return fmt::format("\"{}\"", set.name); }
  std::string operator()(const Near& near) const { return fmt::format("{{ near = {} m }}", point_text(near.point)); }
  std::string operator()(const InBox& box) const {
    return fmt::format("{{ box = [{}, {}] m }}", point_text(box.low), point_text(box.high));
  }
  std::string operator()(const OnPlane& plane) const {
    return fmt::format("{{ plane: point {} m, normal {} }}", point_text(plane.point), point_text(plane.normal));
  }
  std::string operator()(const InSphere& ball) const {
    return fmt::format("{{ sphere: centre {} m, radius {:.10g} m }}", point_text(ball.centre), ball.radius);
  }
};

void describe_fix(CaseDescription& out, const FixCase& fix, std::size_t index) {
  out.enter("fix", fmt::format("fix.{}", index));
  out.text("name", fix.name);
  out.verbatim("nodes", std::visit(SelectorText{}, fix.nodes));
  std::vector<std::string> held;
  for (std::size_t i = 0; i < 3; ++i)
    if (fix.components[i]) held.push_back(fmt::format("\"{}\"", "xyz"[i]));
  if (fix.rotation) held.emplace_back("\"rotation\"");
  for (std::size_t i = 0; i < 3; ++i)
    if (fix.director[i] && !fix.rotation) held.push_back(fmt::format("\"director-{}\"", "xyz"[i]));
  out.verbatim("components", fmt::format("[{}]", fmt::join(held, ", ")));
}

void describe_load(CaseDescription& out, const LoadCase& load, std::size_t index) {
  const auto enter = [&](const char* kind) {
    out.enter("load", fmt::format("load.{}", index), kind);
    out.text("kind", kind);
  };
  if (const auto* gravity = std::get_if<GravityLoad>(&load.load)) {
    enter("gravity");
    out.vector3("acceleration", gravity->acceleration);
  } else if (const auto* force = std::get_if<ForceLoad>(&load.load)) {
    enter("force");
    out.verbatim("nodes", std::visit(SelectorText{}, force->nodes));
    out.vector3("total", force->total);
  } else if (const auto* moment = std::get_if<MomentLoad>(&load.load)) {
    enter("moment");
    out.verbatim("nodes", std::visit(SelectorText{}, moment->nodes));
    out.vector3("total", moment->total);
  } else if (const auto* traction = std::get_if<TractionLoad>(&load.load)) {
    enter("traction");
    out.verbatim("nodes", std::visit(SelectorText{}, traction->nodes));
    out.vector3("per_length", traction->per_length);
  } else if (const auto* pressure = std::get_if<PressureLoad>(&load.load)) {
    enter("pressure");
    out.number("value", pressure->value);
  }
  out.number("ramp", load.ramp);
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
  describe_place(out, path, obstacle.place);
}

void describe_contact(CaseDescription& out, const ContactCase& contact) {
  out.heading("contact");
  out.enter("contact", "contact");
  out.number("thickness", contact.thickness);
  out.maybe_number("stiffness", contact.stiffness);
  out.number("smoothing", contact.smoothing);
  out.number("penetration", contact.penetration);
  out.maybe_number("restitution", contact.restitution);
  if (contact.restitution) out.number("restitution_speed", contact.restitution_speed);
}

void describe_dynamics(CaseDescription& out, const DynamicsCase& dynamics) {
  out.enter("dynamics", "dynamics");
  out.text("integrator", choices::integrator.name(dynamics.integrator));
  out.number("duration", dynamics.duration);
  out.number("rtol", dynamics.rtol);
  out.maybe_number("atol_position", dynamics.atol_position);
  out.maybe_number("atol_velocity", dynamics.atol_velocity);
  out.verbatim("max_order", fmt::format("{}", dynamics.max_order));
  if (dynamics.integrator == IntegratorKind::rk4) out.maybe_number("step", dynamics.step);
  out.maybe_number("max_step", dynamics.max_step);
  out.maybe_number("first_step", dynamics.first_step);
  out.text("linear_solver", dynamics.linear_solver);
  out.maybe_number("until_rest", dynamics.until_rest);
  out.maybe_number("time_limit", dynamics.time_limit);
}

void describe_relaxation(CaseDescription& out, const RelaxationCase& relaxation) {
  out.enter("relaxation", "relaxation");
  out.number("tolerance", relaxation.tolerance);
  out.text("scheme", relaxation.scheme);
  if (relaxation.max_iterations) out.verbatim("max_iterations", fmt::format("{}", *relaxation.max_iterations));
  out.maybe_number("first_step", relaxation.first_step);
  out.number("growth", relaxation.growth);
  out.text("linear_solver", relaxation.linear_solver);
  if (relaxation.scheme == "chapter") {
    out.maybe_number("c_disp", relaxation.c_disp);
    out.maybe_number("c_acc", relaxation.c_acc);
  }
  out.maybe_number("time_limit", relaxation.time_limit);
}

void describe_output(CaseDescription& out, const OutputCase& output, Model model) {
  out.heading("output");
  out.enter("output", "output");
  if (!output.frame_times.empty())
    out.verbatim("frames",
                 fmt::format("{} ({} with the one at 0 s)", output.frame_times.size() - 1, output.frame_times.size()));
  out.number("checkpoint_every", output.checkpoint_every);
  if (model == Model::shell) out.verbatim("resultants", output.resultants ? "true" : "false");
  for (std::size_t i = 0; i < output.probes.size(); ++i) {
    out.enter("output.probes", fmt::format("output.probes.{}", i));
    out.text("name", output.probes[i].name);
    out.vector3("near", output.probes[i].near);
  }
}

}  // namespace

std::string describe(const Case& resolved) {
  CaseDescription out;
  out.enter("", "");
  out.text("title", resolved.title);
  out.text("model", choices::model.name(resolved.model));
  out.text("analysis", resolved.analysis == Analysis::dynamics ? "dynamics" : "relaxation");
  describe_cloth(out, resolved.cloth);
  describe_fabric(out, resolved.fabric_title, resolved.fabric, resolved.model);
  if (resolved.model == Model::shell) describe_shell(out, resolved.shell);
  if (!resolved.fixes.empty()) out.heading("supports");
  for (std::size_t i = 0; i < resolved.fixes.size(); ++i) describe_fix(out, resolved.fixes[i], i);
  if (!resolved.loads.empty()) out.heading("loads");
  for (std::size_t i = 0; i < resolved.loads.size(); ++i) describe_load(out, resolved.loads[i], i);
  if (!resolved.obstacles.empty()) out.heading("obstacles");
  for (std::size_t i = 0; i < resolved.obstacles.size(); ++i) describe_obstacle(out, resolved.obstacles[i], i);
  if (!resolved.obstacles.empty()) describe_contact(out, resolved.contact);
  out.heading("the analysis");
  if (resolved.analysis == Analysis::dynamics)
    describe_dynamics(out, resolved.dynamics);
  else
    describe_relaxation(out, resolved.relaxation);
  describe_output(out, resolved.output, resolved.model);
  return out.print();
}

}  // namespace sundrape
