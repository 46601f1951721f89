#include "sundrape/integrate/bdf_history.hpp"

#include <gtest/gtest.h>

#include "sundrape/integrate/integrator.hpp"

#include "support/small_systems.hpp"

namespace sundrape {
namespace {

using namespace samples;

/// Largest relative difference, over a motion, between v and what the step's equation says of q: q̇_n = c q_n − g.
double worst_rate(BdfForm form, int max_order) {
  const auto system = mass_on_spring(9.81, 1e-2);
  // Newton's iteration leaves next to nothing, so that the discrete equations hold to rounding
  const IntegratorOptions options{.rtol = 1e-6,
                                  .atol_position = 1e-8,
                                  .atol_velocity = 1e-6,
                                  .max_order = max_order,
                                  .newton_accuracy = 1e-6,
                                  .linear_tolerance = 1e-12};
  auto solver = make_linear_solver(SolverKind::cholesky);
  const auto integrator = form == BdfForm::ida ? make_ida(system, std::move(solver), options)
                                               : make_cvode(system, std::move(solver), options);
  Vector q = below(0.03).tail(3), v = Vector::Zero(3);
  integrator->start(0, q, v);
  BdfHistory history(form, max_order);
  history.restart(0);
  BdfHistory::Past past{{q}, Vector::Zero(3)};
  double worst = 0, fastest = 0;
  int highest = 0;
  for (double time = 0; time < 2;) {
    const auto report = integrator->step(2);
    time = report.time;
    highest = std::max(highest, report.order);
    integrator->state(q, v);
    history.begin_step(time, report.step_size, report.order);
    const Vector g = history.g(past);
    worst = std::max(worst, (history.c() * q - g - v).norm());
    fastest = std::max(fastest, v.norm());
    history.accept(q, g, past);
    history.end_step();
    Vector middle_q(3), middle_v(3);
    const double middle = time - 0.4 * report.step_size;
    integrator->interpolate(middle, middle_q, middle_v);
    EXPECT_LT((history.at(middle, past) - middle_q).norm(), 1e-9);
  }
  EXPECT_EQ(highest, max_order);
  return worst / fastest;
}

TEST(BdfHistory, SaysTheRatesThatTheIntegratorsFind) {
  for (const auto form : {BdfForm::cvode, BdfForm::ida})
    for (const int order : {1, 2, 4})
      EXPECT_LT(worst_rate(form, order), 1e-7) << static_cast<int>(form) << ' ' << order;
}

}  // namespace
}  // namespace sundrape
