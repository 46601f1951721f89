#include "fit_report.hpp"

#include <cmath>
#include <iterator>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "sundrape/io/case_parameter.hpp"

namespace sundrape {
namespace {

constexpr double strong_correlation = 0.95;
constexpr double untold = 1;              // standard error over the value
constexpr double nearly_singular = 1e-8;  // reciprocal condition of the scaled normal equations

std::vector<std::string> doubts(const Fit& fit, const FitOutcome& outcome) {
  std::vector<std::string> warnings;
  const auto& u = outcome.uncertainty;
  const auto& at = outcome.search.at;
  for (std::size_t k = 0; k < fit.parameters.size(); ++k) {
    const auto& p = fit.parameters[k];
    const auto i = static_cast<Eigen::Index>(k);
    if (!(outcome.estimates[k].relative_error < untold))
      warnings.push_back(fmt::format("the data hardly tell {}: its standard error is {:.3g} of its value",
                                     p.parameter.key, outcome.estimates[k].relative_error));
    const double value = value_of(p, at[i]);
    if (value <= p.lower * (1 + 1e-12) || value >= p.upper * (1 - 1e-12))
      warnings.push_back(fmt::format("{} ends at a bound: its interval means nothing", p.parameter.key));
    for (std::size_t l = 0; l < k; ++l)
      if (std::abs(u.correlation(i, static_cast<Eigen::Index>(l))) > strong_correlation)
        warnings.push_back(fmt::format("{} and {} are correlated by {:.4f}: the data tell a combination of them",
                                       fit.parameters[l].parameter.key, p.parameter.key,
                                       u.correlation(i, static_cast<Eigen::Index>(l))));
  }
  if (u.reciprocal_condition < nearly_singular)
    warnings.push_back(
        fmt::format("a combination of the parameters changes nothing that was measured (reciprocal "
                    "condition {:.1g}): measure something else too, or fix one of them",
                    u.reciprocal_condition));
  if (!u.by_residuals)
    warnings.emplace_back("as many numbers as parameters: intervals go by the standard deviations as given");
  if (u.by_residuals && u.residual_variance > 4)
    warnings.push_back(
        fmt::format("the residuals are {:.2g} times the standard deviations given: the model misses the "
                    "data, or these are too small",
                    std::sqrt(u.residual_variance)));
  return warnings;
}

}  // namespace

const char* to_string(LeastSquaresResult::End end) {
  using End = LeastSquaresResult::End;
  switch (end) {
    case End::converged:
      return "converged";
    case End::stalled:
      return "stalled";
    case End::out_of_iterations:
      return "out of iterations";
    default:
      return "interrupted";
  }
}

double value_of(const FitParameter& parameter, double varied) {
  return parameter.logarithmic ? std::exp(varied) : varied;
}

FitOutcome fit_outcome(const Fit& fit, LeastSquaresResult search) {
  FitOutcome outcome{std::move(search), {}, {}, {}};
  outcome.uncertainty = uncertainty(outcome.search.point, fit.confidence);
  const auto& u = outcome.uncertainty;
  for (std::size_t k = 0; k < fit.parameters.size(); ++k) {
    const auto& p = fit.parameters[k];
    const double at = outcome.search.at[static_cast<Eigen::Index>(k)];
    const double error = u.standard_error[static_cast<Eigen::Index>(k)], value = value_of(p, at);
    outcome.estimates.push_back({.value = value,
                                 .low = value_of(p, at - u.quantile * error),
                                 .high = value_of(p, at + u.quantile * error),
                                 .relative_error = p.logarithmic ? error : error / std::abs(value)});
  }
  outcome.warnings = doubts(fit, outcome);
  return outcome;
}

std::string fit_text(const Fit& fit, const FitOutcome& outcome) {
  std::string text;
  const auto out = std::back_inserter(text);
  const auto& u = outcome.uncertainty;
  fmt::format_to(out, "{}: {} after {} runs; {} numbers, chi^2 = {:.4g}\n", fit.title, to_string(outcome.search.end),
                 outcome.search.iterations, fit.numbers(), outcome.search.point.chi_squared());
  fmt::format_to(out, "  {:<32} {:>13} {:>9}   {:.0f} % interval\n", "parameter", "value", "st. err.",
                 100 * fit.confidence);
  for (std::size_t k = 0; k < fit.parameters.size(); ++k) {
    const auto& e = outcome.estimates[k];
    const auto& p = fit.parameters[k].parameter;
    fmt::format_to(out, "  {:<32} {:>13.6g} {:>7.2g} %   {:.6g} to {:.6g} {}\n", p.key, e.value, 100 * e.relative_error,
                   e.low, e.high, p.unit == "1" ? "" : p.unit);
  }
  if (fit.parameters.size() > 1) {
    text += "  correlation\n";
    for (Eigen::Index i = 0; i < u.correlation.rows(); ++i) {
      text += "   ";
      for (Eigen::Index k = 0; k <= i; ++k) fmt::format_to(out, " {:7.4f}", u.correlation(i, k));
      text += '\n';
    }
  }
  for (const auto& warning : outcome.warnings) fmt::format_to(out, "  warning: {}\n", warning);
  return text;
}

nlohmann::json fit_json(const Fit& fit, const FitOutcome& outcome) {
  const auto& u = outcome.uncertainty;
  nlohmann::json json{{"title", fit.title},
                      {"status", to_string(outcome.search.end)},
                      {"runs", outcome.search.iterations},
                      {"numbers", fit.numbers()},
                      {"chi_squared", outcome.search.point.chi_squared()},
                      {"residual_variance", u.residual_variance},
                      {"confidence", fit.confidence},
                      {"quantile", u.quantile},
                      {"reciprocal_condition", u.reciprocal_condition},
                      {"warnings", outcome.warnings}};
  json["parameters"] = nlohmann::json::array();
  json["settings"] = nlohmann::json::array();
  json["correlation"] = nlohmann::json::array();
  for (std::size_t k = 0; k < fit.parameters.size(); ++k) {
    const auto& e = outcome.estimates[k];
    const auto& p = fit.parameters[k].parameter;
    json["parameters"].push_back({{"key", p.key},
                                  {"unit", p.unit},
                                  {"value", e.value},
                                  {"low", e.low},
                                  {"high", e.high},
                                  {"relative_standard_error", e.relative_error}});
    json["settings"].push_back(parameter_setting(p.key, e.value));
    const Vector row = u.correlation.row(static_cast<Eigen::Index>(k));
    json["correlation"].push_back(std::vector<double>(row.begin(), row.end()));
  }
  const auto& r = outcome.search.point.residuals;
  json["residuals"] = std::vector<double>(r.begin(), r.end());
  return json;
}

}  // namespace sundrape
