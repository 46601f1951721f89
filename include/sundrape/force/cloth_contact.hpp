#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "sundrape/force/cloth_law.hpp"
#include "sundrape/force/cloth_pairs.hpp"
#include "sundrape/force/contact_report.hpp"
#include "sundrape/force/force_term.hpp"
#include "sundrape/force/friction_law.hpp"

namespace sundrape {

/// How cloth keeps off cloth.
struct ClothContactOptions {
  double friction = 0;  // μ
  FrictionLaw friction_law = FrictionLaw(1e-4);
  FrictionMatrix friction_matrix = FrictionMatrix::secant;
};

/// Contact of cloth with cloth, by penalty: of a sheet with itself and with others, on both sides alike, with friction.
///
/// With the thickness h at which two sheets lie on each other, a node at distance d from a triangle has the energy
/// A W(d, h), with the potential W of ClothLaw; forces and tangent are its exact derivatives. Edges that cross are a
/// second line: where sheets touch with their nodes, edges are no nearer, but ridges and rims can slip between nodes.
/// They push from `edge_share` h on, with a factor that vanishes as edges become parallel (C. Li et al., "Incremental
/// potential contact", 2020, (24)). Friction acts along both mid-surfaces, a thickness apart; the couple of the two is
/// left out of the cloth's balance. Which pairs are near is found anew when nodes have moved; it decides what is
/// computed, never what comes out.
///
/// Shapes: N nodes, so q and forces have 3N entries or more; each pair that couples is an element of up to four points.
class ClothContact final : public ForceTerm {
 public:
  /// @throws std::invalid_argument  unless the thickness exceeds the law's smoothing, and friction is not negative
  ClothContact(ClothPairs pairs, const ContactLaw& law, ClothContactOptions options);

  [[nodiscard]] std::string_view name() const override { return "cloth contact"; }
  [[nodiscard]] EnergyKind kind() const override { return EnergyKind::contact; }
  [[nodiscard]] double energy(const State& state) const override;
  [[nodiscard]] double dissipated_power(const State& state) const override;
  void add_force(const State& state, VectorRef force) const override;
  void add_tangent(const State& state, double dq, double dv, Assembler& tangent) const override;
  [[nodiscard]] bool adapt(const State& state) const override;
  void declare_pattern(Pattern& pattern) const override;
  [[nodiscard]] bool watches_passages() const override { return true; }
  [[nodiscard]] std::optional<Passage> passage(const State& from, const State& to) const override;
  [[nodiscard]] bool settles(const State& before, const State& after) const override;

  [[nodiscard]] const ClothLaw& law() const { return law_; }
  [[nodiscard]] const ClothContactOptions& options() const { return options_; }
  [[nodiscard]] const SheetSurface& surface() const { return pairs_.surface(); }
  [[nodiscard]] ContactReport report(const State& state) const;
  /// How often pairs were searched so far, and elements declared anew.
  [[nodiscard]] long searches() const { return searches_; }
  [[nodiscard]] long patterns() const { return patterns_; }

  static constexpr double edge_share = 0.6;

 private:
  struct Candidate {
    ClothPair pair;
    double distance;       // when it was found [m]
    std::int32_t element;  // among those declared; −1: not
  };
  struct Contact;

  [[nodiscard]] double reach() const { return law_.reach(pairs_.largest_thickness()); }
  /// At which distance a pair rests under no load, nearly [m].
  [[nodiscard]] static double rest_distance(const ClothPair& pair) {
    return (pair.shapes == Shapes::edge_edge ? edge_share : 1) * pair.thickness;
  }
  /// Candidates for all states whose nodes are near q.
  void search(const ConstVectorRef& q, double margin) const;
  /// Sees to candidates for a state; how far nodes have moved since these were found, at most [m].
  double require_candidates(const ConstVectorRef& q) const;
  /// Whether a candidate can have come nearer than `near` since it was found.
  [[nodiscard]] bool may_be_within(double near, const Candidate& candidate, const ConstVectorRef& q) const;
  void list_elements() const;
  /// Whether a pair presses, or soon may.
  [[nodiscard]] bool couples(const ClothPair& pair, const ConstVectorRef& q) const;
  /// How far nodes have moved since the last search, at most, but for what they all have in common [m].
  [[nodiscard]] double moved_since_search(const ConstVectorRef& q) const;
  template <class Visit>
  void visit(const State& state, Visit&& visit) const;
  [[nodiscard]] Vector3 sliding(const Contact& contact, const State& state) const;

  ClothPairs pairs_;
  ClothLaw law_;
  ClothContactOptions options_;
  double mean_edge_ = 0;  // at rest [m]

  // What is near what: a cache.
  mutable std::vector<Candidate> candidates_;
  mutable std::vector<ClothPair> elements_;
  mutable Vector searched_at_;
  mutable double margin_;  // beyond reach [m]
  mutable long searches_ = 0, patterns_ = 0, uses_ = 0;
};

}  // namespace sundrape
