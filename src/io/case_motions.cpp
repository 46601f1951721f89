#include <algorithm>

#include <fmt/format.h>

#include "sundrape/io/case_error.hpp"

#include "case_parts.hpp"

namespace sundrape {
namespace {

KeyframePath resolve_keyframes(const CaseSection& path) {
  const auto points = path.tables("points");
  const auto n = static_cast<Eigen::Index>(points.size());
  std::vector<double> times{0};
  Eigen::MatrixXd values = Eigen::MatrixXd::Zero(4, n + 1);
  for (const auto& point : points) {
    const double time = point.number("time");
    if (!(time > times.back())) point.fail("time", "is not after the one before: times of keyframes ascend");
    const auto k = static_cast<Eigen::Index>(times.size());
    values.col(k).head<3>() = point.vector3("by");
    values(3, k) = point.number("angle");
    times.push_back(time);
  }
  if (n == 0) path.fail("points", "has no keyframe");
  const auto between = path.text("profile") == "smooth" ? Keyframes::Between::smooth : Keyframes::Between::straight;
  return {Keyframes(std::move(times), std::move(values), between), path.vector3("pivot"), path.direction("turn_axis")};
}

RigidPath resolve_path(const CaseSection& path) {
  const auto kind = path.text("kind");
  if (kind == "line") return LinePath{path.vector3("by")};
  if (kind == "arc") return ArcPath{path.vector3("centre"), path.direction("axis"), path.number("angle")};
  return resolve_keyframes(path);
}

}  // namespace

PathCase resolve_course(const CaseSection& section, Analysis analysis) {
  PathCase course;
  course.path = resolve_path(section);
  course.start = section.number("start");
  if (const auto* keyframes = std::get_if<KeyframePath>(&course.path)) {
    course.duration = keyframes->keyframes.times().back();
    course.smooth = false;  // the spline itself starts and stops smoothly
  } else {
    course.duration = section.maybe_number("duration");
    course.smooth = section.text("profile") == "smooth";
  }
  if (!course.duration && analysis != Analysis::arc_length)
    section.fail("duration", "missing: how long the path takes; only arc-length, which goes by stages, does without");
  return course;
}

GripCase resolve_grip(const CaseSection& section, Analysis analysis) {
  const GripCase grip{.from = section.maybe_number("grip"), .until = section.maybe_number("release")};
  for (const char* key : {"grip", "release"})
    if (section.has(key) && analysis != Analysis::dynamics)
      section.fail(key, "needs analysis = \"dynamics\": statics holds its supports all the way");
  if (grip.until && *grip.until <= grip.from.value_or(0)) section.fail("release", "is not after the grip");
  return grip;
}

void require_directors(const CaseSection& section, Model model) {
  if (model == Model::particle)
    section.fail(
        "components",
        "'rotation' with a `grip` needs model = \"shell\": the slope of a particle net's edge can only be held "
        "from the start");
}

std::vector<MotionCase> resolve_motions(const std::vector<CaseSection>& sections, const std::vector<FixCase>& fixes,
                                        Model model, Analysis analysis) {
  std::vector<MotionCase> motions;
  const auto taken = [&](const std::string& name) {
    return std::ranges::any_of(fixes, [&](const FixCase& fix) { return fix.name == name; }) ||
           std::ranges::any_of(motions, [&](const MotionCase& motion) { return motion.name == name; });
  };
  for (const auto& section : sections) {
    MotionCase motion;
    motion.nodes = section.selector("nodes");
    motion.source = section.source("nodes");
    const auto chosen = section.choices("components");
    for (std::size_t c = 0; c < 3; ++c)
      motion.components[c] = std::ranges::find(chosen, std::string(1, "xyz"[c])) != chosen.end();
    motion.rotation = std::ranges::find(chosen, "rotation") != chosen.end();
    motion.course = resolve_course(section.table("path"), analysis);
    motion.course.stages = section.series("stages");
    motion.grip = resolve_grip(section, analysis);
    if (motion.grip.from && motion.rotation) require_directors(section, model);
    if (motion.grip.from && !section.table("path").has("start")) motion.course.start = *motion.grip.from;
    if (motion.course.start < motion.grip.from.value_or(0))
      section.table("path").fail("start", "is before the grip: a path starts when the nodes are held, or later");
    if (section.has("name")) {
      motion.name = section.text("name");
      if (taken(motion.name)) section.fail("name", fmt::format("'{}' is the name of another support", motion.name));
    } else {
      const std::string base = name_of(motion.nodes);
      motion.name = base;
      for (int i = 2; taken(motion.name); ++i) motion.name = fmt::format("{}_{}", base, i);
    }
    motions.push_back(std::move(motion));
  }
  return motions;
}

void resolve_moving_defaults(const CaseSection& top, Case& resolved) {
  constexpr int default_times = 20;
  constexpr double default_breaking_strain = 0.5;
  const bool moves = resolved.moves();
  if (moves && !resolved.breaking_strain) resolved.breaking_strain = default_breaking_strain;
  if (resolved.analysis == Analysis::relaxation) {
    const auto relaxation = top.table("relaxation");
    auto& times = resolved.relaxation.times;
    if (!moves && !times.empty()) relaxation.fail("times", "needs a [[motion]] or an obstacle with a motion");
    if (moves && resolved.relaxation.scheme == "chapter")
      relaxation.fail("scheme", "the chapter's scheme knows no moving supports: \"implicit\" does");
    if (moves && times.empty())
      for (int k = 0; k <= default_times; ++k) times.push_back(resolved.end_of_paths() * k / default_times);
  }
  const auto holds_in_time = [](const auto& support) { return !support.grip.always(); };
  if (resolved.contact.restitution && (!resolved.motions.empty() || std::ranges::any_of(resolved.fixes, holds_in_time)))
    top.table("contact").fail("restitution", "impacts know no supports that move, close or open");
  if (resolved.contact.restitution)
    for (const auto& obstacle : resolved.obstacles)
      if (obstacle.motion || obstacle.friction > 0)
        top.table("contact").fail("restitution", "impacts know no moving obstacles and no friction");
}

}  // namespace sundrape
