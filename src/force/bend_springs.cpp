#include "sundrape/force/bend_springs.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "sundrape/force/hinge_angle.hpp"

#include "batch.hpp"

namespace sundrape {
namespace {

/// Second derivatives of the springs' energy by their edges a, b and axis c (and of its damping's power, where kept).
template <class Matrix>
struct EdgeTangent {
  Matrix aa, ab, ac, bb, bc, cc;  // rows by the first letter
  Matrix ba, ca, cb;              // transposes of the above unless the damping's own change is kept
};

/// modulus · g gᵀ + geometric · ∂²φ
EdgeTangent<Batch3x3> edge_tangent(const BasicHingeAngle<Batch>& hinge, const BasicHingeCurvature<Batch>& curved,
                                   const Batch& modulus, const Batch& geometric) {
  const Batch3 ga = modulus * hinge.ga, gb = modulus * hinge.gb, gc = modulus * hinge.gc;
  EdgeTangent<Batch3x3> t;
  t.aa = ga * hinge.ga.transpose() + geometric * curved.aa;
  t.bb = gb * hinge.gb.transpose() + geometric * curved.bb;
  t.cc = gc * hinge.gc.transpose() + geometric * curved.cc;
  t.ab = ga * hinge.gb.transpose();
  t.ac = ga * hinge.gc.transpose() + geometric * curved.ac;
  t.bc = gb * hinge.gc.transpose() + geometric * curved.bc;
  return t;
}

/// Adds factor · g (∂²φ · rates)ᵀ, by which the damping moment changes as the spring turns: not symmetric.
void add_rate_change(EdgeTangent<Batch3x3>& t, const BasicHingeAngle<Batch>& hinge,
                     const BasicHingeCurvature<Batch>& curved, const Batch& factor, const Batch3& a, const Batch3& b,
                     const Batch3& c) {
  const Batch3 ha = factor * (curved.aa * a + curved.ac * c), hb = factor * (curved.bb * b + curved.bc * c);
  const Batch3 hc = factor * (curved.ac.transpose() * a + curved.bc.transpose() * b + curved.cc * c);
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

/// −∂²/∂x_p∂x_q of springs inside a sheet of straight crossing threads, where a = x₁ − x₀, b = x₂ − x₁, c = x₃ − x₄.
class PlainBlocks {
 public:
  explicit PlainBlocks(const EdgeTangent<Batch3x3>& t) {
    const Batch3x3 aa_ab = t.aa - t.ab, bb_ab = t.bb - t.ab, bc_ac = (t.bc - t.ac).transpose();
    store(own0, -t.aa);
    store(own1, -bb_ab - aa_ab.transpose());
    store(own2, -t.bb);
    store(own34, -t.cc);
    store(below10, aa_ab.transpose());
    store(below20, t.ab.transpose());
    store(below30, t.ac.transpose());
    store(below40, -t.ac.transpose());
    store(below21, bb_ab.transpose());
    store(below31, bc_ac);
    store(below41, -bc_ac);
    store(below32, -t.bc.transpose());
    store(below42, t.bc.transpose());
    store(below43, t.cc);
  }

  void add(std::size_t lane, std::size_t e, Assembler& tangent) const {
    const auto block = [&](Kind kind) -> const Matrix3& { return blocks_(kind, lane); };
    tangent.add_diagonal(e, 0, block(own0));
    tangent.add_diagonal(e, 1, block(own1));
    tangent.add_diagonal(e, 2, block(own2));
    tangent.add_diagonal(e, 3, block(own34));
    tangent.add_diagonal(e, 4, block(own34));
    tangent.add_pair_below(e, 0, 1, block(below10));
    tangent.add_pair_below(e, 0, 2, block(below20));
    tangent.add_pair_below(e, 0, 3, block(below30));
    tangent.add_pair_below(e, 0, 4, block(below40));
    tangent.add_pair_below(e, 1, 2, block(below21));
    tangent.add_pair_below(e, 1, 3, block(below31));
    tangent.add_pair_below(e, 1, 4, block(below41));
    tangent.add_pair_below(e, 2, 3, block(below32));
    tangent.add_pair_below(e, 2, 4, block(below42));
    tangent.add_pair_below(e, 3, 4, block(below43));
  }

 private:
  enum Kind : std::size_t {
    own0,
    own1,
    own2,
    own34,
    below10,
    below20,
    below30,
    below40,
    below21,
    below31,
    below41,
    below32,
    below42,
    below43,
    kinds
  };
  void store(Kind kind, const Batch3x3& block) { blocks_.store(kind, block); }

  LaneMatrices<kinds> blocks_;
};

/// The same for one spring of any kind: weights[p] are those of a, b, c in point p.
void add_general(const EdgeTangent<Matrix3>& t, const std::array<int, 5>& points, const std::array<Vector3, 5>& weights,
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

/// One lane of all nine blocks.
EdgeTangent<Matrix3> of_lane(const EdgeTangent<Batch3x3>& t, std::size_t lane) {
  const auto pick = [lane](const Batch3x3& m) {
    Matrix3 one;
    for (int i = 0; i < 9; ++i) one.data()[i] = m.data()[i].get(lane);
    return one;
  };
  return {pick(t.aa), pick(t.ab), pick(t.ac), pick(t.bb), pick(t.bc), pick(t.cc), pick(t.ba), pick(t.ca), pick(t.cb)};
}

}  // namespace

/// The edges and axes of consecutive springs, one a lane.
struct BendSprings::Edges {
  Batch3 a, b, c;

  /// Σ of the gradient of φ times these vectors: with rates, dφ/dt
  [[nodiscard]] Batch along(const BasicHingeAngle<Batch>& hinge) const {
    return hinge.ga.dot(a) + hinge.gb.dot(b) + hinge.gc.dot(c);
  }
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
  std::vector<decltype(table_)::Element> rows;
  rows.reserve(elements_.size());
  for (const auto& e : elements_) {
    const auto& [previous, centre, next, to, from] = e.points;
    rows.push_back({{previous, centre, next, to < 0 ? centre : to, from < 0 ? centre : from},
                    {e.skew, e.rest_angle, e.stiffness}});
  }
  table_ = decltype(table_)(rows);
}

BendSprings::Edges BendSprings::edges(std::size_t first, ConstVectorRef x) const {
  const auto at = [&](std::size_t p) { return gather(x, table_.places(p, first)); };
  const Batch3 centre = at(1);
  Edges e;
  e.a = centre - at(0);
  e.b = at(2) - centre;
  e.c = at(3) - at(4) - load_batch(table_.numbers_from(skew, first)) * (e.a + e.b);
  return e;
}

double BendSprings::energy(const State& state) const {
  return stripes_.sum([&](std::size_t begin, std::size_t end) {
    return sum_in_batches(begin, end, [&](std::size_t e) -> Batch {
      const auto x = edges(e, state.q);
      const Batch turn = BasicHingeAngle<Batch>(x.a, x.b, x.c).angle - load_batch(table_.numbers_from(rest_angle, e));
      return Batch(0.5) * load_batch(table_.numbers_from(stiffness, e)) * turn * turn;
    });
  });
}

double BendSprings::dissipated_power(const State& state) const {
  if (relaxation_time_ == 0) return 0;
  return stripes_.sum([&](std::size_t begin, std::size_t end) {
    return sum_in_batches(begin, end, [&](std::size_t e) -> Batch {
      const auto x = edges(e, state.q);
      const Batch rate = edges(e, state.v).along(BasicHingeAngle<Batch>(x.a, x.b, x.c));
      return Batch(relaxation_time_) * load_batch(table_.numbers_from(stiffness, e)) * rate * rate;
    });
  });
}

void BendSprings::add_force(const State& state, VectorRef f) const {
  stripes_.for_each([&](std::size_t begin, std::size_t end) {
    LaneBuffer<15> pull;
    for (auto e = begin; e < end; e += lanes) {
      const auto x = edges(e, state.q);
      const BasicHingeAngle<Batch> hinge(x.a, x.b, x.c);
      Batch turn = hinge.angle - load_batch(table_.numbers_from(rest_angle, e));
      if (relaxation_time_ > 0) turn += Batch(relaxation_time_) * edges(e, state.v).along(hinge);
      const Batch moment = load_batch(table_.numbers_from(stiffness, e)) * turn;
      const Batch3 fc = -moment * hinge.gc, held = load_batch(table_.numbers_from(skew, e)) * fc;
      const Batch3 fa = -moment * hinge.ga - held, fb = -moment * hinge.gb - held;
      pull.store(0, -fa);
      pull.store(3, fa - fb);
      pull.store(6, fb);
      pull.store(9, fc);
      pull.store(12, -fc);
      for (std::size_t p = 0; p < 5; ++p) scatter_add(pull, 3 * p, table_.places(p, e), std::min(lanes, end - e), f);
    }
  });
}

void BendSprings::add_tangent(const State& state, double dq, double dv, Assembler& tangent) const {
  const bool exact = tangent.keeps_unsymmetric();
  stripes_.for_each([&](std::size_t begin, std::size_t end) {
    for (auto e = begin; e < end; e += lanes) {
      const auto x = edges(e, state.q);
      const BasicHingeAngle<Batch> hinge(x.a, x.b, x.c);
      const BasicHingeCurvature<Batch> curved(x.a, x.b, x.c);
      const Batch stiff = load_batch(table_.numbers_from(stiffness, e)), viscosity = Batch(relaxation_time_) * stiff;
      Batch moment = stiff * (hinge.angle - load_batch(table_.numbers_from(rest_angle, e)));
      Edges v{Batch3::Constant(Batch(0.0)), Batch3::Constant(Batch(0.0)), Batch3::Constant(Batch(0.0))};
      if (relaxation_time_ > 0) {
        v = edges(e, state.v);
        moment += viscosity * v.along(hinge);
      }
      auto t = edge_tangent(hinge, curved, Batch(dq) * stiff + Batch(dv) * viscosity, Batch(dq) * moment);
      const std::size_t count = std::min(lanes, end - e);
      const auto is_plain = [&](const Element& s) { return !exact && s.skew == 0 && s.centre_in_cross == 0; };
      const auto all = std::span(elements_).subspan(e, count);
      if (std::ranges::any_of(all, is_plain)) {
        const PlainBlocks blocks(t);
        for (std::size_t lane = 0; lane < count; ++lane)
          if (is_plain(all[lane])) blocks.add(lane, e + lane, tangent);
      }
      if (std::ranges::all_of(all, is_plain)) continue;
      t.ba = t.ab.transpose();
      t.ca = t.ac.transpose();
      t.cb = t.bc.transpose();
      if (exact && relaxation_time_ > 0) add_rate_change(t, hinge, curved, Batch(dq) * viscosity, v.a, v.b, v.c);
      for (std::size_t lane = 0; lane < count; ++lane) {
        if (is_plain(all[lane])) continue;
        const double k = all[lane].skew;
        add_general(of_lane(t, lane), all[lane].points,
                    {Vector3(-1, 0, k), Vector3(1, -1, all[lane].centre_in_cross), Vector3(0, 1, -k), Vector3(0, 0, 1),
                     Vector3(0, 0, -1)},
                    e + lane, tangent);
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
  for (std::size_t e = 0; e < elements_.size(); e += lanes) {
    const auto x = edges(e, q);
    const Batch angle = xsimd::abs(BasicHingeAngle<Batch>(x.a, x.b, x.c).angle);
    for (std::size_t lane = 0; lane < lanes; ++lane) largest = std::max(largest, angle.get(lane));
  }
  return largest;
}

}  // namespace sundrape
