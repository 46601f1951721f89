#pragma once
#include <optional>
#include <string>
#include <string_view>

#include "sundrape/force/energies.hpp"
#include "sundrape/linalg/block_matrix.hpp"
#include "sundrape/types.hpp"

namespace sundrape {

/// Under which heading of the energy balance a term's energy is reported.
enum class EnergyKind { membrane, shear, bending, gravity, contact, load, none };

/// Something that a step of the motion must not do: cloth would pass through cloth.
struct Passage {
  std::string what;  // "node 7 through the triangle of nodes 31, 32 and 42"
  Vector3 place;     // [m]
};

/// "cloth would pass through cloth, node 7 through ..., at (...) m"
[[nodiscard]] std::string describe(const Passage& passage);

/// One contribution to  M a = Σ f_k(q, v, t).
///
/// A term knows its energy, its force, the exact derivatives of its force and which points it couples. It knows
/// nothing of time steps, and no solver knows what it models.
class ForceTerm {
 public:
  virtual ~ForceTerm() = default;
  [[nodiscard]] virtual std::string_view name() const = 0;
  [[nodiscard]] virtual EnergyKind kind() const = 0;

  /// Whether the term is a load from outside: weight, forces, moments, pressure.
  [[nodiscard]] virtual bool is_external() const { return false; }

  /// Stored energy [J]; 0 for a term that has none.
  [[nodiscard]] virtual double energy(const State& state) const = 0;
  /// Adds it under its heading; a term with energies of several kinds overrides this.
  virtual void add_energies(const State& state, Energies& energies) const;
  /// Adds what the cloth stores by its deformation, shared by the points of each element: P numbers [J]. Nothing where
  /// the term's energy is none of the cloth's.
  virtual void add_strain_energy(const State& /*state*/, VectorRef /*of_points*/) const {}
  /// Power that the term turns into heat [W], ≥ 0.
  [[nodiscard]] virtual double dissipated_power(const State& /*state*/) const { return 0; }
  /// Power from outside that the term's energy does not account for [W]: follower loads, loads on a ramp.
  [[nodiscard]] virtual double external_power(const State& /*state*/) const { return 0; }

  /// f += this term's force [N]; f has the shape of q.
  virtual void add_force(const State& state, VectorRef f) const = 0;
  /// Adds dq · ∂f/∂q + dv · ∂f/∂v, element by element as declared.
  virtual void add_tangent(const State& state, double dq, double dv, Assembler& tangent) const = 0;
  /// Whether ∂f/∂q is symmetric where rates vanish: else only a solver for unsymmetric matrices gets it whole.
  [[nodiscard]] virtual bool has_symmetric_tangent() const { return true; }
  /// Declares the term's elements: one begin_term, then one add_element each.
  virtual void declare_pattern(Pattern& pattern) const = 0;
  /// Whether the elements declared last do for the tangent at a state; if not, brings them up to date, to be declared
  /// anew. What a term computes never depends on it.
  [[nodiscard]] virtual bool adapt(const State& /*state*/) const { return true; }
  /// Whether there is anything that nodes must not pass through.
  [[nodiscard]] virtual bool watches_passages() const { return false; }
  /// What nodes that go straight from one state to another would pass through; nothing if they may.
  [[nodiscard]] virtual std::optional<Passage> passage(const State& /*from*/, const State& /*to*/) const {
    return std::nullopt;
  }
  /// Whether Newton's iteration may end with a correction from one iterate to the next. Within a barrier, whose force
  /// has no bound, corrections are small long before the force is right: they then have to be small against the
  /// barrier.
  [[nodiscard]] virtual bool settles(const State& /*before*/, const State& /*after*/) const { return true; }
};

}  // namespace sundrape
