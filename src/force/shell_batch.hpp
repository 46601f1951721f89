#pragma once
// The shell's elements several at a time: from the constants in its table to energies, forces and stiffness by the
// modes of each element.
#include "sundrape/force/shell.hpp"

#include "batch.hpp"
#include "shell_nodal_blocks.hpp"
#include "shell_strains.hpp"

namespace sundrape {
namespace shell {

/// Stiffness between the strains of a group.
template <std::size_t strains>
using Stiffness = std::array<std::array<Batch, strains>, strains>;

/// Position of (k, l), k ≤ l, in an upper triangle of size n written row by row.
constexpr std::size_t triangle(std::size_t k, std::size_t l, std::size_t n) { return k * n - k * (k + 1) / 2 + l; }

template <std::size_t strains, class Table>
Stiffness<strains> load_symmetric(const Table& table, std::size_t number, std::size_t e) {
  Stiffness<strains> c;
  for (std::size_t k = 0; k < strains; ++k)
    for (std::size_t l = k; l < strains; ++l) c[k][l] = c[l][k] = load(table, number + triangle(k, l, strains), e);
  return c;
}

template <std::size_t strains, class Table>
std::array<Batch, strains> load_list(const Table& table, std::size_t number, std::size_t e) {
  std::array<Batch, strains> list;
  for (std::size_t k = 0; k < strains; ++k) list[k] = load(table, number + k, e);
  return list;
}

template <std::size_t strains>
std::array<Batch, strains> difference(const std::array<Batch, strains>& x, const std::array<Batch, strains>& y) {
  std::array<Batch, strains> d;
  for (std::size_t k = 0; k < strains; ++k) d[k] = x[k] - y[k];
  return d;
}

template <std::size_t strains>
Batch dot(const std::array<Batch, strains>& x, const std::array<Batch, strains>& y) {
  Batch sum(0.0);
  for (std::size_t k = 0; k < strains; ++k) sum += x[k] * y[k];
  return sum;
}

template <class Group>
std::array<Batch, Group::strains> multiply(const Stiffness<Group::strains>& c,
                                           const std::array<Batch, Group::strains>& s) {
  std::array<Batch, Group::strains> n;
  for (std::size_t k = 0; k < Group::strains; ++k) {
    n[k] = Batch(0.0);
    for (std::size_t l = 0; l < Group::strains; ++l)
      if (Group::couples(k, l)) n[k] += c[k][l] * s[l];
  }
  return n;
}

/// Rates of the strains when the modes change at rates v.
template <class Group>
std::array<Batch, Group::strains> rates(const Gradient<Group::strains>& g, const Modes& v) {
  std::array<Batch, Group::strains> r;
  for (std::size_t k = 0; k < Group::strains; ++k) {
    r[k] = Batch(0.0);
    for (std::size_t m = 0; m < modes; ++m)
      if (Group::touches(k, m)) r[k] += g[k][m].dot(v[m]);
  }
  return r;
}

/// force −= Σ n_k ∂s_k/∂mode
template <class Group>
void subtract_force(const Gradient<Group::strains>& g, const std::array<Batch, Group::strains>& n, Modes& force) {
  for (std::size_t k = 0; k < Group::strains; ++k)
    for (std::size_t m = 0; m < modes; ++m)
      if (Group::touches(k, m)) force[m] -= n[k] * g[k][m];
}

/// h += Gᵀ C R; of a symmetric result the blocks (m, n) with m ≤ n.
template <class Group, bool symmetric>
void add_product(const Gradient<Group::strains>& g, const Stiffness<Group::strains>& c,
                 const Gradient<Group::strains>& r, Blocks& h) {
  for (std::size_t n = 0; n < modes; ++n) {
    std::array<Batch3, Group::strains> stressed;
    bool any = false;
    for (std::size_t k = 0; k < Group::strains; ++k) {
      stressed[k] = Batch3::Constant(Batch(0.0));
      for (std::size_t l = 0; l < Group::strains; ++l)
        if (Group::touches(l, n) && Group::couples(k, l)) {
          stressed[k] += c[k][l] * r[l][n];
          any = true;
        }
    }
    if (!any) continue;
    for (std::size_t m = 0; m < (symmetric ? n + 1 : modes); ++m)
      for (std::size_t k = 0; k < Group::strains; ++k)
        if (Group::touches(k, m)) h[m][n] += g[k][m] * stressed[k].transpose();
  }
}

template <std::size_t strains>
void scale(Stiffness<strains>& c, double factor) {
  for (auto& row : c)
    for (auto& entry : row) entry *= Batch(factor);
}

}  // namespace shell

using namespace shell;  // shell.cpp alone includes this file

/// What consecutive elements are doing in a given state.
class Shell::Element {
 public:
  Element(const Shell& shell, std::size_t first, const State& state)
      : shell_(shell),
        first_(first),
        q_(shell_modes(state.q)),
        curvature_(q_, shell.options_.curvature, load(shell.table_, Number::spans, first)) {
    const auto& damping = shell.section_;
    damped_ = damping.membrane_damping > 0 || damping.bending_damping > 0;
    if (damped_) v_ = shell_modes(state.v);
    membrane_ = load_symmetric<6>(shell.table_, Number::membrane, first);
    shear_ = load_symmetric<4>(shell.table_, Number::shear, first);
    for (std::size_t g = 0; g < 4; ++g) bending_[g] = load_symmetric<3>(shell.table_, Number::bending + 6 * g, first);
  }
  Element(const Element&) = delete;
  Element& operator=(const Element&) = delete;
  Element(Element&&) = delete;
  Element& operator=(Element&&) = delete;
  ~Element() = default;

  struct Energy {
    Batch membrane, shear, bending;
  };
  [[nodiscard]] Energy energy() const {
    const auto s = membrane_strains();
    const auto t = shear_strains();
    Energy e{Batch(0.5) * dot(s, multiply<Membrane>(membrane_, s)),
             Batch(0.5) * dot(t, multiply<TransverseShear>(shear_, t)), bent().energy};
    return e;
  }

  [[nodiscard]] Batch dissipated_power() const {
    const auto s = rates<Membrane>(Membrane::gradient(q_), v_);
    const auto t = rates<TransverseShear>(TransverseShear::gradient(q_), v_);
    const auto k = rates<Curvature>(curvature_.gradient(), v_);
    return Batch(shell_.section_.membrane_damping) *
               (dot(s, multiply<Membrane>(membrane_, s)) + dot(t, multiply<TransverseShear>(shear_, t))) +
           Batch(shell_.section_.bending_damping) * dot(k, linear_moments(k));
  }

  /// By the modes.
  [[nodiscard]] Modes force() const {
    Modes f;
    for (auto& mode : f) mode = Batch3::Constant(Batch(0.0));
    const auto membrane = Membrane::gradient(q_);
    subtract_force<Membrane>(membrane, membrane_forces(membrane), f);
    const auto shear = TransverseShear::gradient(q_);
    subtract_force<TransverseShear>(shear, shear_forces(shear), f);
    const auto curvature = curvature_.gradient();
    auto moments = bent().moments;
    add_viscous_moments(curvature, moments);
    subtract_force<Curvature>(curvature, moments, f);
    return f;
  }

  /// h = dq K + dv C by the modes, K = −∂f/∂q, C = −∂f/∂v; if `symmetric` only the blocks (m, n) with m ≤ n, without
  /// what damping adds to K by the change of its directions.
  template <bool symmetric>
  void stiffness(double dq, double dv, Blocks& h) const {
    for (auto& row : h)
      for (auto& block : row) block.setConstant(Batch(0.0));
    const double membrane_viscosity = shell_.section_.membrane_damping,
                 bending_viscosity = shell_.section_.bending_damping;
    const auto membrane = Membrane::gradient(q_);
    const auto shear = TransverseShear::gradient(q_);
    const auto curvature = curvature_.gradient();
    const auto bent = this->bent();

    const Batch geometric(dq);
    const auto scaled = [&](auto stresses) {
      for (auto& s : stresses) s *= geometric;
      return stresses;
    };
    Membrane::add_geometric(scaled(membrane_forces(membrane)), h);
    TransverseShear::add_geometric(scaled(shear_forces(shear)), h);
    auto moments = bent.moments;
    add_viscous_moments(curvature, moments);
    curvature_.add_geometric(scaled(moments), h);
    auto c = membrane_;
    scale<6>(c, dq + dv * membrane_viscosity);
    add_product<Membrane, true>(membrane, c, membrane, h);
    auto cs = shear_;
    scale<4>(cs, dq + dv * membrane_viscosity);
    add_product<TransverseShear, true>(shear, cs, shear, h);
    std::array<Stiffness<3>, 4> d = bent.tangents;
    for (std::size_t g = 0; g < 4; ++g)
      for (std::size_t k = 0; k < 3; ++k)
        for (std::size_t l = 0; l < 3; ++l)
          d[g][k][l] = geometric * d[g][k][l] + Batch(dv * bending_viscosity) * bending_[g][k][l];
    const bool skew = !shell_.section_.bending.is_symmetric();
    if (symmetric && skew)
      for (auto& at_point : d)
        for (std::size_t k = 0; k < 3; ++k)
          for (std::size_t l = 0; l < k; ++l)
            at_point[k][l] = at_point[l][k] = Batch(0.5) * (at_point[k][l] + at_point[l][k]);
    if (symmetric || !skew) add_product<Curvature, true>(curvature, gathered(d), curvature, h);
    if (symmetric) return;

    for (std::size_t m = 0; m < modes; ++m)
      for (std::size_t n = 0; n < m; ++n) h[m][n] = h[n][m].transpose();
    if (skew) add_product<Curvature, false>(curvature, gathered(d), curvature, h);
    if (!damped_ || dq == 0) return;
    auto viscous = membrane_;
    scale<6>(viscous, dq * membrane_viscosity);
    add_product<Membrane, false>(membrane, viscous, Membrane::gradient(v_), h);
    auto viscous_shear = shear_;
    scale<4>(viscous_shear, dq * membrane_viscosity);
    add_product<TransverseShear, false>(shear, viscous_shear, TransverseShear::gradient(v_), h);
    auto viscous_bending = gathered(bending_);
    scale<8>(viscous_bending, dq * bending_viscosity);
    add_product<Curvature, false>(curvature, viscous_bending, curvature_.gradient_rate(v_), h);
  }

 private:
  struct Bent {
    std::array<Batch, 8> moments;          // elastic
    std::array<Stiffness<3>, 4> tangents;  // at each point of integration
    Batch energy;
  };

  [[nodiscard]] Modes shell_modes(const ConstVectorRef& x) const {
    std::array<Batch3, 4> p, t;
    for (std::size_t k = 0; k < 4; ++k) {
      p[k] = gather(x, shell_.table_, k, first_);
      t[k] = gather(x, shell_.table_, 4 + k, first_);
    }
    return modes_of(p, t, shell_.options_.director_length);
  }

  [[nodiscard]] std::array<Batch, 6> membrane_strains() const {
    return difference(Membrane::values(q_), load_list<6>(shell_.table_, Number::membrane_rest, first_));
  }
  [[nodiscard]] std::array<Batch, 4> shear_strains() const {
    return difference(TransverseShear::values(q_), load_list<4>(shell_.table_, Number::shear_rest, first_));
  }
  [[nodiscard]] std::array<Batch, 6> membrane_forces(const Gradient<6>& g) const {
    auto s = membrane_strains();
    if (damped_) add_scaled(s, rates<Membrane>(g, v_), shell_.section_.membrane_damping);
    return multiply<Membrane>(membrane_, s);
  }
  [[nodiscard]] std::array<Batch, 4> shear_forces(const Gradient<4>& g) const {
    auto s = shear_strains();
    if (damped_) add_scaled(s, rates<TransverseShear>(g, v_), shell_.section_.membrane_damping);
    return multiply<TransverseShear>(shear_, s);
  }
  /// By the rigidities of linear bending, or of a nonlinear law at κ = 0: of curvatures, or of their rates.
  [[nodiscard]] std::array<Batch, 8> linear_moments(const std::array<Batch, 8>& curvatures) const {
    return multiply<Curvature>(gathered(bending_), curvatures);
  }
  void add_viscous_moments(const Gradient<8>& g, std::array<Batch, 8>& moments) const {
    if (damped_) add_scaled(moments, linear_moments(rates<Curvature>(g, v_)), shell_.section_.bending_damping);
  }
  template <std::size_t strains>
  static void add_scaled(std::array<Batch, strains>& to, const std::array<Batch, strains>& what, double factor) {
    for (std::size_t k = 0; k < strains; ++k) to[k] += Batch(factor) * what[k];
  }

  /// The stiffness between all eight curvatures from those at the points of integration.
  [[nodiscard]] static Stiffness<8> gathered(const std::array<Stiffness<3>, 4>& d) {
    Stiffness<8> c;
    for (auto& row : c) row.fill(Batch(0.0));
    for (std::size_t g = 0; g < 4; ++g) {
      const auto at = Curvature::at_point(g);
      for (std::size_t k = 0; k < 3; ++k)
        for (std::size_t l = 0; l < 3; ++l) c[at[k]][at[l]] += d[g][k][l];
    }
    return c;
  }

  [[nodiscard]] Bent bent() const {
    const auto k = difference(curvature_.values(), load_list<8>(shell_.table_, Number::curvature_rest, first_));
    Bent b;
    if (shell_.section_.bending.form() == PlateBending::Form::linear) {
      b.tangents = bending_;
      b.moments = linear_moments(k);
      b.energy = Batch(0.5) * dot(k, b.moments);
      return b;
    }
    b.moments.fill(Batch(0.0));
    b.energy = Batch(0.0);
    for (std::size_t g = 0; g < 4; ++g) {
      const auto at = Curvature::at_point(g);
      Batch3x3 to_axes;
      for (std::size_t i = 0; i < 9; ++i) to_axes.data()[i] = load(shell_.table_, Number::frame + 9 * g + i, first_);
      const Batch weight = load(shell_.table_, Number::area + g, first_);
      const Batch3 covariant(k[at[0]], k[at[1]], k[at[2]]), local = to_axes * covariant;
      const auto response = shell_.section_.bending.at<Batch>(local);
      const Batch3 moment = weight * (to_axes.transpose() * response.moment);
      const Batch3x3 half = to_axes.transpose() * response.tangent, tangent = half * to_axes;
      for (Eigen::Index i = 0; i < 3; ++i) {
        const auto row = static_cast<std::size_t>(i);
        b.moments[at[row]] += moment[i];
        for (Eigen::Index j = 0; j < 3; ++j) b.tangents[g][row][static_cast<std::size_t>(j)] = weight * tangent(i, j);
      }
      b.energy += weight * response.energy;
    }
    return b;
  }

  const Shell& shell_;
  std::size_t first_;
  bool damped_ = false;
  Modes q_, v_;
  Curvature curvature_;
  Stiffness<6> membrane_;
  Stiffness<4> shear_;
  std::array<Stiffness<3>, 4> bending_;
};

}  // namespace sundrape
