#include <algorithm>

#include <fmt/format.h>

#include "case_parts.hpp"

namespace sundrape {
namespace {

/// Derivatives with respect to parameters go along with what changes smoothly with them.
void require_smooth_motion(const CaseSection& section, const Case& resolved) {
  const auto refuse = [&](const std::string& why) { section.fail("parameters", why); };
  const auto integrator = resolved.dynamics.integrator;
  if (integrator != IntegratorKind::cvode && integrator != IntegratorKind::ida)
    refuse("sensitivities need dynamics.integrator = \"cvode\" or \"ida\"");
  if (resolved.contact.restitution && !resolved.obstacles.empty())
    refuse("impacts with contact.restitution happen at instants that depend on parameters: leave it out");
  const auto closes = [](const auto& support) { return support.grip.from.has_value(); };
  if (std::ranges::any_of(resolved.fixes, closes) || std::ranges::any_of(resolved.motions, closes))
    refuse("a gripper that closes on the way holds what depends on parameters: leave its `from` out");
}

}  // namespace

std::vector<ParameterCase> resolve_sensitivities(const CaseSection& top, const Case& resolved) {
  const CaseSection section = top.table("sensitivity");
  const auto keys = section.texts("parameters");
  std::vector<ParameterCase> parameters;
  for (std::size_t k = 0; k < keys.size(); ++k) {
    auto asked = section.source("parameters");
    if (std::find(keys.begin(), keys.begin() + static_cast<std::ptrdiff_t>(k), keys[k]) !=
        keys.begin() + static_cast<std::ptrdiff_t>(k))
      section.fail("parameters", fmt::format("'{}' stands there twice", keys[k]));
    auto parameter = find_parameter(top, keys[k], asked);
    if (parameter.value == 0)
      section.fail("parameters", fmt::format("'{}' is 0, where there is no relative change to differentiate by: give "
                                             "it a small value",
                                             keys[k]));
    parameters.push_back(std::move(parameter));
  }
  if (!parameters.empty() && resolved.analysis == Analysis::dynamics) require_smooth_motion(section, resolved);
  return parameters;
}

}  // namespace sundrape
