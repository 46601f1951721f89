#include "sundrape/force/separation.hpp"

#include <algorithm>

namespace sundrape {
namespace {

void finish(Separation& s, const std::array<Vector3, 4>& x) {
  s.way = s.weights[0] * x[0] + s.weights[1] * x[1] + s.weights[2] * x[2] + s.weights[3] * x[3];
  s.distance = s.way.norm();
}

/// Point 0 and the edge between points i and j, as one of the four points' shapes.
Separation from_edge(const std::array<Vector3, 4>& x, std::size_t i, std::size_t j) {
  Separation s;
  s.weights[0] = 1;
  const Vector3 along = x[j] - x[i];
  const double length2 = along.squaredNorm();
  const double at = length2 > 0 ? (x[0] - x[i]).dot(along) / length2 : 0;
  if (at <= 0) {
    s.weights[i] = -1;
  } else if (at >= 1) {
    s.weights[j] = -1;
  } else {
    s.weights[i] = at - 1;
    s.weights[j] = -at;
    s.slides = 1;
    s.by_slide[0][i] = 1;
    s.by_slide[0][j] = -1;
  }
  finish(s, x);
  return s;
}

}  // namespace

Separation separation_of_points(const std::array<Vector3, 4>& x) {
  Separation s;
  s.weights = {1, -1, 0, 0};
  finish(s, x);
  return s;
}

Separation separation_from_edge(const std::array<Vector3, 4>& x) { return from_edge(x, 1, 2); }

// Inside or on which edge the foot of the point lies is read off the signs of its area coordinates.
Separation separation_from_triangle(const std::array<Vector3, 4>& x) {
  const Vector3 a = x[2] - x[1], b = x[3] - x[1], p = x[0] - x[1];
  const double aa = a.dot(a), ab = a.dot(b), bb = b.dot(b), pa = p.dot(a), pb = p.dot(b);
  const double determinant = aa * bb - ab * ab;
  const double u = bb * pa - ab * pb, v = aa * pb - ab * pa;  // times the determinant
  if (u >= 0 && v >= 0 && u + v <= determinant && determinant > 0) {
    Separation s;
    const double at_a = u / determinant, at_b = v / determinant;
    s.weights = {1, at_a + at_b - 1, -at_a, -at_b};
    s.slides = 2;
    s.by_slide = {std::array<double, 4>{0, 1, -1, 0}, std::array<double, 4>{0, 1, 0, -1}};
    finish(s, x);
    return s;
  }
  // on the nearest edge among those that the foot lies beyond
  Separation nearest;
  nearest.distance = -1;
  const auto consider = [&](std::size_t i, std::size_t j) {
    const auto s = from_edge(x, i, j);
    if (nearest.distance < 0 || s.distance < nearest.distance) nearest = s;
  };
  if (v < 0 || determinant <= 0) consider(1, 2);
  if (u < 0 || determinant <= 0) consider(1, 3);
  if (u + v > determinant || determinant <= 0) consider(2, 3);
  return nearest;
}

// Ericson, Real-Time Collision Detection (2005), 5.1.9: clamp one end, project, clamp the other.
Separation separation_of_edges(const std::array<Vector3, 4>& x) {
  const Vector3 a = x[1] - x[0], b = x[3] - x[2], r = x[0] - x[2];
  const double aa = a.squaredNorm(), bb = b.squaredNorm(), ab = a.dot(b), ar = a.dot(r), br = b.dot(r);
  const double determinant = aa * bb - ab * ab;
  double s = determinant > 0 ? std::clamp((ab * br - ar * bb) / determinant, 0.0, 1.0) : 0.0;
  double t = bb > 0 ? (ab * s + br) / bb : 0.0;
  if (t < 0 || t > 1) {
    t = std::clamp(t, 0.0, 1.0);
    s = aa > 0 ? std::clamp((ab * t - ar) / aa, 0.0, 1.0) : 0.0;
  }
  Separation separation;
  separation.weights = {1 - s, s, t - 1, -t};
  if (s > 0 && s < 1) separation.by_slide[static_cast<std::size_t>(separation.slides++)] = {-1, 1, 0, 0};
  if (t > 0 && t < 1) separation.by_slide[static_cast<std::size_t>(separation.slides++)] = {0, 0, 1, -1};
  finish(separation, x);
  return separation;
}

Separation separation(Shapes shapes, const std::array<Vector3, 4>& x) {
  switch (shapes) {
    case Shapes::point_point:
      return separation_of_points(x);
    case Shapes::point_edge:
      return separation_from_edge(x);
    case Shapes::point_triangle:
      return separation_from_triangle(x);
    case Shapes::edge_edge:
      break;
  }
  return separation_of_edges(x);
}

SeparationHessian::SeparationHessian(const Separation& s, const std::array<Vector3, 4>& x)
    : slides_(s.slides), weights_(s.weights) {
  std::array<Vector3, 2> j{Vector3::Zero(), Vector3::Zero()};
  for (std::size_t a = 0; a < static_cast<std::size_t>(slides_); ++a)
    for (std::size_t k = 0; k < 4; ++k)
      if (s.by_slide[a][k] != 0) j[a] += s.by_slide[a][k] * x[k];
  for (std::size_t a = 0; a < static_cast<std::size_t>(slides_); ++a)
    for (std::size_t k = 0; k < 4; ++k) slope_[a][k] = s.by_slide[a][k] * s.way + weights_[k] * j[a];
  if (slides_ == 1) inverse_[0][0] = 1 / j[0].squaredNorm();
  if (slides_ == 2) {
    const double aa = j[0].squaredNorm(), bb = j[1].squaredNorm(), ab = j[0].dot(j[1]);
    const double determinant = aa * bb - ab * ab;
    if (determinant > 1e-12 * aa * bb) {
      inverse_ = {std::array<double, 2>{bb / determinant, -ab / determinant},
                  std::array<double, 2>{-ab / determinant, aa / determinant}};
    } else {  // parallel edges: they slide as one
      slides_ = 1;
      inverse_[0][0] = 1 / aa;
    }
  }
}

Matrix3 SeparationHessian::block(std::size_t k, std::size_t l) const {
  Matrix3 h = weights_[k] * weights_[l] * Matrix3::Identity();
  for (std::size_t a = 0; a < static_cast<std::size_t>(slides_); ++a)
    for (std::size_t b = 0; b < static_cast<std::size_t>(slides_); ++b)
      h -= inverse_[a][b] * slope_[a][k] * slope_[b][l].transpose();
  return h;
}

Vector3 SeparationHessian::slide_gradient(std::size_t a, std::size_t l) const {
  Vector3 gradient = Vector3::Zero();
  if (a < static_cast<std::size_t>(slides_))
    for (std::size_t b = 0; b < static_cast<std::size_t>(slides_); ++b) gradient -= inverse_[a][b] * slope_[b][l];
  return gradient;
}

}  // namespace sundrape
