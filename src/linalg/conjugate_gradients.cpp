#include "sundrape/linalg/conjugate_gradients.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <utility>

#include "sundrape/linalg/block_incomplete_cholesky.hpp"

#include "lanes.hpp"
#include "side_by_side.hpp"

namespace sundrape {
namespace {

// Recursive residuals in single precision are trusted down to here.
constexpr double least_single_tolerance = 1e-5;
// and need no look at the true residual down to here.
constexpr double least_unchecked_tolerance = 1e-3;

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

/// Conjugate gradients for m right sides side by side, from x = 0. Those that have ended stay as they are.
template <std::size_t m>
class Together {
 public:
  /// @param r  right sides, 4mn; overwritten
  Together(const PaddedMatrix& matrix, const Preconditioner& preconditioner, PaddedVector& r)
      : matrix_(matrix),
        preconditioner_(preconditioner),
        r_(r),
        x_(PaddedVector::Zero(r.size())),
        p_(PaddedVector::Zero(r.size())),
        q_(r.size()),
        z_(r.size()) {
    runs_.fill(true);
  }

  [[nodiscard]] const PaddedVector& x() const { return x_; }
  [[nodiscard]] const std::array<Outcome, m>& ends() const { return ends_; }

  /// Down to |r| ≤ tolerance each.
  void iterate(double tolerance, int max_iterations) {
    Each rz{};
    for (int iteration = 0;; ++iteration) {
      const auto squares = dot(r_, r_);
      for (std::size_t v = 0; v < m; ++v) {
        const auto residual = std::sqrt(static_cast<double>(squares[v]));
        if (!std::isfinite(residual))
          end(v, End::not_finite, iteration);
        else if (residual <= tolerance)
          end(v, End::converged, iteration);
        else if (iteration == max_iterations)
          end(v, End::too_many_iterations, iteration);
      }
      if (std::ranges::none_of(runs_, std::identity())) return;
      preconditioner_.apply_together(r_, z_);
      const auto previous_rz = rz;
      rz = dot(r_, z_);
      Each factor{};
      for (std::size_t v = 0; v < m; ++v)
        if (runs_[v] && iteration > 0) factor[v] = rz[v] / previous_rz[v];
      add(z_, factor, p_, p_);
      matrix_.multiply_together(p_, q_);
      const auto curvature = dot(p_, q_);
      Each step{}, back{};
      for (std::size_t v = 0; v < m; ++v) {
        if (!std::isfinite(curvature[v]))
          end(v, End::not_finite, iteration);
        else if (curvature[v] <= 0)
          end(v, End::negative_curvature, iteration);
        if (!runs_[v]) continue;
        step[v] = rz[v] / curvature[v];
        back[v] = -step[v];
      }
      add(x_, step, p_, x_);
      add(r_, back, q_, r_);
    }
  }

 private:
  using Each = std::array<float, m>;

  void end(std::size_t v, End how, int iterations) {
    if (runs_[v]) ends_[v] = {how, iterations};
    runs_[v] = false;
  }
  static Each dot(const PaddedVector& a, const PaddedVector& b) {
    std::array<Lanes, m> sums;
    sums.fill(Lanes(0.0F));
    const float *from_a = a.data(), *from_b = b.data();
    for (const float* const last = from_a + a.size(); from_a != last; from_a += 4 * m, from_b += 4 * m)
      for (std::size_t v = 0; v < m; ++v) sums[v] = xsimd::fma(load(from_a + 4 * v), load(from_b + 4 * v), sums[v]);
    Each result;
    std::ranges::transform(sums, result.begin(), [](const Lanes& sum) { return xsimd::hadd(sum); });
    return result;
  }
  /// to = a + factor · b, vector by vector.
  static void add(const PaddedVector& a, const Each& factor, const PaddedVector& b, PaddedVector& to) {
    std::array<Lanes, m> factors;
    std::ranges::transform(factor, factors.begin(), [](float f) { return Lanes(f); });
    const float *from_a = a.data(), *from_b = b.data();
    float* target = to.data();
    for (const float* const last = from_a + a.size(); from_a != last; from_a += 4 * m, from_b += 4 * m, target += 4 * m)
      for (std::size_t v = 0; v < m; ++v)
        store(target + 4 * v, xsimd::fma(factors[v], load(from_b + 4 * v), load(from_a + 4 * v)));
  }

  const PaddedMatrix& matrix_;
  const Preconditioner& preconditioner_;
  PaddedVector& r_;
  PaddedVector x_, p_, q_, z_;
  std::array<bool, m> runs_;
  std::array<Outcome, m> ends_{};
};

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

SolveReport ConjugateGradients::solve_all(const Eigen::MatrixXd& b, Eigen::MatrixXd& x, double tolerance) {
  if (matrix_ == nullptr || tolerance < least_unchecked_tolerance || !b.allFinite())
    return LinearSolver::solve_all(b, x, tolerance);
  x.setZero(b.rows(), b.cols());
  SolveReport all;
  for (Eigen::Index first = 0; first < b.cols() && all.ok; first += PaddedMatrix::together) {
    const auto count = std::min<Eigen::Index>(PaddedMatrix::together, b.cols() - first);
    const auto right = b.middleCols(first, count);
    auto answers = x.middleCols(first, count);
    all = side_by_side(count, [&](auto m) { return solve_together<m>(right, answers, tolerance, all.iterations); });
  }
  return all;
}

template <std::size_t m>
SolveReport ConjugateGradients::solve_together(const Eigen::Ref<const Eigen::MatrixXd>& b,
                                               Eigen::Ref<Eigen::MatrixXd> x, double tolerance, int iterations) {
  constexpr auto row = static_cast<Eigen::Index>(4 * m);
  const Eigen::Index points = b.rows() / 3;
  const Eigen::RowVectorXd sizes = b.colwise().norm();
  PaddedVector r = PaddedVector::Zero(row * points);
  for (Eigen::Index v = 0; v < b.cols(); ++v)
    for (Eigen::Index i = 0; i < points && sizes[v] > 0; ++i)
      r.segment<3>(row * i + 4 * v) = (b.col(v).segment<3>(3 * i) / sizes[v]).cast<float>();
  Together<m> systems(*padded_, *preconditioner_, r);
  systems.iterate(0.9 * tolerance, max_iterations_);
  const PaddedVector& solution = systems.x();
  SolveReport all{.iterations = iterations};
  for (Eigen::Index v = 0; v < b.cols(); ++v) {
    for (Eigen::Index i = 0; i < points; ++i)
      x.col(v).segment<3>(3 * i) = sizes[v] / padded_->scale() * solution.segment<3>(row * i + 4 * v).cast<double>();
    auto one = report(systems.ends()[static_cast<std::size_t>(v)], all.iterations);
    if (!one.ok) return one;
    all = std::move(one);
  }
  return all;
}

}  // namespace sundrape
