#include "sundrape/linalg/conjugate_gradients.hpp"

#include <cmath>
#include <utility>

#include "sundrape/linalg/block_incomplete_cholesky.hpp"

namespace sundrape {
namespace {

// Recursive residuals in single precision are trusted down to here.
constexpr double least_single_tolerance = 1e-5;

enum class End { converged, too_large, too_many_iterations, negative_curvature, not_finite };

struct Outcome {
  End end;
  int iterations;
};

/// Solves A x = b from the x given, with r = b − A x on entry, down to |r| ≤ tolerance. From x = 0 the iterates only
/// grow (in the preconditioner's norm: Steihaug 1983), so once |x| exceeds `largest` the solution does. multiply(p, q):
/// q = A p; precondition(r, z): z ≈ A⁻¹ r.
template <class V, class Multiply, class Precondition>
Outcome iterate(V& x, V& r, double tolerance, double largest, int max_iterations, const Multiply& multiply,
                const Precondition& precondition) {
  using Scalar = typename V::Scalar;
  V p(r.size());
  V q(r.size());
  V z(r.size());
  Scalar rz = 0;
  for (int iteration = 0;; ++iteration) {
    const auto residual = static_cast<double>(r.norm());
    if (!std::isfinite(residual)) return {End::not_finite, iteration};
    if (residual <= tolerance) return {End::converged, iteration};
    if (iteration == max_iterations) return {End::too_many_iterations, iteration};
    precondition(r, z);
    const Scalar previous_rz = rz;
    rz = r.dot(z);
    if (iteration == 0)
      p = z;
    else
      p = z + rz / previous_rz * p;
    multiply(p, q);
    const Scalar curvature = p.dot(q);
    if (!std::isfinite(curvature)) return {End::not_finite, iteration};
    if (curvature <= 0) return {End::negative_curvature, iteration};
    const Scalar step = rz / curvature;
    x += step * p;
    r -= step * q;
    if (static_cast<double>(x.norm()) > largest) return {End::too_large, iteration + 1};
  }
}

SolveReport report(const Outcome& outcome, int iterations_before) {
  SolveReport report{.ok = outcome.end == End::converged,
                     .iterations = iterations_before + outcome.iterations,
                     .indefinite = outcome.end == End::negative_curvature};
  switch (outcome.end) {
    case End::converged:
      break;
    case End::too_large:
      report.problem = "the solution is larger than what is of use";
      break;
    case End::too_many_iterations:
      report.problem =
          "conjugate gradients did not converge within " + std::to_string(report.iterations) + " iterations";
      break;
    case End::negative_curvature:
      report.problem = "conjugate gradients met negative curvature: the matrix is not positive definite";
      break;
    case End::not_finite:
      report.problem = "conjugate gradients met numbers that are not finite";
      break;
  }
  return report;
}

}  // namespace

ConjugateGradients::ConjugateGradients(std::unique_ptr<Preconditioner> preconditioner, int max_iterations)
    : preconditioner_(preconditioner ? std::move(preconditioner) : std::make_unique<BlockIncompleteCholesky>()),
      max_iterations_(max_iterations) {}

void ConjugateGradients::analyse(const BlockStructure& structure) {
  matrix_ = nullptr;
  padded_.emplace(structure);
  preconditioner_->analyse(structure);
}

FactorStatus ConjugateGradients::factor(const BlockMatrix& matrix) {
  matrix_ = nullptr;
  if (!padded_) analyse(matrix.structure());
  padded_->copy(matrix);
  if (!preconditioner_->build(*padded_)) return FactorStatus::not_positive_definite;
  matrix_ = &matrix;
  return FactorStatus::ok;
}

SolveReport ConjugateGradients::solve(ConstVectorRef b, VectorRef x, double tolerance, double largest) {
  x.setZero();
  if (matrix_ == nullptr) return {.ok = false, .problem = "conjugate gradients: the last matrix has no preconditioner"};
  const double size = b.norm();
  if (size == 0) return {};
  if (!std::isfinite(size)) return {.ok = false, .problem = "conjugate gradients: the right side is not finite"};

  // Right side and matrix are scaled to 1, out of the way of single precision's limits.
  const double unscale = size / padded_->scale();
  const Eigen::Index padded_size = 4 * Eigen::Index{padded_->size()};
  Vector r = b / size;
  Vector solution = Vector::Zero(b.size());
  Vector product(b.size());
  PaddedVector padded_r(padded_size);
  PaddedVector padded_x = PaddedVector::Zero(padded_size);
  int iterations = 0;

  if (tolerance >= least_single_tolerance) {
    pad(r, 1, padded_r);
    const auto single = iterate(
        padded_x, padded_r, 0.9 * tolerance, largest / unscale, max_iterations_,
        [&](const auto& p, auto& q) { padded_->multiply(p, q); },
        [&](const auto& from, auto& to) { preconditioner_->apply(from, to); });
    iterations = single.iterations;
    if (single.end != End::not_finite) unpad(padded_x, 1, solution);
    if (single.end == End::too_large) {
      x = unscale * solution;
      return report(single, 0);
    }
    matrix_->multiply(solution, product);
    r -= product / padded_->scale();
  }
  const auto rest = iterate(
      solution, r, tolerance, largest / unscale, max_iterations_ - iterations,
      [&](const auto& p, auto& q) {
        matrix_->multiply(p, q);
        q /= padded_->scale();
      },
      [&](const auto& from, auto& to) {
        const double length = from.norm();
        pad(from, 1 / length, padded_r);
        preconditioner_->apply(padded_r, padded_x);
        unpad(padded_x, length, to);
      });
  x = unscale * solution;
  return report(rest, iterations);
}

}  // namespace sundrape
