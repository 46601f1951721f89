#include "sundrape/app/fit_run.hpp"

#include <cmath>
#include <iostream>
#include <limits>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "sundrape/app/fit_measures.hpp"
#include "sundrape/io/case_parameter.hpp"
#include "sundrape/io/case_reader.hpp"
#include "sundrape/io/file_error.hpp"

#include "fit_report.hpp"
#include "write_text.hpp"

namespace sundrape {
namespace {

/// Runs the case with values of the parameters, and holds the result against the measurements.
class FitRunner {
 public:
  FitRunner(const Fit& fit, std::filesystem::path folder, int threads)
      : fit_(fit), folder_(std::move(folder)), threads_(threads), measures_(fit) {
    const Case c = read_case(fit.case_file, fit.sets);
    // of several equilibria, go on along the one found first
    warm_ = c.analysis == Analysis::relaxation && !c.moves() && c.pieces.size() == 1 && !c.sheet().cloth.start;
  }

  std::optional<LeastSquaresPoint> evaluate(const Vector& at) {
    const auto output = folder_ / "trial.h5";
    RunOptions run;
    run.case_file = fit_.case_file;
    run.sets = fit_.sets;
    run.output = output;
    std::string keys;
    for (std::size_t k = 0; k < fit_.parameters.size(); ++k) {
      const auto& p = fit_.parameters[k];
      const double value = value_of(p, at[static_cast<Eigen::Index>(k)]);
      run.sets.push_back(parameter_setting(p.parameter.key, value));
      keys += fmt::format("{}'{}'", keys.empty() ? "" : ", ", p.parameter.key);
    }
    run.sets.push_back(fmt::format("sensitivity.parameters=[{}]", keys));
    if (warm_ && std::filesystem::exists(best()))
      run.sets.push_back(fmt::format("cloth.start={}", std::filesystem::absolute(best()).string()));
    run.threads = threads_;
    run.overwrite = true;
    run.verbosity = Verbosity::quiet;
    const auto status = run_case(run);
    interrupted_ = status == ExitStatus::interrupted;
    if (status != ExitStatus::done) return std::nullopt;
    auto point = measures_.compare(ResultReader(output));
    for (std::size_t k = 0; k < fit_.parameters.size(); ++k)
      if (const auto i = static_cast<Eigen::Index>(k); fit_.parameters[k].logarithmic)
        point.jacobian.col(i) *= value_of(fit_.parameters[k], at[i]);
    return point;
  }

  /// The last trial is the best so far.
  void keep() const { std::filesystem::rename(folder_ / "trial.h5", best()); }
  void clear() const { std::filesystem::remove(folder_ / "trial.h5"); }
  [[nodiscard]] bool interrupted() const { return interrupted_; }
  [[nodiscard]] std::filesystem::path best() const { return folder_ / "fitted.h5"; }

 private:
  const Fit& fit_;
  std::filesystem::path folder_;
  int threads_;
  FitMeasures measures_;
  bool warm_ = false, interrupted_ = false;
};

LeastSquaresOptions search_options(const Fit& fit) {
  const auto count = std::ssize(fit.parameters);
  LeastSquaresOptions o{.lower = Vector(count),
                        .upper = Vector(count),
                        .scale = Vector(count),
                        .tolerance = fit.tolerance,
                        .max_iterations = fit.max_iterations};
  for (Eigen::Index i = 0; i < count; ++i) {
    const auto& p = fit.parameters[static_cast<std::size_t>(i)];
    o.lower[i] = p.logarithmic ? std::log(p.lower) : p.lower;
    o.upper[i] = p.logarithmic ? std::log(p.upper) : p.upper;
    o.scale[i] = p.logarithmic ? 1 : std::abs(p.parameter.value);
  }
  return o;
}

Vector start_of(const Fit& fit) {
  Vector start(std::ssize(fit.parameters));
  for (Eigen::Index i = 0; i < start.size(); ++i) {
    const auto& p = fit.parameters[static_cast<std::size_t>(i)];
    start[i] = p.logarithmic ? std::log(p.parameter.value) : p.parameter.value;
  }
  return start;
}

std::string values_text(const Fit& fit, const Vector& at) {
  std::vector<std::string> values;
  for (std::size_t k = 0; k < fit.parameters.size(); ++k)
    values.push_back(fmt::format("{:.6g}", value_of(fit.parameters[k], at[static_cast<Eigen::Index>(k)])));
  return fmt::format("{}", fmt::join(values, ", "));
}

}  // namespace

ExitStatus run_fit(const FitOptions& options) {
  const Fit fit = read_fit(options.fit_file);
  const auto folder = options.folder.value_or(options.fit_file.stem());
  std::error_code problem;
  std::filesystem::create_directories(folder, problem);
  if (problem) throw FileError(fmt::format("{}: {}", folder.string(), problem.message()));
  FitRunner runner(fit, folder, options.threads);
  std::filesystem::remove(runner.best());
  const bool quiet = options.verbosity == Verbosity::quiet;
  if (!quiet) {
    fmt::print("{}: {} parameters from {} numbers\n", fit.title, fit.parameters.size(), fit.numbers());
    fmt::print("  run       chi^2    damping  values\n");
  }
  const auto observe = [&](const LeastSquaresStep& step) {
    if (step.accepted) runner.keep();
    if (!quiet) {
      fmt::print("  {:3} {:11.5g} {:10.3g}  {}{}\n", step.iteration, step.chi_squared, step.damping,
                 values_text(fit, step.at), step.accepted ? "" : "  refused");
      std::cout.flush();
    }
    return !runner.interrupted();
  };
  const auto interrupted = [&](const char* what) {
    fmt::print(stderr, "{}: interrupted; {}\n", options.fit_file.string(), what);
    return ExitStatus::interrupted;
  };
  LeastSquaresResult search;
  try {
    search = minimise(
        start_of(fit), search_options(fit), [&](const Vector& at) { return runner.evaluate(at); }, observe);
  } catch (const std::runtime_error&) {  // no answer at the start
    runner.clear();
    if (runner.interrupted()) return interrupted("the first run was not over");
    throw;
  }
  runner.clear();
  const auto end = search.end;
  const auto outcome = fit_outcome(fit, std::move(search));
  write_text(folder / "fit.json", fit_json(fit, outcome).dump(2) + "\n");
  if (!quiet) std::cout << fit_text(fit, outcome);
  using End = LeastSquaresResult::End;
  if (end == End::converged) return ExitStatus::done;
  if (end == End::stopped) return interrupted("fit.json has the best values so far");
  fmt::print(stderr, "{}: the search {}; fit.json has the best values so far\n", options.fit_file.string(),
             end == End::stalled ? "stalled" : "ran out of iterations: raise max_iterations, or start nearer");
  return ExitStatus::failed;
}

}  // namespace sundrape
