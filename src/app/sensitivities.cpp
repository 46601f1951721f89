#include "sundrape/app/sensitivities.hpp"

#include <cmath>

#include <fmt/format.h>

#include "sundrape/app/solver_choice.hpp"
#include "sundrape/io/case_error.hpp"
#include "sundrape/io/case_parameter.hpp"

namespace sundrape {

Sensitivities::Sensitivities(const Case& c, const CaseModel& model)
    : model_(model),
      exact_(build_model(c, FrictionMatrix::tangent)),
      statics_(*exact_.system, neutral_frequency(model)) {
  for (const auto& p : c.sensitivities) {
    const double size = std::abs(p.value), change = ParameterDerivative::relative_change * size;
    for (const double value : {p.value - change, p.value + change})
      if (!p.range.contains(value))
        throw CaseError(p.source,
                        fmt::format("'{}' is {:.10g}, at the edge of {}: a derivative needs room on both sides", p.key,
                                    p.value, p.range.text()));
    Parameter made{size, build_model(with_parameter(c, p, p.value + change)), nullptr};
    try {
      made.derivative = std::make_unique<ParameterDerivative>(*exact_.system, *made.changed.system);
    } catch (const std::invalid_argument& problem) {
      throw CaseError(p.source, fmt::format("'{}': {}", p.key, problem.what()));
    }
    parameters_.push_back(std::move(made));
  }
}

std::vector<Vector> Sensitivities::of_start() const {
  std::vector<Vector> start;
  start.reserve(parameters_.size());
  for (const auto& p : parameters_)
    start.emplace_back((p.changed.initial - model_.initial) / ParameterDerivative::relative_change);
  return start;
}

std::vector<ParameterDerivative*> Sensitivities::derivatives() {
  std::vector<ParameterDerivative*> all;
  all.reserve(parameters_.size());
  for (auto& p : parameters_) all.push_back(p.derivative.get());
  return all;
}

std::vector<const CaseModel*> Sensitivities::models() const {
  std::vector<const CaseModel*> all;
  all.reserve(parameters_.size() + 1);
  for (const auto& p : parameters_) all.push_back(&p.changed);
  all.push_back(&exact_);
  return all;
}

std::vector<FrameSensitivity> Sensitivities::at_equilibrium(const State& all) {
  if (!statics_.move_to(all)) return {};
  std::vector<FrameSensitivity> result;
  for (auto& p : parameters_) {
    const auto s = statics_.derivative(*p.derivative);
    if (!s) return {};
    result.push_back({model_.of_nodes(*s) / p.size, Vector::Zero(3 * static_cast<Eigen::Index>(model_.mesh.nodes()))});
  }
  return result;
}

std::vector<FrameSensitivity> Sensitivities::of_motion(const ForwardSensitivity& motion, double time) {
  std::vector<FrameSensitivity> result;
  Vector s(model_.initial.size()), s_dot(s.size());
  for (std::size_t k = 0; k < parameters_.size(); ++k) {
    motion.at(time, k, s, s_dot);
    result.push_back({model_.of_nodes(s) / parameters_[k].size, model_.of_nodes(s_dot) / parameters_[k].size});
  }
  return result;
}

}  // namespace sundrape
