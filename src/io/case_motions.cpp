#include <algorithm>

#include <fmt/format.h>

#include "sundrape/io/case_error.hpp"

#include "case_parts.hpp"

namespace sundrape {
namespace {

RigidPath resolve_path(const CaseSection& path) {
  if (path.text("kind") == "line") return LinePath{path.vector3("by")};
  return ArcPath{path.vector3("centre"), path.direction("axis"), path.number("angle")};
}

}  // namespace

std::vector<MotionCase> resolve_motions(const std::vector<CaseSection>& sections, const std::vector<FixCase>& fixes) {
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
    motion.path = resolve_path(section.table("path"));
    motion.stages = section.series("stages");
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

void require_arc_length_for_motions(const CaseSection& top, const Case& resolved) {
  if (!resolved.motions.empty() && resolved.analysis != Analysis::arc_length)
    throw CaseError(
        top.source("motion"),
        "prescribed motion needs analysis = \"arc-length\" in this version; hold the nodes by [[fix]] instead");
}

}  // namespace sundrape
