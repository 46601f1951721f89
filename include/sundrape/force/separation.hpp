#pragma once
#include <array>

#include "sundrape/types.hpp"

namespace sundrape {

/// Two simple shapes that are apart: points, edges, triangles, with four points between them or less.
enum class Shapes { point_point, point_edge, point_triangle, edge_edge };

/// How many points two shapes have.
[[nodiscard]] constexpr std::size_t points_of(Shapes shapes) {
  return shapes == Shapes::point_point ? 2 : shapes == Shapes::point_edge ? 3 : 4;
}

/// The shortest way between two shapes, and what its derivatives are made of.
///
/// It joins the second shape to the first as r = Σ w_k x_k, so ∂|r|/∂x_k = w_k r/|r|. Where its ends can slide on edges
/// or in a triangle, weights change with the points: slide s by ∂w/∂s, and r by j_s = Σ (∂w_k/∂s) x_k.
struct Separation {
  std::array<double, 4> weights{};
  Vector3 way = Vector3::Zero();                    // r [m]
  double distance = 0;                              // |r| [m]
  int slides = 0;                                   // ways in which the ends slide: 0, 1 or 2
  std::array<std::array<double, 4>, 2> by_slide{};  // ∂w/∂s
};

/// Points 0 and 1. Points that a shape does not have are anywhere, but finite.
[[nodiscard]] Separation separation_of_points(const std::array<Vector3, 4>& x);
/// Point 0 and the edge from point 1 to point 2.
[[nodiscard]] Separation separation_from_edge(const std::array<Vector3, 4>& x);
/// Point 0 and the triangle of points 1, 2 and 3.
[[nodiscard]] Separation separation_from_triangle(const std::array<Vector3, 4>& x);
/// The edges from point 0 to point 1, and from point 2 to point 3.
[[nodiscard]] Separation separation_of_edges(const std::array<Vector3, 4>& x);
[[nodiscard]] Separation separation(Shapes shapes, const std::array<Vector3, 4>& x);

/// Second derivatives of half the squared distance: block (k, l) is ∂²(½|r|²)/∂x_k∂x_l,
///     H_kl = w_k w_l 1 − Σ_ab G_ab (w_k,a r + w_k j_a)(w_l,b r + w_l j_b)ᵀ,   G⁻¹_ab = j_a · j_b.
class SeparationHessian {
 public:
  SeparationHessian(const Separation& s, const std::array<Vector3, 4>& x);
  [[nodiscard]] Matrix3 block(std::size_t k, std::size_t l) const;
  /// ∂s_a/∂x_l: how far end a slides as point l moves.
  [[nodiscard]] Vector3 slide_gradient(std::size_t a, std::size_t l) const;

 private:
  int slides_;
  std::array<double, 4> weights_;
  std::array<std::array<Vector3, 4>, 2> slope_;  // of r·j_a by x_k
  std::array<std::array<double, 2>, 2> inverse_{};
};

}  // namespace sundrape
