#include "sundrape/force/bend_springs.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "sundrape/force/hinge_angle.hpp"

namespace sundrape {
namespace {

/// Second derivatives of one spring's energy by its edges a, b and axis c (and of its damping's power, where kept).
struct EdgeTangent {
  Matrix3 aa, ab, ac, bb, bc, cc;  // rows by the first letter
  Matrix3 ba, ca, cb;              // transposes of the above unless the damping's own change is kept
};

/// modulus · g gᵀ + geometric · ∂²φ
EdgeTangent edge_tangent(const HingeAngle& hinge, const HingeCurvature& curved, double modulus, double geometric) {
  const Vector3 ga = modulus * hinge.ga, gb = modulus * hinge.gb, gc = modulus * hinge.gc;
  EdgeTangent t;
  t.aa = ga * hinge.ga.transpose() + geometric * curved.aa;
  t.bb = gb * hinge.gb.transpose() + geometric * curved.bb;
  t.cc = gc * hinge.gc.transpose() + geometric * curved.cc;
  t.ab = ga * hinge.gb.transpose();
  t.ac = ga * hinge.gc.transpose() + geometric * curved.ac;
  t.bc = gb * hinge.gc.transpose() + geometric * curved.bc;
  return t;
}

/// Adds factor · g (∂²φ · rates)ᵀ, by which the damping moment changes as the spring turns: not symmetric.
void add_rate_change(EdgeTangent& t, const HingeAngle& hinge, const HingeCurvature& curved, double factor,
                     const Vector3& a, const Vector3& b, const Vector3& c) {
  t.ba = t.ab.transpose();
  t.ca = t.ac.transpose();
  t.cb = t.bc.transpose();
  const Vector3 ha = factor * (curved.aa * a + curved.ac * c), hb = factor * (curved.bb * b + curved.bc * c);
  const Vector3 hc = factor * (curved.ac.transpose() * a + curved.bc.transpose() * b + curved.cc * c);
  t.aa += hinge.ga * ha.transpose();
  t.ab += hinge.ga * hb.transpose();
  t.ac += hinge.ga * hc.transpose();
  t.ba += hinge.gb * ha.transpose();
  t.bb += hinge.gb * hb.transpose();
  t.bc += hinge.gb * hc.transpose();
  t.ca += hinge.gc * ha.transpose();
  t.cb += hinge.gc * hb.transpose();
  t.cc += hinge.gc * hc.transpose();
}

/// −∂²/∂x_p∂x_q for the five points of a spring inside a sheet of straight crossing threads, where
/// a = x₁ − x₀, b = x₂ − x₁, c = x₃ − x₄.
void add_plain(const EdgeTangent& t, std::size_t e, Assembler& tangent) {
  const Matrix3 a_minus_b_by_a = t.aa - t.ab.transpose(), a_minus_b_by_b = t.ab - t.bb, a_minus_b_by_c = t.ac - t.bc;
  tangent.add_diagonal(e, 0, -t.aa);
  tangent.add_diagonal(e, 1, a_minus_b_by_b - a_minus_b_by_a);
  tangent.add_diagonal(e, 2, -t.bb);
  tangent.add_diagonal(e, 3, -t.cc);
  tangent.add_diagonal(e, 4, -t.cc);
  tangent.add_pair(e, 0, 1, a_minus_b_by_a.transpose());
  tangent.add_pair(e, 0, 2, t.ab);
  tangent.add_pair(e, 0, 3, t.ac);
  tangent.add_pair(e, 0, 4, -t.ac);
  tangent.add_pair(e, 1, 2, -a_minus_b_by_b);
  tangent.add_pair(e, 1, 3, -a_minus_b_by_c);
  tangent.add_pair(e, 1, 4, a_minus_b_by_c);
  tangent.add_pair(e, 2, 3, -t.bc);
  tangent.add_pair(e, 2, 4, t.bc);
  tangent.add_pair(e, 3, 4, t.cc);
}

/// The same for any spring: weights[p] are those of a, b, c in point p.
void add_general(const EdgeTangent& t, const std::array<int, 5>& points, const std::array<Vector3, 5>& weights,
                 std::size_t e, Assembler& tangent) {
  const bool exact = tangent.keeps_unsymmetric();
  const auto block = [&](std::size_t p, std::size_t q) -> Matrix3 {
    const Vector3 &l = weights[p], &r = weights[q];
    const Matrix3 symmetric = l[0] * r[0] * t.aa + l[1] * r[1] * t.bb + l[2] * r[2] * t.cc + l[0] * r[1] * t.ab +
                              l[0] * r[2] * t.ac + l[1] * r[2] * t.bc;
    return -(symmetric + l[1] * r[0] * t.ba + l[2] * r[0] * t.ca + l[2] * r[1] * t.cb);
  };
  for (std::size_t q = 0; q < 5; ++q) {
    if (points[q] < 0) continue;
    tangent.add_diagonal(e, static_cast<int>(q), block(q, q));
    for (std::size_t p = 0; p < q; ++p) {
      if (points[p] < 0) continue;
      if (exact)
        tangent.add_general_pair(e, static_cast<int>(p), static_cast<int>(q), block(p, q), block(q, p));
      else
        tangent.add_pair(e, static_cast<int>(p), static_cast<int>(q), block(p, q));
    }
  }
}

}  // namespace

struct BendSprings::Edges {
  Vector3 a, b, c;
};

BendSprings::BendSprings(const std::vector<BendSpring>& springs, double relaxation_time)
    : relaxation_time_(relaxation_time) {
  if (!(relaxation_time >= 0)) throw std::invalid_argument("the relaxation time of bending must not be negative [s]");
  elements_.reserve(springs.size());
  for (const auto& s : springs) {
    if (!(s.stiffness > 0)) throw std::invalid_argument("a bend spring has no stiffness");
    const bool from_centre = s.cross_from == s.centre, to_centre = s.cross_to == s.centre;
    elements_.push_back(
        {.points = {s.previous, s.centre, s.next, to_centre ? -1 : s.cross_to, from_centre ? -1 : s.cross_from},
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
  reaches.reserve(elements_.size());
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
      const Vector3 fa = -moment * (hinge.ga - element.skew * hinge.gc),
                    fb = -moment * (hinge.gb - element.skew * hinge.gc);
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
  const bool keeps_rate_change = tangent.keeps_unsymmetric() && relaxation_time_ > 0;
  stripes_.for_each([&](std::size_t begin, std::size_t end) {
    for (auto e = begin; e < end; ++e) {
      const auto& element = elements_[e];
      const auto x = edges(element, state.q);
      const HingeAngle hinge(x.a, x.b, x.c);
      const HingeCurvature curved(x.a, x.b, x.c);
      const double viscosity = relaxation_time_ * element.stiffness;
      double moment = element.stiffness * (hinge.angle - element.rest_angle);
      Edges v{Vector3::Zero(), Vector3::Zero(), Vector3::Zero()};
      if (viscosity > 0) {
        v = edges(element, state.v);
        moment += viscosity * (hinge.ga.dot(v.a) + hinge.gb.dot(v.b) + hinge.gc.dot(v.c));
      }
      auto t = edge_tangent(hinge, curved, dq * element.stiffness + dv * viscosity, dq * moment);
      if (!tangent.keeps_unsymmetric() && element.skew == 0 && element.centre_in_cross == 0) {
        add_plain(t, e, tangent);
        continue;
      }
      add_rate_change(t, hinge, curved, keeps_rate_change ? dq * viscosity : 0.0, v.a, v.b, v.c);
      const double k = element.skew;
      add_general(t, element.points,
                  {Vector3(-1, 0, k), Vector3(1, -1, element.centre_in_cross), Vector3(0, 1, -k), Vector3(0, 0, 1),
                   Vector3(0, 0, -1)},
                  e, tangent);
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
