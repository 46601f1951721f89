#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "case_parts.hpp"

namespace sundrape {
namespace {

void resolve_linear(const CaseSection& bending, Fabric& fabric) {
  const auto strips = bending.numbers("rigidity");
  const double warp = strips.front(), weft = strips.back();
  if (!(fabric.poisson * fabric.poisson * weft < warp))
    bending.fail("rigidity", fmt::format("with poisson = {} the rigidity of the weft must stay below {:.4g} times that "
                                         "of the warp: no elastic sheet bends like this",
                                         fabric.poisson, 1 / (fabric.poisson * fabric.poisson)));
  set_measured_bending(fabric, warp, weft, bending.maybe_number("twist_rigidity"));
}

/// α_k of a curvature in 1/m and a moment per width in N, from those in the units of the test.
MomentCurvature resolve_law(const CaseSection& bending, std::vector<double> coefficients, double max_curvature) {
  const double curvature = bending.unit("curvature_unit"), moment = bending.unit("moment_unit");
  for (std::size_t k = 0; k < coefficients.size(); ++k)
    coefficients[k] *= moment / std::pow(curvature, static_cast<double>(k + 1));
  try {
    return MomentCurvature::polynomial(coefficients, max_curvature);
  } catch (const std::invalid_argument& problem) {
    bending.fail("coefficients", problem.what());
  }
}

void resolve_polynomial(const CaseSection& bending, Fabric& fabric) {
  const auto coefficients = bending.lists("coefficients");
  const auto max_curvature = bending.numbers("max_curvature");
  const auto form = bending.text("form") == "paper" ? PlateBending::Form::paper : PlateBending::Form::energy;
  const auto warp = resolve_law(bending, coefficients.front(), max_curvature.front());
  const auto weft = resolve_law(bending, coefficients.back(), max_curvature.back());
  try {
    set_measured_bending(fabric, Fabric::MeasuredBending{warp, weft, form});
  } catch (const std::invalid_argument& problem) {
    bending.fail("coefficients", problem.what());
  }
}

}  // namespace

void resolve_bending(const CaseSection& bending, Fabric& fabric) {
  if (bending.text("law") == "linear")
    resolve_linear(bending, fabric);
  else
    resolve_polynomial(bending, fabric);
}

}  // namespace sundrape
