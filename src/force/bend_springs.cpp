#include "sundrape/force/bend_springs.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "sundrape/force/hinge_angle.hpp"

namespace sundrape {
namespace {

/// Stiffness of one spring with respect to its edges a, b and axis c; rows and columns in that order.
struct EdgeTangent {
  std::array<std::array<Matrix3, 3>, 3> block;
};

/// modulus · g gᵀ + geometric · ∂²φ + rate_change · g (∂²φ · rates)ᵀ; the last part is not symmetric.
EdgeTangent edge_tangent(const HingeAngle& hinge, const HingeCurvature& curved, double modulus, double geometric, double rate_change,
                         const std::array<Vector3, 3>& rates) {
  const std::array<Vector3, 3> g{hinge.ga, hinge.gb, hinge.gc};
  EdgeTangent t;
  for (std::size_t r = 0; r < 3; ++r)
    for (std::size_t s = 0; s < 3; ++s) t.block[r][s].noalias() = (modulus * g[r]) * g[s].transpose();
  t.block[0][0] += geometric * curved.aa;
  t.block[1][1] += geometric * curved.bb;
  t.block[2][2] += geometric * curved.cc;
  t.block[0][2] += geometric * curved.ac;
  t.block[2][0] += geometric * curved.ac.transpose();
  t.block[1][2] += geometric * curved.bc;
  t.block[2][1] += geometric * curved.bc.transpose();
  if (rate_change != 0) {
    const auto& [a, b, c] = rates;
    const std::array<Vector3, 3> h{curved.aa * a + curved.ac * c, curved.bb * b + curved.bc * c,
                                   curved.ac.transpose() * a + curved.bc.transpose() * b + curved.cc * c};
    for (std::size_t r = 0; r < 3; ++r)
      for (std::size_t s = 0; s < 3; ++s) t.block[r][s].noalias() += (rate_change * g[r]) * h[s].transpose();
  }
  return t;
}

}  // namespace

struct BendSprings::Edges {
  Vector3 a, b, c;
};

BendSprings::BendSprings(std::vector<BendSpring> springs, double relaxation_time) : relaxation_time_(relaxation_time) {
  if (!(relaxation_time >= 0)) throw std::invalid_argument("the relaxation time of bending must not be negative [s]");
  elements_.reserve(springs.size());
  for (const auto& s : springs) {
    if (!(s.stiffness > 0)) throw std::invalid_argument("a bend spring has no stiffness");
    const bool from_centre = s.cross_from == s.centre, to_centre = s.cross_to == s.centre;
    elements_.push_back({.points = {s.previous, s.centre, s.next, to_centre ? -1 : s.cross_to, from_centre ? -1 : s.cross_from},
                         .skew = s.skew,
                         .centre_in_cross = (to_centre ? 1.0 : 0.0) - (from_centre ? 1.0 : 0.0),
                         .rest_angle = s.rest_angle,
                         .stiffness = s.stiffness});
    auto points = elements_.back().points;
    std::ranges::sort(points);
    for (std::size_t k = 1; k < points.size(); ++k)
      if (points[k] >= 0 && points[k] == points[k - 1]) throw std::invalid_argument("a bend spring names a node twice");
  }
  const auto reach = [](const Element& e) {
    std::pair<int, int> r(e.points[0], e.points[0]);
    for (const int p : e.points)
      if (p >= 0) r = {std::min(r.first, p), std::max(r.second, p)};
    return r;
  };
  std::ranges::sort(elements_, {}, reach);
  std::vector<std::pair<int, int>> reaches;
  for (const auto& e : elements_) reaches.push_back(reach(e));
  stripes_ = Stripes(reaches);
}

BendSprings::Edges BendSprings::edges(const Element& element, ConstVectorRef x) {
  const auto& [previous, centre, next, to, from] = element.points;
  Edges e;
  e.a = point(x, centre) - point(x, previous);
  e.b = point(x, next) - point(x, centre);
  e.c = (to >= 0 ? point(x, to) : point(x, centre)) - (from >= 0 ? point(x, from) : point(x, centre));
  if (element.skew != 0) e.c -= element.skew * (e.a + e.b);
  return e;
}

double BendSprings::energy(const State& state) const {
  return stripes_.sum([&](std::size_t begin, std::size_t end) {
    double sum = 0;
    for (auto e = begin; e < end; ++e) {
      const auto x = edges(elements_[e], state.q);
      const double turn = HingeAngle(x.a, x.b, x.c).angle - elements_[e].rest_angle;
      sum += 0.5 * elements_[e].stiffness * turn * turn;
    }
    return sum;
  });
}

double BendSprings::dissipated_power(const State& state) const {
  if (relaxation_time_ == 0) return 0;
  return stripes_.sum([&](std::size_t begin, std::size_t end) {
    double sum = 0;
    for (auto e = begin; e < end; ++e) {
      const auto x = edges(elements_[e], state.q), v = edges(elements_[e], state.v);
      const HingeAngle hinge(x.a, x.b, x.c);
      const double rate = hinge.ga.dot(v.a) + hinge.gb.dot(v.b) + hinge.gc.dot(v.c);
      sum += relaxation_time_ * elements_[e].stiffness * rate * rate;
    }
    return sum;
  });
}

void BendSprings::add_force(const State& state, VectorRef f) const {
  stripes_.for_each([&](std::size_t begin, std::size_t end) {
    for (auto e = begin; e < end; ++e) {
      const auto& element = elements_[e];
      const auto x = edges(element, state.q);
      const HingeAngle hinge(x.a, x.b, x.c);
      double moment = element.stiffness * (hinge.angle - element.rest_angle);
      if (relaxation_time_ > 0) {
        const auto v = edges(element, state.v);
        moment += relaxation_time_ * element.stiffness * (hinge.ga.dot(v.a) + hinge.gb.dot(v.b) + hinge.gc.dot(v.c));
      }
      const Vector3 fa = -moment * (hinge.ga - element.skew * hinge.gc), fb = -moment * (hinge.gb - element.skew * hinge.gc);
      const Vector3 fc = -moment * hinge.gc;
      const auto& [previous, centre, next, to, from] = element.points;
      point(f, previous) -= fa;
      point(f, centre) += fa - fb + element.centre_in_cross * fc;
      point(f, next) += fb;
      if (to >= 0) point(f, to) += fc;
      if (from >= 0) point(f, from) -= fc;
    }
  });
}

void BendSprings::add_tangent(const State& state, double dq, double dv, Assembler& tangent) const {
  const bool exact = tangent.keeps_unsymmetric() && relaxation_time_ > 0;
  stripes_.for_each([&](std::size_t begin, std::size_t end) {
    for (auto e = begin; e < end; ++e) {
      const auto& element = elements_[e];
      const auto x = edges(element, state.q);
      const HingeAngle hinge(x.a, x.b, x.c);
      const HingeCurvature curved(x.a, x.b, x.c);
      const double viscosity = relaxation_time_ * element.stiffness;
      double moment = element.stiffness * (hinge.angle - element.rest_angle);
      std::array<Vector3, 3> rates;
      if (viscosity > 0) {
        const auto v = edges(element, state.v);
        rates = {v.a, v.b, v.c};
        moment += viscosity * (hinge.ga.dot(v.a) + hinge.gb.dot(v.b) + hinge.gc.dot(v.c));
      }
      const auto t = edge_tangent(hinge, curved, dq * element.stiffness + dv * viscosity, dq * moment, exact ? dq * viscosity : 0.0, rates);

      // a, b, c in terms of the five points: a column of weights each
      const double k = element.skew, m = element.centre_in_cross;
      const std::array<std::array<double, 3>, 5> weight{{{-1, 0, k}, {1, -1, m}, {0, 1, -k}, {0, 0, 1}, {0, 0, -1}}};
      std::array<std::array<Matrix3, 5>, 3> half;   // ∂²/∂(edge)∂(point)
      for (std::size_t r = 0; r < 3; ++r) {
        const auto& [ra, rb, rc] = t.block[r];
        half[r][0] = k == 0 ? Matrix3(-ra) : Matrix3(k * rc - ra);
        half[r][1] = m == 0 ? Matrix3(ra - rb) : Matrix3(ra - rb + m * rc);
        half[r][2] = k == 0 ? rb : Matrix3(rb - k * rc);
        half[r][3] = rc;
        half[r][4] = -rc;
      }
      const auto block = [&](std::size_t p, std::size_t q) -> Matrix3 {
        Matrix3 sum = Matrix3::Zero();
        for (std::size_t r = 0; r < 3; ++r)
          if (weight[p][r] != 0) sum.noalias() -= weight[p][r] * half[r][q];
        return sum;
      };
      for (std::size_t q = 0; q < 5; ++q) {
        if (element.points[q] < 0) continue;
        tangent.add_diagonal(e, static_cast<int>(q), block(q, q));
        for (std::size_t p = 0; p < q; ++p) {
          if (element.points[p] < 0) continue;
          if (exact)
            tangent.add_general_pair(e, static_cast<int>(p), static_cast<int>(q), block(p, q), block(q, p));
          else
            tangent.add_pair(e, static_cast<int>(p), static_cast<int>(q), block(p, q));
        }
      }
    }
  });
}

void BendSprings::declare_pattern(Pattern& pattern) const {
  pattern.begin_term(5);
  for (const auto& e : elements_) pattern.add_element(e.points);
}

double BendSprings::largest_angle(ConstVectorRef q) const {
  double largest = 0;
  for (const auto& e : elements_) {
    const auto x = edges(e, q);
    largest = std::max(largest, std::abs(HingeAngle(x.a, x.b, x.c).angle));
  }
  return largest;
}

}  // namespace sundrape
