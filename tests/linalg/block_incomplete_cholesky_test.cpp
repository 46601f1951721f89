#include "sundrape/linalg/block_incomplete_cholesky.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

#include "support/model_matrices.hpp"

namespace sundrape {
namespace {

Vector applied(const Preconditioner& preconditioner, const Vector& r) {
  PaddedVector padded(r.size() / 3 * 4);
  pad(r, 1, padded);
  preconditioner.apply(padded, padded);  // in place
  Vector z(r.size());
  unpad(padded, 1, z);
  return z;
}

/// z = scale · (preconditioner)⁻¹ r for the unscaled matrix.
struct Built {
  PaddedMatrix padded;
  BlockIncompleteCholesky preconditioner;
  bool ok;

  Built(const ModelMatrix& model, double modification) : padded(*model.structure), preconditioner(modification) {
    padded.copy(*model.matrix);
    preconditioner.analyse(*model.structure);
    ok = preconditioner.build(padded);
  }
};

TEST(BlockIncompleteCholesky, IsTheInverseWhereNoFillIsDropped) {
  // a chain: its factor has no fill, whatever the modification
  std::vector<int> unknowns(20);
  for (int i = 0; i < 20; ++i) unknowns[static_cast<std::size_t>(i)] = i;
  Pattern pattern(unknowns);
  pattern.begin_term(2);
  for (int i = 1; i < 20; ++i) pattern.add_element(std::array{i, i - 1});
  auto built = pattern.build();
  ModelMatrix chain{std::make_unique<BlockStructure>(built.structure), nullptr};
  chain.matrix = std::make_unique<BlockMatrix>(*chain.structure, Symmetry::symmetric);
  Assembler assembler(*chain.matrix, built.tables[0]);
  for (std::size_t e = 0; e < 19; ++e) {
    const Matrix3 g = Eigen::Map<const Matrix3>(random_vector(9, static_cast<unsigned>(e)).data());
    assembler.add_diagonal(e, 0, g * g.transpose());
    assembler.add_diagonal(e, 1, Matrix3::Identity());
    assembler.add_pair(e, 0, 1, g);
  }
  chain.matrix->add_diagonal(Vector::Ones(20), 0.3);
  const Built preconditioner(chain, 0.95);
  ASSERT_TRUE(preconditioner.ok);
  EXPECT_EQ(preconditioner.preconditioner.shift(), 0);
  const Vector x = random_vector(60, 3);
  const Vector r = chain.matrix->dense() * x / preconditioner.padded.scale();
  EXPECT_LT((applied(preconditioner.preconditioner, r) - x).norm(), 1e-5 * x.norm());
}

TEST(BlockIncompleteCholesky, AppliesToSeveralVectorsSideBySideAsOneByOne) {
  const auto net = net_matrix({.nodes_per_side = 15});
  const Built built(net, 0.95);
  ASSERT_TRUE(built.ok);
  for (Eigen::Index m = 1; m <= PaddedMatrix::together; ++m) {
    std::vector<Vector> vectors;
    PaddedVector all(900 * m), one(900);
    for (Eigen::Index v = 0; v < m; ++v) {
      vectors.push_back(random_vector(675, static_cast<unsigned>(v)));
      pad(vectors.back(), 1, one);
      for (Eigen::Index i = 0; i < 225; ++i) all.segment<4>(4 * (m * i + v)) = one.segment<4>(4 * i);
    }
    built.preconditioner.apply_together(all, all);
    for (Eigen::Index v = 0; v < m; ++v) {
      for (Eigen::Index i = 0; i < 225; ++i) one.segment<4>(4 * i) = all.segment<4>(4 * (m * i + v));
      Vector z(675);
      unpad(one, 1, z);
      const Vector expected = applied(built.preconditioner, vectors[static_cast<std::size_t>(v)]);
      EXPECT_LT((z - expected).norm(), 1e-5 * expected.norm()) << v << " of " << m;
    }
  }
}

TEST(BlockIncompleteCholesky, IsSymmetricAndPositiveDefinite) {
  const auto net = net_matrix({.nodes_per_side = 15});
  const Built preconditioner(net, 0.95);
  ASSERT_TRUE(preconditioner.ok);
  for (const unsigned seed : {1U, 2U, 3U}) {
    const Vector a = random_vector(675, seed);
    const Vector b = random_vector(675, seed + 100);
    const Vector ma = applied(preconditioner.preconditioner, a);
    const Vector mb = applied(preconditioner.preconditioner, b);
    EXPECT_GT(a.dot(ma), 0);
    EXPECT_NEAR(a.dot(mb), b.dot(ma), 1e-5 * std::sqrt(a.dot(ma) * b.dot(mb)));
  }
}

// (I + L) D (I + Lᵀ) s = A s for s = (1, 1, …) when all dropped fill stays in its row: Gustafsson's property. On a net
// whose blocks commute the symmetric mean does not disturb it.
TEST(BlockIncompleteCholesky, FullModificationKeepsRowSums) {
  const int n = 9;
  auto net = net_matrix({.nodes_per_side = n});
  for (std::int64_t k = 0; k < net.structure->blocks(); ++k) {
    const double mean = net.matrix->lower(k).trace() / 3;
    net.matrix->lower(k) = mean * Matrix3::Identity();
  }
  const Built preconditioner(net, 1.0);
  ASSERT_TRUE(preconditioner.ok);
  ASSERT_EQ(preconditioner.preconditioner.shift(), 0);
  const Vector ones = Vector::Ones(3 * n * n);
  const Vector r = net.matrix->dense() * ones / preconditioner.padded.scale();
  EXPECT_LT((applied(preconditioner.preconditioner, r) - ones).cwiseAbs().maxCoeff(), 1e-3);
}

TEST(BlockIncompleteCholesky, ShiftsAnIndefiniteMatrixAndForgetsTheShiftAfterwards) {
  const auto good = net_matrix({.nodes_per_side = 15});
  auto bad = net_matrix({.nodes_per_side = 15});
  bad.matrix->add_diagonal(Vector::Ones(225), -50.0);
  PaddedMatrix padded(*good.structure);
  BlockIncompleteCholesky preconditioner;
  preconditioner.analyse(*good.structure);
  padded.copy(*bad.matrix);
  ASSERT_TRUE(preconditioner.build(padded));
  const double first = preconditioner.shift();
  EXPECT_GT(first, 0);
  padded.copy(*good.matrix);
  ASSERT_TRUE(preconditioner.build(padded));
  EXPECT_EQ(preconditioner.shift(), 0.5 * first);
  for (int k = 0; k < 12; ++k) ASSERT_TRUE(preconditioner.build(padded));
  EXPECT_EQ(preconditioner.shift(), 0);
}

TEST(BlockIncompleteCholesky, GivesUpOnANegativeDefiniteMatrix) {
  auto net = net_matrix({.nodes_per_side = 5});
  net.matrix->set_zero();
  net.matrix->add_diagonal(Vector::Ones(25), std::numeric_limits<double>::quiet_NaN());
  EXPECT_FALSE(Built(net, 0.95).ok);
}

TEST(BlockIncompleteCholesky, RefusesAModificationOutOfRange) {
  EXPECT_THROW(BlockIncompleteCholesky(1.1), std::invalid_argument);
  EXPECT_THROW(BlockIncompleteCholesky(-0.1), std::invalid_argument);
}

}  // namespace
}  // namespace sundrape
