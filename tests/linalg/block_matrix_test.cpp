#include "sundrape/linalg/block_matrix.hpp"

#include <algorithm>
#include <numeric>
#include <random>
#include <stdexcept>

#include <gtest/gtest.h>

#include "support/model_matrices.hpp"

namespace sundrape {
namespace {

/// Random elements of four of 30 points, some of them fixed, the unknowns numbered at random.
struct RandomElements {
  std::vector<int> unknown_of_point;
  std::vector<std::array<int, 4>> elements;
  std::vector<std::array<std::array<Matrix3, 4>, 4>> blocks;  // by element, p, q
  int rows = 0;

  explicit RandomElements(unsigned seed) : unknown_of_point(30, -1) {
    std::mt19937 generator(seed);
    std::uniform_real_distribution<double> uniform(-1, 1);
    std::vector<int> points(unknown_of_point.size());
    std::iota(points.begin(), points.end(), 0);
    std::ranges::shuffle(points, generator);
    for (const int point : points)
      if (point % 5 != 0) unknown_of_point[static_cast<std::size_t>(point)] = rows++;
    for (int e = 0; e < 40; ++e) {
      std::ranges::shuffle(points, generator);
      elements.push_back({points[0], points[1], points[2], e % 3 == 0 ? -1 : points[3]});
      auto& of_element = blocks.emplace_back();
      for (auto& row : of_element)
        for (auto& block : row) block = Matrix3::NullaryExpr([&] { return uniform(generator); });
    }
  }

  [[nodiscard]] int unknown(std::size_t element, std::size_t p) const {
    const int point = elements[element][p];
    return point < 0 ? -1 : unknown_of_point[static_cast<std::size_t>(point)];
  }

  [[nodiscard]] Pattern::Built build() const {
    Pattern pattern(unknown_of_point);
    pattern.begin_term(4);
    for (const auto& element : elements) pattern.add_element(element);
    return pattern.build();
  }

  /// All 4 × 4 blocks of each element added where they belong, without any of the machinery under test.
  [[nodiscard]] Eigen::MatrixXd dense() const {
    Eigen::MatrixXd all = Eigen::MatrixXd::Zero(3 * rows, 3 * rows);
    for (std::size_t e = 0; e < elements.size(); ++e)
      for (std::size_t p = 0; p < 4; ++p)
        for (std::size_t q = 0; q < 4; ++q)
          if (unknown(e, p) >= 0 && unknown(e, q) >= 0)
            all.block<3, 3>(3 * unknown(e, p), 3 * unknown(e, q)) += blocks[e][p][q];
    return all;
  }
};

void add_general(const RandomElements& random, Assembler assembler) {
  for (std::size_t e = 0; e < random.elements.size(); ++e)
    for (std::size_t q = 0; q < 4; ++q) {
      assembler.add_diagonal(e, static_cast<int>(q), random.blocks[e][q][q]);
      for (std::size_t p = 0; p < q; ++p)
        assembler.add_general_pair(e, static_cast<int>(p), static_cast<int>(q), random.blocks[e][p][q],
                                   random.blocks[e][q][p]);
    }
}

TEST(Assembler, AddsGeneralElementsAsADenseAssemblyDoes) {
  const RandomElements random(1);
  const auto built = random.build();
  BlockMatrix matrix(built.structure, Symmetry::unsymmetric);
  add_general(random, Assembler(matrix, built.tables[0]));
  EXPECT_LT((matrix.dense() - random.dense()).cwiseAbs().maxCoeff(), 1e-14);
}

TEST(Assembler, GivesASymmetricMatrixTheSymmetricPart) {
  const RandomElements random(2);
  const auto built = random.build();
  BlockMatrix matrix(built.structure, Symmetry::symmetric);
  add_general(random, Assembler(matrix, built.tables[0]));
  const Eigen::MatrixXd expected = 0.5 * (random.dense() + random.dense().transpose());
  EXPECT_LT((matrix.dense() - expected).cwiseAbs().maxCoeff(), 1e-14);
}

TEST(Assembler, AddsAPairAndItsTransposeToEitherKindOfMatrix) {
  RandomElements random(3);
  for (auto& element : random.blocks)
    for (std::size_t q = 0; q < 4; ++q)
      for (std::size_t p = 0; p <= q; ++p) element[q][p] = element[p][q].transpose().eval();
  const auto built = random.build();
  for (const auto symmetry : {Symmetry::symmetric, Symmetry::unsymmetric}) {
    BlockMatrix matrix(built.structure, symmetry);
    Assembler assembler(matrix, built.tables[0]);
    for (std::size_t e = 0; e < random.elements.size(); ++e)
      for (int q = 0; q < 4; ++q)
        for (int p = 0; p < q; ++p)
          assembler.add_pair(e, p, q, random.blocks[e][static_cast<std::size_t>(p)][static_cast<std::size_t>(q)]);
    Eigen::MatrixXd expected = random.dense();
    for (int i = 0; i < random.rows; ++i) expected.block<3, 3>(3 * i, 3 * i).setZero();
    EXPECT_LT((matrix.dense() - expected).cwiseAbs().maxCoeff(), 1e-14);
    EXPECT_EQ(matrix.asymmetry(), 0);
  }
}

class EitherSymmetry : public testing::TestWithParam<Symmetry> {};
INSTANTIATE_TEST_SUITE_P(BlockMatrix, EitherSymmetry, testing::Values(Symmetry::symmetric, Symmetry::unsymmetric),
                         [](const auto& info) {
                           return info.param == Symmetry::symmetric ? "symmetric" : "unsymmetric";
                         });

TEST_P(EitherSymmetry, MultipliesAsTheDenseMatrixDoes) {
  const RandomElements random(4);
  const auto built = random.build();
  BlockMatrix matrix(built.structure, GetParam());
  add_general(random, Assembler(matrix, built.tables[0]));
  const Vector x = random_vector(3 * random.rows, 5);
  Vector y = Vector::Constant(x.size(), 1e9);  // what was in y before must not matter
  matrix.multiply(x, y);
  EXPECT_LT((y - matrix.dense() * x).cwiseAbs().maxCoeff(), 1e-13);
}

TEST_P(EitherSymmetry, MultipliesManyColumnsAsOneByOne) {
  const RandomElements random(4);
  const auto built = random.build();
  BlockMatrix matrix(built.structure, GetParam());
  add_general(random, Assembler(matrix, built.tables[0]));
  for (Eigen::Index m = 0; m <= 6; ++m) {
    const Eigen::MatrixXd x = random_vector(3 * random.rows * static_cast<int>(m), 6).reshaped(3 * random.rows, m);
    Eigen::MatrixXd y = Eigen::MatrixXd::Constant(2, 1, 1e9);
    matrix.multiply_all(x, y);
    EXPECT_EQ(y.cols(), m);
    EXPECT_TRUE(y.isApprox(matrix.dense() * x, 1e-13)) << m;
  }
}

TEST_P(EitherSymmetry, HoldingAComponentDecouplesIt) {
  const RandomElements random(6);
  const auto built = random.build();
  BlockMatrix matrix(built.structure, GetParam());
  add_general(random, Assembler(matrix, built.tables[0]));
  auto expected = matrix.dense();
  for (const auto& [row, component] : {std::pair{0, 1}, {11, 2}, {11, 0}, {random.rows - 1, 2}}) {
    matrix.hold(row, component, 7.0);
    expected.row(3 * row + component).setZero();
    expected.col(3 * row + component).setZero();
    expected(3 * row + component, 3 * row + component) = 7.0;
  }
  EXPECT_LT((matrix.dense() - expected).cwiseAbs().maxCoeff(), 1e-14);
}

TEST_P(EitherSymmetry, AddsAMassToAllThreeDirections) {
  const RandomElements random(7);
  const auto built = random.build();
  BlockMatrix matrix(built.structure, GetParam());
  const Vector mass = random_vector(random.rows, 8);
  matrix.add_diagonal(mass, 2.0);
  for (int i = 0; i < random.rows; ++i) EXPECT_EQ(matrix.diagonal(i), (2.0 * mass[i] * Matrix3::Identity()).eval());
  matrix.set_zero();
  EXPECT_EQ(matrix.dense().norm(), 0);
  EXPECT_THROW(matrix.add_diagonal(Vector::Ones(random.rows + 1), 1.0), std::invalid_argument);
}

TEST(BlockMatrix, AsymmetryIsTheLargestDifferenceOverTheLargestEntry) {
  const RandomElements random(9);
  const auto built = random.build();
  BlockMatrix matrix(built.structure, Symmetry::unsymmetric);
  add_general(random, Assembler(matrix, built.tables[0]));
  const auto dense = random.dense();
  EXPECT_NEAR(matrix.asymmetry(), (dense - dense.transpose()).cwiseAbs().maxCoeff() / dense.cwiseAbs().maxCoeff(),
              1e-14);
}

}  // namespace
}  // namespace sundrape
