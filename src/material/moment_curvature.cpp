#include "sundrape/material/moment_curvature.hpp"

#include <stdexcept>

namespace sundrape {

MomentCurvature MomentCurvature::linear(double rigidity) {
  if (!(std::isfinite(rigidity) && rigidity > 0))
    throw std::invalid_argument("the bending rigidity must be positive [N m]");
  MomentCurvature law;
  law.alpha_[0] = rigidity;
  law.terms_ = 1;
  law.max_ = 1e100;
  law.linear_ = true;
  return law;
}

MomentCurvature MomentCurvature::polynomial(std::span<const double> coefficients, double max_curvature) {
  if (coefficients.empty() || coefficients.size() > most_terms)
    throw std::invalid_argument("a moment-curvature polynomial has one to nine coefficients");
  if (!std::ranges::all_of(coefficients, [](double c) { return std::isfinite(c); }))
    throw std::invalid_argument("a coefficient of the moment-curvature polynomial is not finite");
  if (!(std::isfinite(max_curvature) && max_curvature > 0))
    throw std::invalid_argument("the largest curvature of a bending test must be positive [1/m]");
  MomentCurvature law;
  std::ranges::copy(coefficients, law.alpha_.begin());
  law.terms_ = coefficients.size();
  law.max_ = max_curvature;
  constexpr int samples = 1000;  // far more than nine terms can wiggle between
  for (int i = 0; i <= samples; ++i)
    if (!(law.at(i * max_curvature / samples).slope > 0))
      throw std::invalid_argument("the moment of the polynomial does not grow all the way to its largest curvature");
  return law;
}

MomentCurvature MomentCurvature::scaled(double factor) const {
  auto law = *this;
  for (double& coefficient : law.alpha_) coefficient *= factor;
  return law;
}

}  // namespace sundrape
