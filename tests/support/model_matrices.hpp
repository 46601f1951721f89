#pragma once
#include <array>
#include <cmath>
#include <memory>
#include <random>
#include <vector>

#include "sundrape/linalg/block_matrix.hpp"

namespace sundrape {

/// A matrix together with the structure that it refers to.
struct ModelMatrix {
  std::unique_ptr<BlockStructure> structure;
  std::unique_ptr<BlockMatrix> matrix;
};

/// Random symmetric positive definite matrix: a chain with extra couplings, Σ Gᵀ G over random elements + diagonal.
/// Unsymmetric ones get a random skew part on top.
inline ModelMatrix random_matrix(int rows, Symmetry symmetry, unsigned seed) {
  std::mt19937 generator(seed);
  std::uniform_int_distribution<int> any_row(0, rows - 1);
  std::uniform_real_distribution<double> uniform(-1, 1);
  const auto random_block = [&]() -> Matrix3 { return Matrix3::NullaryExpr([&] { return uniform(generator); }); };

  std::vector<int> unknowns(static_cast<std::size_t>(rows));
  for (int i = 0; i < rows; ++i) unknowns[static_cast<std::size_t>(i)] = i;
  std::vector<std::array<int, 2>> elements;
  for (int i = 1; i < rows; ++i) elements.push_back({i, i - 1});
  for (int k = 0; k < rows; ++k)
    if (const int i = any_row(generator), j = any_row(generator); i != j) elements.push_back({i, j});
  Pattern pattern(unknowns);
  pattern.begin_term(2);
  for (const auto& element : elements) pattern.add_element(element);
  auto built = pattern.build();

  ModelMatrix model{std::make_unique<BlockStructure>(std::move(built.structure)), nullptr};
  model.matrix = std::make_unique<BlockMatrix>(*model.structure, symmetry);
  Assembler assembler(*model.matrix, built.tables.front());
  for (std::size_t e = 0; e < elements.size(); ++e) {
    const Matrix3 g = random_block();
    const Matrix3 h = random_block();
    assembler.add_diagonal(e, 0, g.transpose() * g);
    assembler.add_diagonal(e, 1, h.transpose() * h);
    const Matrix3 pair = g.transpose() * h;
    if (symmetry == Symmetry::symmetric) {
      assembler.add_pair(e, 0, 1, pair);
    } else {
      const Matrix3 skew = random_block();
      assembler.add_general_pair(e, 0, 1, pair + skew, pair.transpose() - skew.transpose());
    }
  }
  model.matrix->add_diagonal(Vector::Constant(rows, 0.1), 1.0);
  return model;
}

/// The condensed matrix c²M + (1 + cβ)K of a square net of a cotton tablecloth (20 cm; E h = 628 N/m, 0.238 kg/m²,
/// bending as of a 0.54 mm plate), draped over a smooth hump so that no direction is special.
struct NetModel {
  int nodes_per_side = 21;
  double rate = 600;      // c [1/s]
  double damping = 1e-3;  // β [s]
  double tension = 0;     // of the membrane springs, over E h; negative ones make the matrix indefinite
  Symmetry symmetry = Symmetry::symmetric;
};

inline ModelMatrix net_matrix(const NetModel& net) {
  constexpr double length = 0.2, membrane = 628, density = 0.238, thickness = 0.54e-3, poisson = 0.3;
  const int n = net.nodes_per_side;
  const double side = length / (n - 1);
  const double bending = membrane * thickness * thickness / 12 / (1 - poisson * poisson) / (side * side);
  const double shear = membrane / (2 * (1 + poisson));
  const auto node = [n](int i, int j) { return i + n * j; };
  const auto position = [&](int k) {
    const int column = k % n, row = k / n;
    const double x = side * column, y = side * row;
    return Vector3(x, y, 0.06 * std::cos(9 * x + 2 * y) * std::sin(5 * x - 7 * y));
  };

  std::vector<int> unknowns(static_cast<std::size_t>(n) * static_cast<std::size_t>(n));
  for (std::size_t k = 0; k < unknowns.size(); ++k) unknowns[k] = static_cast<int>(k);
  std::vector<std::array<int, 2>> threads, diagonals;
  std::vector<std::array<int, 3>> bends;
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      if (i + 1 < n) threads.push_back({node(i, j), node(i + 1, j)});
      if (j + 1 < n) threads.push_back({node(i, j), node(i, j + 1)});
      if (i + 1 < n && j + 1 < n) {
        diagonals.push_back({node(i, j), node(i + 1, j + 1)});
        diagonals.push_back({node(i + 1, j), node(i, j + 1)});
      }
      if (i + 2 < n) bends.push_back({node(i, j), node(i + 1, j), node(i + 2, j)});
      if (j + 2 < n) bends.push_back({node(i, j), node(i, j + 1), node(i, j + 2)});
    }

  Pattern pattern(unknowns);
  pattern.begin_term(2);
  for (const auto& e : threads) pattern.add_element(e);
  pattern.begin_term(2);
  for (const auto& e : diagonals) pattern.add_element(e);
  pattern.begin_term(3);
  for (const auto& e : bends) pattern.add_element(e);
  auto built = pattern.build();

  ModelMatrix model{std::make_unique<BlockStructure>(std::move(built.structure)), nullptr};
  model.matrix = std::make_unique<BlockMatrix>(*model.structure, net.symmetry);
  const double factor = 1 + net.rate * net.damping;
  const auto add_springs = [&](const auto& springs, const SlotTable& table, double stiffness) {
    Assembler assembler(*model.matrix, table);
    for (std::size_t e = 0; e < springs.size(); ++e) {
      const Vector3 d = (position(springs[e][1]) - position(springs[e][0])).normalized();
      const Matrix3 along = d * d.transpose();
      const Matrix3 block = factor * stiffness * (along + net.tension * (Matrix3::Identity() - along));
      assembler.add_diagonal(e, 0, block);
      assembler.add_diagonal(e, 1, block);
      assembler.add_pair(e, 0, 1, -block);
    }
  };
  add_springs(threads, built.tables[0], membrane);
  add_springs(diagonals, built.tables[1], shear);
  Assembler assembler(*model.matrix, built.tables[2]);
  constexpr std::array<double, 3> difference{1, -2, 1};
  for (std::size_t e = 0; e < bends.size(); ++e)
    for (int q = 0; q < 3; ++q)
      for (int p = 0; p <= q; ++p) {
        const Matrix3 block = factor * bending * difference[static_cast<std::size_t>(p)] *
                              difference[static_cast<std::size_t>(q)] * Matrix3::Identity();
        if (p == q)
          assembler.add_diagonal(e, p, block);
        else
          assembler.add_pair(e, p, q, block);
      }
  model.matrix->add_diagonal(Vector::Constant(n * n, density * side * side), net.rate * net.rate);
  return model;
  // The model owns both; the analyser does not see the move.
}  // NOLINT(clang-analyzer-cplusplus.NewDeleteLeaks)

/// A right side with all wave lengths in it.
inline Vector random_vector(Eigen::Index size, unsigned seed) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  return Vector::NullaryExpr(size, [&] { return uniform(generator); });
}

}  // namespace sundrape
