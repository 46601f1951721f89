#include <fmt/format.h>
#include <fmt/ranges.h>

#include "describe_parts.hpp"

namespace sundrape {
namespace {

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

/// Names of the axes that are set, quoted, with `prefix` before each.
std::vector<std::string> axis_names(const std::array<bool, 3>& axes, std::string_view prefix = "") {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < 3; ++i)
    if (axes[i]) names.push_back(fmt::format("\"{}{}\"", prefix, "xyz"[i]));
  return names;
}

void describe_stages(CaseDescription& out, const std::vector<double>& stages) {
  if (stages != std::vector<double>{1}) out.numbers("stages", stages);
}

void describe_grip(CaseDescription& out, const GripCase& grip) {
  out.maybe_number("grip", grip.from);
  out.maybe_number("release", grip.until);
}

void describe_keyframes(CaseDescription& out, const std::string& section, const std::string& path,
                        const KeyframePath& keyframes) {
  const auto& frames = keyframes.keyframes;
  for (std::size_t k = 1; k < frames.times().size(); ++k) {
    const Vector at = frames.values().col(static_cast<Eigen::Index>(k));
    out.enter("motion.path.points", fmt::format("{}.points.{}", path, k - 1));
    out.number("time", frames.times()[k]);
    out.vector3("by", at.head<3>());
    out.number("angle", at[3]);
  }
  out.enter(section, path, "keyframes");
  out.text("kind", "keyframes");
  out.vector3("pivot", keyframes.centre);
  out.vector3("turn_axis", keyframes.axis);
}

}  // namespace

void describe_fix(CaseDescription& out, const FixCase& fix, std::size_t index) {
  out.enter("fix", fmt::format("fix.{}", index));
  out.text("name", fix.name);
  out.verbatim("nodes", std::visit(SelectorText{}, fix.nodes));
  auto held = axis_names(fix.components);
  if (fix.rotation)
    held.emplace_back("\"rotation\"");
  else
    for (auto& name : axis_names(fix.director, "director-")) held.push_back(std::move(name));
  out.verbatim("components", fmt::format("[{}]", fmt::join(held, ", ")));
  describe_grip(out, fix.grip);
}

void describe_motion(CaseDescription& out, const MotionCase& motion, std::size_t index) {
  out.enter("motion", fmt::format("motion.{}", index));
  out.text("name", motion.name);
  out.verbatim("nodes", std::visit(SelectorText{}, motion.nodes));
  auto carried = axis_names(motion.components);
  if (motion.rotation) carried.emplace_back("\"rotation\"");
  out.verbatim("components", fmt::format("[{}]", fmt::join(carried, ", ")));
  describe_stages(out, motion.course.stages);
  describe_grip(out, motion.grip);
  describe_course(out, "motion.path", fmt::format("motion.{}.path", index), motion.course);
}

void describe_course(CaseDescription& out, const std::string& section, const std::string& path,
                     const PathCase& course) {
  if (const auto* arc = std::get_if<ArcPath>(&course.path)) {
    out.enter(section, path, "arc");
    out.text("kind", "arc");
    out.vector3("centre", arc->centre);
    out.vector3("axis", arc->axis);
    out.number("angle", arc->angle);
  } else if (const auto* line = std::get_if<LinePath>(&course.path)) {
    out.enter(section, path, "line");
    out.text("kind", "line");
    out.vector3("by", line->by);
  } else {
    describe_keyframes(out, section, path, std::get<KeyframePath>(course.path));
  }
  out.number("start", course.start);
  const auto* keyframes = std::get_if<KeyframePath>(&course.path);
  if (course.duration && keyframes == nullptr) out.number("duration", *course.duration);
  const bool smooth = keyframes ? keyframes->keyframes.between() == Keyframes::Between::smooth : course.smooth;
  out.text("profile", smooth ? "smooth" : "linear");
  if (section == "obstacle.motion") describe_stages(out, course.stages);
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
  } else if (const auto* wind = std::get_if<WindLoad>(&load.load)) {
    enter("wind");
    out.vector3("velocity", wind->field.velocity);
    out.number("density", wind->air.density);
    out.number("drag", wind->air.drag);
    out.number("lift", wind->air.lift);
    if (!wind->field.gust.isZero()) {
      out.enter("gust", fmt::format("load.{}.gust", index));
      out.vector3("amplitude", wind->field.gust);
      out.number("period", wind->field.period);
      out.verbatim("seed", fmt::format("{}", wind->field.seed));
      out.enter("load", fmt::format("load.{}", index), "wind");
    }
  }
  out.number("ramp", load.ramp);
  describe_stages(out, load.stages);
}

}  // namespace sundrape
