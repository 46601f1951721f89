#pragma once
// From the modes of a shell element to its nodes and directors, and back.
#include <algorithm>

#include "batch.hpp"
#include "shell_strains.hpp"

namespace sundrape::shell {

/// Modes from four positions and four directors of length ℓ.
inline Modes modes_of(const std::array<Batch3, 4>& x, const std::array<Batch3, 4>& t, double director_length) {
  const Batch quarter(0.25), share(0.25 / director_length);
  const Batch3 x20 = x[2] - x[0], x13 = x[1] - x[3], t20 = t[2] - t[0], t13 = t[1] - t[3];
  const Batch3 t02 = t[0] + t[2], t31 = t[1] + t[3];
  Modes q;
  q[a] = quarter * (x20 + x13);
  q[c] = quarter * (x20 - x13);
  q[b] = quarter * (x[0] + x[2] - x[1] - x[3]);
  q[d] = share * (t02 + t31);
  q[db] = share * (t02 - t31);
  q[da] = share * (t20 + t13);
  q[dc] = share * (t20 - t13);
  return q;
}

/// What four nodes get from  mean + by_xi ξ + by_both ξη + by_eta η, as vectors or as blocks.
template <class V>
std::array<V, 4> at_nodes(const V& by_xi, const V& by_both, const V& by_eta, const V& mean) {
  const V even = mean + by_both, odd = mean - by_both, sum = by_xi + by_eta, difference = by_xi - by_eta;
  return {even - sum, odd + difference, even + sum, odd - difference};
}
template <class V>
std::array<V, 4> at_nodes(const V& by_xi, const V& by_both, const V& by_eta) {
  const V sum = by_xi + by_eta, difference = by_xi - by_eta;
  return {by_both - sum, difference - by_both, by_both + sum, -by_both - difference};
}

/// Forces on the four nodes, then on the four directors.
inline std::array<Batch3, 8> nodal_forces(const Modes& f, double director_length) {
  const auto x = at_nodes<Batch3>(f[a], f[b], f[c]);
  const auto t = at_nodes<Batch3>(f[da], f[db], f[dc], f[d]);
  std::array<Batch3, 8> nodal;
  for (std::size_t k = 0; k < 4; ++k) {
    nodal[k] = Batch(0.25) * x[k];
    nodal[4 + k] = Batch(0.25 / director_length) * t[k];
  }
  return nodal;
}

/// Adds −h, known for m ≤ n, to the slots of `count` elements from e on.
inline void add_symmetric_blocks(const Blocks& h, double director_length, std::size_t e, std::size_t count,
                                 Assembler& tangent) {
  const Batch xx(-0.0625), xt(-0.0625 / director_length), tt(-0.0625 / (director_length * director_length));
  const auto block = [&](Mode m, Mode n) -> Batch3x3 { return m <= n ? h[m][n] : Batch3x3(h[n][m].transpose()); };
  LaneMatrices<36> nodal;  // (q, p) of p ≤ q, at pairs(q) + p
  const auto place = [](std::size_t p, std::size_t q) { return q * (q + 1) / 2 + p; };
  {
    std::array<std::array<Batch3x3, 4>, 3> half;  // modes of x by nodes of x
    for (std::size_t i = 0; i < 3; ++i) {
      const auto m = std::array{a, b, c}[i];
      half[i] = at_nodes<Batch3x3>(block(m, a), block(m, b), block(m, c));
    }
    for (std::size_t p = 0; p < 4; ++p) {
      const auto column = at_nodes<Batch3x3>(half[0][p], half[1][p], half[2][p]);
      for (std::size_t q = p; q < 4; ++q) nodal.store(place(p, q), xx * column[q]);
    }
  }
  {
    std::array<std::array<Batch3x3, 4>, 4> half;  // modes of t by nodes of x
    for (std::size_t i = 0; i < 4; ++i) {
      const auto m = std::array{da, db, dc, d}[i];
      half[i] = at_nodes<Batch3x3>(block(m, a), block(m, b), block(m, c));
    }
    for (std::size_t p = 0; p < 4; ++p) {
      const auto column = at_nodes<Batch3x3>(half[0][p], half[1][p], half[2][p], half[3][p]);
      for (std::size_t q = 0; q < 4; ++q) nodal.store(place(p, 4 + q), xt * column[q]);
    }
    for (std::size_t i = 0; i < 4; ++i) {
      const auto m = std::array{da, db, dc, d}[i];
      half[i] = at_nodes<Batch3x3>(block(m, da), block(m, db), block(m, dc), block(m, d));
    }
    for (std::size_t p = 0; p < 4; ++p) {
      const auto column = at_nodes<Batch3x3>(half[0][p], half[1][p], half[2][p], half[3][p]);
      for (std::size_t q = p; q < 4; ++q) nodal.store(place(4 + p, 4 + q), tt * column[q]);
    }
  }
  for (std::size_t lane = 0; lane < count; ++lane)
    for (std::size_t q = 0; q < 8; ++q) {
      for (std::size_t p = 0; p < q; ++p)
        tangent.add_pair_below(e + lane, static_cast<int>(p), static_cast<int>(q), nodal(place(p, q), lane));
      tangent.add_diagonal(e + lane, static_cast<int>(q), nodal(place(q, q), lane));
    }
}

/// Adds −h, known in full, to a matrix that keeps unsymmetric blocks.
inline void add_general_blocks(const Blocks& h, double director_length, std::size_t e, std::size_t count,
                               Assembler& tangent) {
  constexpr std::array<Mode, 7> rows{a, b, c, da, db, dc, d};
  std::array<std::array<Batch3x3, 8>, 7> half;  // modes by nodes and directors
  for (std::size_t i = 0; i < 7; ++i) {
    const auto& row = h[rows[i]];
    std::ranges::copy(at_nodes<Batch3x3>(row[a], row[b], row[c]), half[i].begin());
    std::ranges::copy(at_nodes<Batch3x3>(row[da], row[db], row[dc], row[d]), half[i].begin() + 4);
  }
  LaneMatrices<64> nodal;  // (q, p) at 8q + p
  for (std::size_t p = 0; p < 8; ++p) {
    const double of_column = -0.0625 / (p < 4 ? 1 : director_length);
    const auto x = at_nodes<Batch3x3>(half[0][p], half[1][p], half[2][p]);
    const auto t = at_nodes<Batch3x3>(half[3][p], half[4][p], half[5][p], half[6][p]);
    for (std::size_t q = 0; q < 4; ++q) {
      nodal.store(8 * q + p, Batch(of_column) * x[q]);
      nodal.store(8 * (4 + q) + p, Batch(of_column / director_length) * t[q]);
    }
  }
  for (std::size_t lane = 0; lane < count; ++lane)
    for (std::size_t q = 0; q < 8; ++q) {
      for (std::size_t p = 0; p < q; ++p)
        tangent.add_general_pair(e + lane, static_cast<int>(p), static_cast<int>(q), nodal(8 * p + q, lane),
                                 nodal(8 * q + p, lane));
      tangent.add_diagonal(e + lane, static_cast<int>(q), nodal(8 * q + q, lane));
    }
}

}  // namespace sundrape::shell
