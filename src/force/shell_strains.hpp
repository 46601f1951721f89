#pragma once
// The strains of the shell element in batches: their values, their gradients by the seven modes of an element, and
// what stress resultants make of their second derivatives. Numbered as in docs/shell.md.
#include <array>
#include <cstddef>

#include "geodesic_factor.hpp"
#include "lateral_factor.hpp"
#include "shell_reference.hpp"

namespace sundrape::shell {

/// Modes of the position, x = … + a ξ + b ξη + c η, and of the director, d + da ξ + db ξη + dc η.
enum Mode : std::size_t { a, b, c, d, da, db, dc, modes };
using Modes = std::array<Batch3, modes>;

/// Second derivatives by pairs of modes. Where tangents are symmetric only (m, n) with m ≤ n is kept.
using Blocks = std::array<std::array<Batch3x3, modes>, modes>;

inline void add_multiple_of_unit(Blocks& h, Mode m, Mode n, const Batch& factor) {
  h[m][n].diagonal().array() += factor;
}

/// ∂s_k/∂mode for the modes that a strain touches; others are not set.
template <std::size_t strains>
using Gradient = std::array<std::array<Batch3, modes>, strains>;

/// s = (½a·a, ½c·c, a·c, a·b, c·b, ½b·b)
struct Membrane {
  static constexpr std::size_t strains = 6;
  static constexpr bool touches(std::size_t k, std::size_t m) {
    constexpr std::array<std::array<bool, 3>, strains> table{{{true, false, false},
                                                              {false, false, true},
                                                              {true, false, true},
                                                              {true, true, false},
                                                              {false, true, true},
                                                              {false, true, false}}};
    return m < 3 && table[k][m];
  }
  static constexpr bool couples(std::size_t /*k*/, std::size_t /*l*/) { return true; }

  static std::array<Batch, strains> values(const Modes& q) {
    const Batch half(0.5);
    return {half * q[a].squaredNorm(), half * q[c].squaredNorm(), q[a].dot(q[c]), q[a].dot(q[b]), q[c].dot(q[b]),
            half * q[b].squaredNorm()};
  }
  /// Linear in q: at rates it is the gradient's rate.
  static Gradient<strains> gradient(const Modes& q) {
    Gradient<strains> g;
    g[0][a] = q[a];
    g[1][c] = q[c];
    g[2][a] = q[c];
    g[2][c] = q[a];
    g[3][a] = q[b];
    g[3][b] = q[a];
    g[4][b] = q[c];
    g[4][c] = q[b];
    g[5][b] = q[b];
    return g;
  }
  static void add_geometric(const std::array<Batch, strains>& n, Blocks& h) {
    add_multiple_of_unit(h, a, a, n[0]);
    add_multiple_of_unit(h, c, c, n[1]);
    add_multiple_of_unit(h, b, b, n[5]);
    add_multiple_of_unit(h, a, c, n[2]);
    add_multiple_of_unit(h, a, b, n[3]);
    add_multiple_of_unit(h, b, c, n[4]);
  }
};

/// x,ξ · t at (0, −1) and (0, 1), x,η · t at (−1, 0) and (1, 0).
struct TransverseShear {
  static constexpr std::size_t strains = 4;
  static constexpr bool touches(std::size_t k, std::size_t m) {
    return m == b || m == d || (k < 2 ? m == a || m == dc : m == c || m == da);
  }
  static constexpr bool couples(std::size_t /*k*/, std::size_t /*l*/) { return true; }

  static std::array<Batch, strains> values(const Modes& q) {
    return {(q[a] - q[b]).dot(q[d] - q[dc]), (q[a] + q[b]).dot(q[d] + q[dc]), (q[c] - q[b]).dot(q[d] - q[da]),
            (q[c] + q[b]).dot(q[d] + q[da])};
  }
  /// Linear in q: at rates it is the gradient's rate.
  static Gradient<strains> gradient(const Modes& q) {
    Gradient<strains> g;
    const auto edge = [&](std::size_t k, Mode along, Mode across, double side) {
      const Batch s(side);
      const Batch3 tangent = q[along] + s * q[b], director = q[d] + s * q[across];
      g[k][along] = director;
      g[k][b] = s * director;
      g[k][d] = tangent;
      g[k][across] = s * tangent;
    };
    edge(0, a, dc, -1);
    edge(1, a, dc, 1);
    edge(2, c, da, -1);
    edge(3, c, da, 1);
    return g;
  }
  static void add_geometric(const std::array<Batch, strains>& n, Blocks& h) {
    const Batch sum1 = n[0] + n[1], sum2 = n[2] + n[3], difference1 = n[1] - n[0], difference2 = n[3] - n[2];
    add_multiple_of_unit(h, a, d, sum1);
    add_multiple_of_unit(h, a, dc, difference1);
    add_multiple_of_unit(h, b, d, difference1 + difference2);
    add_multiple_of_unit(h, b, dc, sum1);
    add_multiple_of_unit(h, c, d, sum2);
    add_multiple_of_unit(h, c, da, difference2);
    add_multiple_of_unit(h, b, da, sum2);
  }
};

/// κ₁₁ at η = ∓1/√3, κ₂₂ at ξ = ∓1/√3, 2κ₁₂ at the four points of integration.
///
/// κ₁₁ = F(|t,ξ|²) N(|t,η|²) x,ξ·t,ξ, κ₂₂ likewise, 2κ₁₂ = x,ξ·t,η + x,η·t,ξ: (5), the first two with the geodesic
/// factor F and, in elements that span the sheet, the lateral factor N of the other derivative at the centre.
class Curvature {
 public:
  static constexpr std::size_t strains = 8;
  static constexpr bool touches(std::size_t k, std::size_t m) {
    if (m == d) return false;
    if (k >= 4) return true;
    return k < 2 ? m != c : m != a;
  }
  /// Strains that meet at a point of integration.
  static constexpr bool couples(std::size_t k, std::size_t l) {
    if (k > l) return couples(l, k);
    if (l < 2 || (k >= 2 && l < 4) || k >= 4) return k == l;
    if (l < 4) return true;
    return k < 2 ? (l - 4) / 2 == k : (l - 4) % 2 == k - 2;
  }
  /// Numbers of the three strains at point of integration g.
  static constexpr std::array<std::size_t, 3> at_point(std::size_t g) { return {g / 2, 2 + g % 2, 4 + g}; }

  /// @param spans  1 in elements that span the sheet, else 0
  Curvature(const Modes& q, CurvatureMeasure measure, const Batch& spans) {
    for (std::size_t k = 0; k < 4; ++k) {
      auto& bent = bends_[k];
      const Batch s(k % 2 == 0 ? -integration_point : integration_point);
      bent.side = s;
      bent.x = q[k < 2 ? a : c] + s * q[b];
      bent.e = q[k < 2 ? da : dc] + s * q[db];
      bent.l = q[k < 2 ? dc : da];
      bent.product = bent.x.dot(bent.e);
      if (measure == CurvatureMeasure::geodesic) {
        const GeodesicFactor f(bent.e.squaredNorm());
        bent.f = f.value;
        bent.f1 = f.first;
        bent.f2 = f.second;
        const LateralFactor n(bent.l.squaredNorm(), spans);
        bent.n = n.value;
        bent.n1 = n.first;
        bent.n2 = n.second;
      } else {
        bent.f = bent.n = Batch(1.0);
        bent.f1 = bent.f2 = bent.n1 = bent.n2 = Batch(0.0);
      }
    }
  }

  [[nodiscard]] std::array<Batch, strains> values() const {
    std::array<Batch, strains> k;
    for (std::size_t i = 0; i < 4; ++i) k[i] = bends_[i].f * bends_[i].n * bends_[i].product;
    for (std::size_t g = 0; g < 4; ++g) {
      const Bend &u = bends_[g / 2], &v = bends_[2 + g % 2];
      k[4 + g] = u.x.dot(v.e) + v.x.dot(u.e);
    }
    return k;
  }

  [[nodiscard]] Gradient<strains> gradient() const {
    Gradient<strains> g;
    for (std::size_t i = 0; i < 4; ++i) {
      const Bend& u = bends_[i];
      const Batch3 by_x = u.f * u.n * u.e, by_e = u.n * (u.f * u.x + Batch(2.0) * u.f1 * u.product * u.e),
                   by_l = Batch(2.0) * u.f * u.n1 * u.product * u.l;
      set_bend(g[i], i, u, by_x, by_e, by_l);
    }
    for (std::size_t k = 0; k < 4; ++k) {
      const Bend &u = bends_[k / 2], &v = bends_[2 + k % 2];
      set_twist(g[4 + k], u, v);
    }
    return g;
  }

  /// Rate of the gradient when the modes change at rates v.
  [[nodiscard]] Gradient<strains> gradient_rate(const Modes& v) const {
    Gradient<strains> g;
    std::array<Bend, 4> rates;
    for (std::size_t i = 0; i < 4; ++i) {
      const Bend& u = bends_[i];
      Bend& r = rates[i];
      r.side = u.side;
      r.x = v[i < 2 ? a : c] + u.side * v[b];
      r.e = v[i < 2 ? da : dc] + u.side * v[db];
      r.l = v[i < 2 ? dc : da];
      const Batch two(2.0);
      // rates of |e|², |l|² and x·e, and of F, F', N, N'
      const Batch along = two * u.e.dot(r.e), across = two * u.l.dot(r.l), product = u.x.dot(r.e) + u.e.dot(r.x);
      const Batch f = u.f1 * along, f1 = u.f2 * along, n = u.n1 * across, n1 = u.n2 * across;
      const Batch both = f * u.n + u.f * n;
      const Batch3 by_x = both * u.e + u.f * u.n * r.e;
      const Batch3 by_e =
          both * u.x + u.f * u.n * r.x +
          two * (((f1 * u.n + u.f1 * n) * u.product + u.f1 * u.n * product) * u.e + u.f1 * u.n * u.product * r.e);
      const Batch3 by_l =
          two * (((f * u.n1 + u.f * n1) * u.product + u.f * u.n1 * product) * u.l + u.f * u.n1 * u.product * r.l);
      set_bend(g[i], i, u, by_x, by_e, by_l);
    }
    for (std::size_t k = 0; k < 4; ++k) set_twist(g[4 + k], rates[k / 2], rates[2 + k % 2]);
    return g;
  }

  void add_geometric(const std::array<Batch, strains>& m, Blocks& h) const {
    for (std::size_t i = 0; i < 4; ++i) {
      const Bend& u = bends_[i];
      const Batch two = Batch(2.0) * m[i] * u.f1 * u.n, s = u.side;
      Batch3x3 xe = (two * u.e) * u.e.transpose();  // ∂²κ/∂x∂e
      xe.diagonal().array() += m[i] * u.f * u.n;
      const Batch3 mixed = two * u.x + Batch(2.0) * m[i] * u.f2 * u.n * u.product * u.e;
      Batch3x3 ee = mixed * u.e.transpose() + u.e * mixed.transpose();
      ee.diagonal().array() += two * u.product;
      const Batch3 lateral = Batch(2.0) * m[i] * u.n1 * u.l;
      const Batch3x3 xl = (u.f * u.e) * lateral.transpose();
      const Batch3x3 el = (u.f * u.x + Batch(2.0) * u.f1 * u.product * u.e) * lateral.transpose();
      Batch3x3 ll = (Batch(4.0) * m[i] * u.f * u.n2 * u.product * u.l) * u.l.transpose();
      ll.diagonal().array() += Batch(2.0) * m[i] * u.f * u.n1 * u.product;
      const Mode x = i < 2 ? a : c, e = i < 2 ? da : dc;
      h[x][e] += xe;
      h[b][db] += (s * s) * xe;
      h[x][db] += s * xe;
      h[b][e] += s * xe;
      h[e][e] += ee;
      h[db][db] += (s * s) * ee;
      if (e < db)
        h[e][db] += s * ee;  // ee is symmetric
      else
        h[db][e] += s * ee;
      const Mode l = i < 2 ? dc : da;
      h[x][l] += xl;
      h[b][l] += s * xl;
      h[l][l] += ll;
      if (l == dc) {
        h[e][l] += el;
        h[db][l] += s * el;
      } else {
        h[l][e] += el.transpose();
        h[l][db] += s * el.transpose();
      }
    }
    const Batch p(integration_point);
    const Batch sum = m[4] + m[5] + m[6] + m[7], by_xi = p * (m[5] + m[7] - m[4] - m[6]),
                by_eta = p * (m[6] + m[7] - m[4] - m[5]), by_both = p * p * (m[4] + m[7] - m[5] - m[6]);
    add_multiple_of_unit(h, a, dc, sum);
    add_multiple_of_unit(h, a, db, by_xi);
    add_multiple_of_unit(h, b, dc, by_eta);
    add_multiple_of_unit(h, b, db, Batch(2.0) * by_both);
    add_multiple_of_unit(h, c, da, sum);
    add_multiple_of_unit(h, c, db, by_eta);
    add_multiple_of_unit(h, b, da, by_xi);
  }

 private:
  /// One of the four curvatures: derivatives of position and director along ξ (or η) on a line η (or ξ) = side.
  struct Bend {
    Batch side;
    Batch3 x, e, l;   // l: the director's derivative along the other coordinate, at the centre
    Batch product;    // x·e
    Batch f, f1, f2;  // the geodesic factor and its derivatives by |e|²
    Batch n, n1, n2;  // the lateral factor and its derivatives by |l|²
  };

  static void set_bend(std::array<Batch3, modes>& g, std::size_t i, const Bend& u, const Batch3& by_x,
                       const Batch3& by_e, const Batch3& by_l) {
    g[i < 2 ? a : c] = by_x;
    g[b] = u.side * by_x;
    g[i < 2 ? da : dc] = by_e;
    g[db] = u.side * by_e;
    g[i < 2 ? dc : da] = by_l;
  }
  /// u along ξ, v along η: ∂(u.x·v.e + v.x·u.e)
  static void set_twist(std::array<Batch3, modes>& g, const Bend& u, const Bend& v) {
    g[a] = v.e;
    g[c] = u.e;
    g[b] = u.side * v.e + v.side * u.e;
    g[dc] = u.x;
    g[da] = v.x;
    g[db] = v.side * u.x + u.side * v.x;
  }

  std::array<Bend, 4> bends_;
};

}  // namespace sundrape::shell
