#pragma once
#include <string>

#include "support/benchmarks.hpp"

/// What the tests of the tablecloth (B4) ask of a square cloth that hangs over a table; `q` are all points of a shell
/// or a net, and distances are those of its nodes.
namespace sundrape::square_drape {

constexpr double side = 0.2;                  // of the cloth, L [m]
constexpr double thickness = 0.54229e-3;      // [m]
constexpr double same_branch = 0.002 * side;  // 0.2 % of L: two equilibria that are one [m]

/// What a cloth at rest, or almost, says of itself.
struct Rest {
  double energy = 0;  // stored [J]
  double residual = 0;
  double carried = 0;      // by the table, over the weight
  double penetration = 0;  // [m]
  double strain = 0;       // largest of an edge
  int negative_pivots = -1;
};

[[nodiscard]] Rest look(const Benchmark& b, const Vector& q);

/// The node that starts closest to (x, y, 0).
[[nodiscard]] int node_at(const Benchmark& b, double x, double y);

/// One of the eight symmetries of the square: quarter turns, after a reflection y → −y if asked for.
[[nodiscard]] Matrix3 symmetry(int quarter_turns, bool reflected);

struct Distance {
  double rms = 0, max = 0;  // over the nodes [m]
};

/// How far `q` is from `other` moved by a symmetry of the square.
[[nodiscard]] Distance distance(const Benchmark& b, const Vector& q, const Vector& other, const Matrix3& s);
/// The same up to the symmetries of the square, all of which a drape on a square table has.
[[nodiscard]] Distance nearest_image(const Benchmark& b, const Vector& q, const Vector& other);

struct Place {
  Vector3 corner;   // distances from the middle along both sides, the larger first, and the height over the table [m]
  Vector3 midside;  // distance from the middle at right angles to the side, along the side, height [m]
};

[[nodiscard]] Place place(const Benchmark& b, const Vector& q);

/// Where a quarter turn leaves the drape is a four-fold one; if reflections do as well its folds stand straight,
/// otherwise all four corners are folded over the same way round. Otherwise the larger of the two decides what it is
/// closest to. Where the middles of the sides stand further out than the corners, the folds are at the sides.
[[nodiscard]] std::string branch(const Benchmark& b, const Vector& q);

/// Prints all of this.
void print(const std::string& name, const Benchmark& b, const Vector& q);
/// Stable, balanced, carried by its table and hardly sunk into it.
void expect_rest(const Benchmark& b, const Vector& q);
/// An equilibrium by relaxation, printed.
[[nodiscard]] Vector rest_of(const std::string& name, const Benchmark& b);
/// The deepest penetration in all frames [m].
[[nodiscard]] double deepest(const Benchmark& b, const Motion& m);

}  // namespace sundrape::square_drape
