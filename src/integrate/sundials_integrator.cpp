#include "sundials_integrator.hpp"

#include <stdexcept>
#include <string>

namespace sundrape {
namespace {

// A correction larger than this part of the one before calls for a new matrix.
constexpr double slow = 0.1;

}  // namespace

SundialsIntegrator::SundialsIntegrator(const System& system, const IntegratorOptions& options, EventSource* events)
    : form_(system), guard_(system), options_(options), events_(events), y_(form_.size(), context_) {}

void SundialsIntegrator::require_mass(const char* method) const {
  if (form_.system().has_massless_rows())
    throw std::invalid_argument(std::string(method) + " needs a mass at every point: use IDA");
}

void SundialsIntegrator::load(double time, ConstVectorRef q, ConstVectorRef v) {
  auto y = y_.values();
  y.head(q.size()) = q;
  y.tail(v.size()) = v;
  time_ = time;
  guard_.start_from(time, q);
}

void SundialsIntegrator::state(VectorRef q, VectorRef v) const {
  q = y_.values().head(q.size());
  v = y_.values().tail(v.size());
}

void SundialsIntegrator::interpolate(double time, VectorRef q, VectorRef v) const {
  const sundials::StateVector at(form_.size(), context_);
  interpolant(time, at.get());
  q = at.values().head(q.size());
  v = at.values().tail(v.size());
}

std::vector<int> SundialsIntegrator::fired() const {
  std::vector<int> roots(static_cast<std::size_t>(event_count()));
  if (!roots.empty()) root_info(roots.data());
  return roots;
}

int SundialsIntegrator::evaluate_events(double time, N_Vector y, double* values) {
  return carrier_.run([&] {
    form_.events(time, sundials::values(y), *events_, {values, static_cast<std::size_t>(event_count())});
    return 0;
  });
}

void SundialsIntegrator::bank() {
  const auto s = current();
  banked_.steps += s.steps;
  banked_.newton_iterations += s.newton_iterations;
  banked_.error_test_failures += s.error_test_failures;
  banked_.step_solve_failures += s.step_solve_failures;
  ++banked_.restarts;
}

IntegratorStatistics SundialsIntegrator::statistics() const {
  auto s = current();
  s.steps += banked_.steps;
  s.newton_iterations += banked_.newton_iterations;
  s.error_test_failures += banked_.error_test_failures;
  s.step_solve_failures += banked_.step_solve_failures;
  s.restarts = banked_.restarts;
  s.force_evaluations = form_.evaluations();
  return s;
}

ImplicitIntegrator::ImplicitIntegrator(const System& system, std::unique_ptr<LinearSolver> solver,
                                       const IntegratorOptions& options, EventSource* events)
    : SundialsIntegrator(system, options, events),
      newton_(system, std::move(solver), options.linear_tolerance),
      weights_{options.rtol, options.atol_position, options.atol_velocity, Vector(), options.rate_slack} {}

int ImplicitIntegrator::evaluate_weights(N_Vector y, N_Vector weights) {
  return carrier_.run([&] {
    weights_.evaluate(sundials::values(y), sundials::values(weights));
    return 0;
  });
}

sundials::Verdict ImplicitIntegrator::judge(double time, N_Vector predicted, N_Vector total, N_Vector last) {
  using sundials::Verdict;
  if (!guard_.watches()) return Verdict::accept;
  const auto n = form_.size() / 2;
  auto verdict = Verdict::refuse;
  carrier_.run([&] {
    end_ = sundials::values(predicted).head(n) + sundials::values(total).head(n);
    before_ = end_ - sundials::values(last).head(n);
    if (!guard_.settles(time, before_, end_))
      verdict = Verdict::go_on;
    else if (guard_.admits(time, end_))
      verdict = Verdict::accept;
    return 0;
  });
  return verdict;
}

int ImplicitIntegrator::correct(double time, double c, N_Vector y, ConstVectorRef force, ConstVectorRef r_q,
                                ConstVectorRef r_v, N_Vector x) {
  const auto n = form_.size() / 2;
  auto dq = sundials::values(x).head(n), dv = sundials::values(x).tail(n);
  if (newton_.is_prepared_for(time, c)) {
    const double largest = slow * last_correction_;
    const bool solved = newton_.solve(r_q, r_v, dq, dv, largest).ok;
    last_correction_ = dq.norm();
    if (solved && last_correction_ <= largest) return 0;
  }
  const auto at = sundials::values(y);
  if (newton_.prepare(time, c, at.head(n), at.tail(n)) != FactorStatus::ok) return SUNLS_PACKAGE_FAIL_REC;
  newton_.know_forces(force);
  if (!newton_.solve(r_q, r_v, dq, dv).ok) {
    newton_.forget();
    return SUNLS_PACKAGE_FAIL_REC;
  }
  last_correction_ = dq.norm();
  return 0;
}

IntegratorStatistics ImplicitIntegrator::with_linear(IntegratorStatistics s) const {
  s.linear = newton_.counters();
  return s;
}

}  // namespace sundrape
