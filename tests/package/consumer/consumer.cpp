// Another project's program: no flags of sundrape's own, vectors passing both ways, and the libraries behind it linked.
#include <array>
#include <cmath>
#include <cstdlib>
#include <iostream>

#include "sundrape/force/stretch_springs.hpp"
#include "sundrape/linalg/linear_solver.hpp"

namespace {

// A thread of E h w = 6.4 N, 1 cm long, stretched by 1 % along z: it pulls with 0.064 N.
double pull_of_a_thread() {
  const sundrape::StretchSprings thread({{.i = 0, .j = 1, .length = 0.01, .stiffness = 640.0}},
                                        sundrape::EnergyKind::membrane);
  Eigen::VectorXd q(6);
  q << 0, 0, 0, 0, 0, -0.0101;
  const Eigen::VectorXd v = Eigen::VectorXd::Zero(6);
  Eigen::VectorXd force = Eigen::VectorXd::Zero(6);
  thread.add_force({.time = 0, .q = q, .v = v}, force);
  return force[5];
}

// 2 x = 1 in three unknowns.
double half(sundrape::SolverKind kind) {
  sundrape::Pattern pattern({0});
  pattern.begin_term(1);
  pattern.add_element(std::array{0});
  const sundrape::BlockStructure structure = pattern.build().structure;
  const auto solver = sundrape::make_linear_solver(kind);
  sundrape::BlockMatrix matrix(structure, solver->symmetry());
  matrix.set_zero();
  matrix.add_diagonal(Eigen::VectorXd::Constant(1, 2.0), 1.0);
  solver->analyse(structure);
  if (solver->factor(matrix) != sundrape::FactorStatus::ok) return NAN;
  Eigen::VectorXd x(3);
  return solver->solve(Eigen::VectorXd::Ones(3), x, 1e-12).ok ? x[1] : NAN;
}

bool agree(const char* what, double got, double expected) {
  const bool ok = std::abs(got - expected) < 1e-12;
  if (!ok) std::cerr << what << ": " << got << ", expected " << expected << '\n';
  return ok;
}

}  // namespace

int main() {
  bool ok = agree("pull", pull_of_a_thread(), 0.064);
  ok = agree("Cholesky", half(sundrape::SolverKind::cholesky), 0.5) && ok;
  ok = agree("LU", half(sundrape::SolverKind::lu), 0.5) && ok;
  return ok ? EXIT_SUCCESS : EXIT_FAILURE;
}
