#include "sundrape/force/bend_springs.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

#include "sundrape/force/bend_law.hpp"
#include "sundrape/force/fold_limit.hpp"
#include "sundrape/force/hinge_angle.hpp"

#include "batch.hpp"

namespace sundrape {
namespace {

// Within the barrier Newton's last correction turns springs by this part of what is left to π, at most.
constexpr double settled = 0.1;

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
/// Blocks above the diagonal are kept only where they are no transposes.
template <bool exact>
class PlainBlocks {
 public:
  [[gnu::flatten]] explicit PlainBlocks(const EdgeTangent<Batch3x3>& t) {
    const Batch3x3 aa_ab = t.aa - t.ab, bb_ab = t.bb - t.ab, bc_ac = t.bc - t.ac;
    store(own0, -t.aa);
    store(own2, -t.bb);
    store(own34, -t.cc);
    store(both34, t.cc);
    if constexpr (exact) {
      const Batch3x3 cb_ca = t.cb - t.ca;
      store(own1, t.ba - bb_ab - t.aa);
      store_below(t.aa - t.ba, t.ba, t.ca, t.bb - t.ba, cb_ca, t.cb);
      store(above01, aa_ab);
      store(above02, t.ab);
      store(above03, t.ac);
      store(above04, -t.ac);
      store(above12, bb_ab);
      store(above13, bc_ac);
      store(above14, -bc_ac);
      store(above23, -t.bc);
      store(above24, t.bc);
    } else {
      store(own1, -bb_ab - aa_ab.transpose());
      store_below(aa_ab.transpose(), t.ab.transpose(), t.ac.transpose(), bb_ab.transpose(), bc_ac.transpose(),
                  t.bc.transpose());
    }
  }

  [[gnu::flatten]] void add(std::size_t lane, std::size_t e, Assembler& tangent) const {
    const auto block = [&](Kind kind) -> const Matrix3& { return blocks_(kind, lane); };
    const auto add_pair = [&](int p, int q, [[maybe_unused]] Kind above, Kind below) {
      if constexpr (exact)
        tangent.add_general_pair(e, p, q, block(above), block(below));
      else
        tangent.add_pair_below(e, p, q, block(below));
    };
    tangent.add_diagonal(e, 0, block(own0));
    tangent.add_diagonal(e, 1, block(own1));
    tangent.add_diagonal(e, 2, block(own2));
    tangent.add_diagonal(e, 3, block(own34));
    tangent.add_diagonal(e, 4, block(own34));
    add_pair(0, 1, above01, below10);
    add_pair(0, 2, above02, below20);
    add_pair(0, 3, above03, below30);
    add_pair(0, 4, above04, below40);
    add_pair(1, 2, above12, below21);
    add_pair(1, 3, above13, below31);
    add_pair(1, 4, above14, below41);
    add_pair(2, 3, above23, below32);
    add_pair(2, 4, above24, below42);
    add_pair(3, 4, both34, both34);
  }

 private:
  enum Kind : std::size_t {
    own0,
    own1,
    own2,
    own34,
    both34,
    below10,
    below20,
    below30,
    below40,
    below21,
    below31,
    below41,
    below32,
    below42,
    below_kinds,
    above01 = below_kinds,
    above02,
    above03,
    above04,
    above12,
    above13,
    above14,
    above23,
    above24,
    kinds
  };
  void store(Kind kind, const Batch3x3& block) { blocks_.store(kind, block); }
  void store_below(const Batch3x3& aa_ba, const Batch3x3& ba, const Batch3x3& ca, const Batch3x3& bb_ba,
                   const Batch3x3& cb_ca, const Batch3x3& cb) {
    store(below10, aa_ba);
    store(below20, ba);
    store(below30, ca);
    store(below40, -ca);
    store(below21, bb_ba);
    store(below31, cb_ca);
    store(below41, -cb_ca);
    store(below32, -cb);
    store(below42, cb);
  }

  LaneMatrices<exact ? std::size_t{kinds} : std::size_t{below_kinds}> blocks_;
};

/// One lane's second derivatives, of any kind of spring.
EdgeTangent<Matrix3> of_lane(const LaneMatrices<9>& t, std::size_t lane) {
  return {t(0, lane), t(1, lane), t(2, lane), t(3, lane), t(4, lane), t(5, lane), t(6, lane), t(7, lane), t(8, lane)};
}

LaneMatrices<9> by_lanes(const EdgeTangent<Batch3x3>& t) {
  LaneMatrices<9> lanes_of;
  std::size_t k = 0;
  for (const auto* m : {&t.aa, &t.ab, &t.ac, &t.bb, &t.bc, &t.cc, &t.ba, &t.ca, &t.cb}) lanes_of.store(k++, *m);
  return lanes_of;
}

}  // namespace

/// The edges and axes of consecutive springs, one a lane.
struct BendSprings::Edges {
  Batch3 a, b, c;

  [[nodiscard]] Batch angle() const { return BasicHingeAngle<Batch>(a, b, c).angle; }
  /// Σ of the gradient of φ times these vectors: with rates, dφ/dt
  [[nodiscard]] Batch along(const BasicHingeAngle<Batch>& hinge) const {
    return hinge.ga.dot(a) + hinge.gb.dot(b) + hinge.gc.dot(c);
  }
};

/// The five points of a spring and how its edges and axis depend on them.
struct BendSprings::Stencil {
  std::array<int, 5> points;       // −1 where an end of the crossing chord is the centre, which then has its weight
  std::array<Vector3, 5> weights;  // of a, b, c in each point

  /// −∂²/∂x_p∂x_q of such a spring.
  void add(const EdgeTangent<Matrix3>& t, std::size_t e, Assembler& tangent) const {
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
};

BendSprings::BendSprings(const std::vector<BendSpring>& springs, double relaxation_time,
                         std::optional<MomentCurvature> law)
    : relaxation_time_(relaxation_time), law_(law && !law->is_linear() ? law : std::nullopt) {
  if (!(relaxation_time >= 0)) throw std::invalid_argument("the relaxation time of bending must not be negative [s]");
  std::vector<decltype(table_)::Element> elements;
  elements.reserve(springs.size());
  for (const auto& s : springs) {
    if (!(s.stiffness > 0)) throw std::invalid_argument("a bend spring has no stiffness");
    if (law_ && !(s.length > 0)) throw std::invalid_argument("a bend spring with a law of bending has no length");
    elements.push_back(
        {{s.previous, s.centre, s.next, s.cross_to, s.cross_from}, {s.skew, s.rest_angle, s.stiffness, s.length}});
    auto points = elements.back().points_of;
    for (const std::size_t end : {3U, 4U})
      if (points[end] == s.centre) points[end] = -1;
    std::ranges::sort(points);
    for (std::size_t k = 1; k < points.size(); ++k)
      if (points[k] >= 0 && points[k] == points[k - 1]) throw std::invalid_argument("a bend spring names a node twice");
  }
  stripes_ = sort_into_stripes(elements, [](const auto& e) { return e.points_of; });
  table_ = decltype(table_)(elements);
}

bool BendSprings::is_plain(std::size_t e) const {
  const int centre = table_.point_of(1, e);
  return table_.number_of(skew, e) == 0 && table_.point_of(3, e) != centre && table_.point_of(4, e) != centre;
}

BendSprings::Stencil BendSprings::stencil(std::size_t e) const {
  Stencil s{.points = table_.points_of(e), .weights = {}};
  const int centre = s.points[1];
  double centre_in_axis = 0;
  for (const auto& [end, sign] : {std::pair<std::size_t, double>{3, 1}, {4, -1}}) {
    if (s.points[end] != centre) continue;
    s.points[end] = -1;
    centre_in_axis += sign;
  }
  const double k = table_.number_of(skew, e);
  s.weights = {Vector3(-1, 0, k), Vector3(1, -1, centre_in_axis), Vector3(0, 1, -k), Vector3(0, 0, 1),
               Vector3(0, 0, -1)};
  return s;
}

BendSprings::Edges BendSprings::edges(std::size_t first, ConstVectorRef x) const {
  const auto at = [&](std::size_t p) { return gather(x, table_, p, first); };
  const Batch3 centre = at(1);
  Edges e;
  e.a = centre - at(0);
  e.b = at(2) - centre;
  e.c = at(3) - at(4) - load(table_, skew, first) * (e.a + e.b);
  return e;
}

struct BendSprings::Stored {
  Batch energy;  // [J]
};

BendSprings::Stored BendSprings::stored(std::size_t first, ConstVectorRef q) const {
  const Batch angle = edges(first, q).angle(), turn = angle - load(table_, rest_angle, first);
  const Batch bending =
      law_ ? bend_response(*law_, load(table_, length, first), turn).energy : Batch(0.5) * turn * turn;
  return {load(table_, stiffness, first) * (bending + fold_limit(angle).energy)};
}

double BendSprings::energy(const State& state) const {
  return sum_over_batches(stripes_, [&](std::size_t e) -> Batch { return stored(e, state.q).energy; });
}

void BendSprings::add_strain_energy(const State& state, VectorRef of_points) const {
  share_among_points(  // the hinge is at the centre
      stripes_, table_, 1, 1, [&](std::size_t e) -> Batch { return stored(e, state.q).energy; }, of_points);
}

double BendSprings::dissipated_power(const State& state) const {
  if (relaxation_time_ == 0) return 0;
  return sum_over_batches(stripes_, [&](std::size_t e) -> Batch {
    const auto x = edges(e, state.q);
    const Batch rate = edges(e, state.v).along(BasicHingeAngle<Batch>(x.a, x.b, x.c));
    return Batch(relaxation_time_) * load(table_, stiffness, e) * rate * rate;
  });
}

void BendSprings::add_force(const State& state, VectorRef f) const {
  for_each_batch(stripes_, [&](std::size_t e, std::size_t count) {
    LaneBuffer<15> pull;
    const auto x = edges(e, state.q);
    const BasicHingeAngle<Batch> hinge(x.a, x.b, x.c);
    Batch turn = hinge.angle - load(table_, rest_angle, e);
    if (law_) turn = bend_response(*law_, load(table_, length, e), turn).turn;
    turn += fold_limit(hinge.angle).turn;
    if (relaxation_time_ > 0) turn += Batch(relaxation_time_) * edges(e, state.v).along(hinge);
    const Batch moment = load(table_, stiffness, e) * turn;
    const Batch3 fc = -moment * hinge.gc, held = load(table_, skew, e) * fc;
    const Batch3 fa = -moment * hinge.ga - held, fb = -moment * hinge.gb - held;
    pull.store(0, -fa);
    pull.store(3, fa - fb);
    pull.store(6, fb);
    pull.store(9, fc);
    pull.store(12, -fc);
    scatter_add(pull, table_, e, count, f);
  });
}

void BendSprings::add_tangent(const State& state, double dq, double dv, Assembler& tangent) const {
  const bool exact = tangent.keeps_unsymmetric();
  for_each_batch(stripes_, [&](std::size_t e, std::size_t count) {
    const auto x = edges(e, state.q);
    const BasicHingeAngle<Batch> hinge(x.a, x.b, x.c);
    const BasicHingeCurvature<Batch> curved(x.a, x.b, x.c);
    const Batch stiff = load(table_, stiffness, e), viscosity = Batch(relaxation_time_) * stiff;
    Batch turn = hinge.angle - load(table_, rest_angle, e), slope(1.0);
    if (law_) {
      const auto bent = bend_response(*law_, load(table_, length, e), turn);
      turn = bent.turn;
      slope = bent.slope;
    }
    const auto limit = fold_limit(hinge.angle);
    const Batch tangent_stiffness = stiff * (slope + limit.slope);
    Batch moment = stiff * (turn + limit.turn);
    Edges v{Batch3::Constant(Batch(0.0)), Batch3::Constant(Batch(0.0)), Batch3::Constant(Batch(0.0))};
    if (relaxation_time_ > 0) {
      v = edges(e, state.v);
      moment += viscosity * v.along(hinge);
    }
    auto t = edge_tangent(hinge, curved, Batch(dq) * tangent_stiffness + Batch(dv) * viscosity, Batch(dq) * moment);
    const auto transpose = [&t] {
      t.ba = t.ab.transpose();
      t.ca = t.ac.transpose();
      t.cb = t.bc.transpose();
    };
    if (exact) {
      transpose();
      if (relaxation_time_ > 0) add_rate_change(t, hinge, curved, Batch(dq) * viscosity, v.a, v.b, v.c);
    }
    std::array<bool, lanes> plain{};
    for (std::size_t lane = 0; lane < count; ++lane) plain[lane] = is_plain(e + lane);
    const auto plain_ones = static_cast<std::size_t>(std::ranges::count(plain, true));
    const auto add_plain = [&](const auto& blocks) {
      for (std::size_t lane = 0; lane < count; ++lane)
        if (plain[lane]) blocks.add(lane, e + lane, tangent);
    };
    if (plain_ones > 0 && exact)
      add_plain(PlainBlocks<true>(t));
    else if (plain_ones > 0)
      add_plain(PlainBlocks<false>(t));
    if (plain_ones == count) return;
    if (!exact) transpose();
    const auto blocks = by_lanes(t);
    for (std::size_t lane = 0; lane < count; ++lane)
      if (!plain[lane]) stencil(e + lane).add(of_lane(blocks, lane), e + lane, tangent);
  });
}

void BendSprings::declare_pattern(Pattern& pattern) const {
  pattern.begin_term(5);
  for (std::size_t e = 0; e < table_.size(); ++e) pattern.add_element(stencil(e).points);
}

bool BendSprings::settles(const State& before, const State& after) const {
  for (std::size_t e = 0; e < table_.size(); e += lanes) {
    const Batch angle = edges(e, after.q).angle();
    if (xsimd::none(xsimd::abs(angle) > Batch(fold_limit_begin))) continue;
    const Batch turn = xsimd::abs(angle - edges(e, before.q).angle()),
                left = Batch(std::numbers::pi) - xsimd::abs(angle);
    if (xsimd::any((xsimd::abs(angle) > Batch(fold_limit_begin)) && (turn > Batch(settled) * left))) return false;
  }
  return true;
}

std::optional<Passage> BendSprings::passage(const State& from, const State& to) const {
  for (std::size_t e = 0; e < table_.size(); e += lanes) {
    const Batch turn = xsimd::abs(edges(e, to.q).angle() - edges(e, from.q).angle());
    for (std::size_t lane = 0; lane < std::min(lanes, table_.size() - e); ++lane) {
      if (!(turn.get(lane) > std::numbers::pi)) continue;
      const int centre = table_.point_of(1, e + lane);
      return Passage{"the thread through itself at node " + std::to_string(centre), point(from.q, centre)};
    }
  }
  return std::nullopt;
}

double BendSprings::largest_angle(ConstVectorRef q) const {
  double largest = 0;
  for (std::size_t e = 0; e < table_.size(); e += lanes) {
    const Batch angle = xsimd::abs(edges(e, q).angle());
    for (std::size_t lane = 0; lane < lanes; ++lane) largest = std::max(largest, angle.get(lane));
  }
  return largest;
}

}  // namespace sundrape
