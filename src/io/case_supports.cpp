#include <algorithm>

#include <fmt/format.h>

#include "sundrape/io/case_error.hpp"

#include "case_parts.hpp"

namespace sundrape {
std::string name_of(const Selector& selector) {
  struct Name {
    std::string operator()(const NamedSet& set) const { return set.name; }
    std::string operator()(const Near&) const { return "near"; }
    std::string operator()(const InBox&) const { return "box"; }
    std::string operator()(const OnPlane&) const { return "plane"; }
    std::string operator()(const InSphere&) const { return "sphere"; }
  };
  return std::visit(Name{}, selector);
}

namespace {

bool same(const Selector& a, const Selector& b) {
  struct Numbers {
    std::vector<Vector3> operator()(const NamedSet&) const { return {}; }
    std::vector<Vector3> operator()(const Near& near) const { return {near.point}; }
    std::vector<Vector3> operator()(const InBox& box) const { return {box.low, box.high}; }
    std::vector<Vector3> operator()(const OnPlane& plane) const { return {plane.point, plane.normal}; }
    std::vector<Vector3> operator()(const InSphere& ball) const {
      return {ball.centre, Vector3::Constant(ball.radius)};
    }
  };
  return name_of(a) == name_of(b) && a.index() == b.index() && std::visit(Numbers{}, a) == std::visit(Numbers{}, b);
}

bool same_components(const FixCase& a, const FixCase& b) {
  return a.components == b.components && a.director == b.director && a.rotation == b.rotation;
}

FixCase resolve_fix(const CaseSection& section, Model model, Analysis analysis) {
  FixCase fix;
  fix.nodes = section.selector("nodes");
  fix.source = section.source("nodes");
  const auto chosen = section.choices("components");
  const auto holds = [&](const char* name) { return std::find(chosen.begin(), chosen.end(), name) != chosen.end(); };
  fix.components = {holds("x"), holds("y"), holds("z")};
  fix.rotation = holds("rotation");
  constexpr std::array director{"director-x", "director-y", "director-z"};
  for (std::size_t i = 0; i < director.size(); ++i) {
    if (holds(director[i]) && model != Model::shell)
      section.fail("components", fmt::format("'{}' needs the director of a shell node, hence model = \"shell\"; "
                                             "'rotation' clamps the slope of a particle net's edge",
                                             director[i]));
    fix.director[i] = fix.rotation || holds(director[i]);
  }
  if (section.has("name")) fix.name = section.text("name");
  fix.grip = resolve_grip(section, analysis);
  if (fix.grip.from && fix.rotation) {
    if (section.has("components")) require_directors(section, model);
    fix.rotation = model == Model::shell;
    fix.director = {fix.rotation, fix.rotation, fix.rotation};
  }
  if (!fix.grip.always() && !fix.rotation && fix.director != std::array{false, false, false})
    section.fail("components", "a `grip` or `release` in time knows 'rotation', but no single component of a director");
  return fix;
}

std::string place_of(const SourceLine& source) {
  return source.line > 0 ? fmt::format("line {}", source.line) : source.file;
}

}  // namespace

std::vector<FixCase> resolve_fixes(const std::vector<CaseSection>& sections, Model model, Analysis analysis) {
  std::vector<FixCase> fixes;
  for (const auto& section : sections) {
    FixCase fix = resolve_fix(section, model, analysis);
    for (const auto& earlier : fixes) {
      if (!fix.name.empty() && fix.name == earlier.name)
        section.fail("name",
                     fmt::format("'{}' is already the name of the support at {}", fix.name, place_of(earlier.source)));
      if (fix.grip.always() && earlier.grip.always() && same(fix.nodes, earlier.nodes) &&
          !same_components(fix, earlier))
        section.fail("nodes", fmt::format("in conflict with the support at {}: the same nodes, but other components",
                                          place_of(earlier.source)));
    }
    fixes.push_back(std::move(fix));
  }
  // Names that the case does not give must not meet those that it does.
  for (auto& fix : fixes) {
    if (!fix.name.empty()) continue;
    const std::string base = name_of(fix.nodes);
    const auto taken = [&](const std::string& name) {
      return std::any_of(fixes.begin(), fixes.end(), [&](const FixCase& other) { return other.name == name; });
    };
    std::string name = base;
    for (int i = 2; taken(name); ++i) name = fmt::format("{}_{}", base, i);
    fix.name = name;
  }
  return fixes;
}

WindLoad resolve_wind(const CaseSection& section) {
  WindLoad wind;
  wind.field.velocity = section.vector3("velocity");
  wind.air = {.density = section.number("density"), .drag = section.number("drag"), .lift = section.number("lift")};
  if (section.has("gust")) {
    const CaseSection gust = section.table("gust");
    wind.field.gust = gust.vector3("amplitude");
    wind.field.period = gust.number("period");
    wind.field.seed = static_cast<unsigned>(gust.integers("seed").front());
  }
  return wind;
}

std::vector<LoadCase> resolve_loads(const std::vector<CaseSection>& sections) {
  std::vector<LoadCase> loads;
  for (const auto& section : sections) {
    LoadCase load;
    load.ramp = section.number("ramp");
    load.stages = section.series("stages");
    const std::string kind = section.text("kind");
    load.source =
        kind == "gravity" || kind == "pressure" || kind == "wind" ? section.source() : section.source("nodes");
    if (kind == "gravity")
      load.load = GravityLoad{section.vector3("acceleration")};
    else if (kind == "force")
      load.load = ForceLoad{section.selector("nodes"), section.vector3("total")};
    else if (kind == "moment")
      load.load = MomentLoad{section.selector("nodes"), section.vector3("total")};
    else if (kind == "traction")
      load.load = TractionLoad{section.selector("nodes"), section.vector3("per_length")};
    else if (kind == "pressure")
      load.load = PressureLoad{section.number("value")};
    else
      load.load = resolve_wind(section);
    loads.push_back(std::move(load));
  }
  return loads;
}

}  // namespace sundrape
