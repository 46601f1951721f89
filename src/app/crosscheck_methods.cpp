#include "crosscheck_methods.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "sundrape/app/crosscheck.hpp"

namespace sundrape {
namespace {

/// Air as thick as makes a pendulum of the sheet's length creep rather than swing, and time enough.
std::vector<std::string> damped_motion(const Case& c, const CaseModel& model) {
  const double swing = std::sqrt(model.size / model.gravity);  // [s]
  std::vector<std::string> sets{
      fmt::format("material.damping.mass={:.6g}", std::max(c.sheet().fabric.damping.mass, 1 / swing)),
      fmt::format("dynamics.duration={:.6g}", 400 * swing), "dynamics.until_rest=1e-9", "dynamics.rtol=1e-5"};
  if (c.dynamics.integrator == IntegratorKind::rk4) sets.emplace_back("dynamics.integrator=cvode");
  return sets;
}

}  // namespace

std::vector<std::string> crosscheck_method_names() { return {"relaxation", "arc-length", "dynamics"}; }

std::vector<Method> crosscheck_methods(const Case& c, const CaseModel& model) {
  std::vector<Method> methods;
  for (const auto& name : crosscheck_method_names()) {
    Method method{.name = name, .sets = {}};
    // cloth does not stay on a path that has lost its stability
    if (name == "arc-length") method.sets.emplace_back("arc-length.when_unstable=fall");
    if (name == "dynamics") {
      const auto motion = damped_motion(c, model);
      method.sets.insert(method.sets.end(), motion.begin(), motion.end());
    }
    methods.push_back(std::move(method));
  }
  return methods;
}

std::vector<std::string> common_settings(const Case& c) {
  if (c.sheet().cloth.waviness_given || c.sheet().cloth.start) return {};
  return {fmt::format("cloth.waviness={{ amplitude = {:.6g}, seed = 1 }}", default_waviness(c.sheet()))};
}

}  // namespace sundrape
