#include "sundrape/linalg/padded_matrix.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

#include "support/model_matrices.hpp"

namespace sundrape {
namespace {

TEST(PaddedMatrix, MultipliesAsTheDoubleMatrixDoesToSinglePrecision) {
  auto model = random_matrix(50, Symmetry::symmetric, 1);
  model.matrix->lower(model.structure->diagonal(3))(0, 2) += 0.2;  // the symmetric part counts
  PaddedMatrix padded(*model.structure);
  padded.copy(*model.matrix);
  EXPECT_EQ(padded.scale(), model.matrix->dense().diagonal().maxCoeff());

  const Vector x = random_vector(150, 2);
  PaddedVector padded_x(200);
  PaddedVector padded_y(200);
  pad(x, 2.0, padded_x);
  padded.multiply(padded_x, padded_y);
  Vector y(150);
  unpad(padded_y, 0.5 * padded.scale(), y);
  const Vector expected = model.matrix->dense() * x;
  EXPECT_LT((y - expected).norm(), 1e-6 * expected.norm());
  for (int i = 0; i < 50; ++i) EXPECT_EQ(padded_y[4 * i + 3], 0.0F);
}

TEST(PaddedMatrix, MultipliesSeveralVectorsSideBySideAsOneByOne) {
  const auto model = random_matrix(50, Symmetry::symmetric, 1);
  PaddedMatrix padded(*model.structure);
  padded.copy(*model.matrix);
  for (Eigen::Index m = 1; m <= PaddedMatrix::together; ++m) {
    PaddedVector x(200 * m), y(200 * m), one(200), expected(200);
    for (Eigen::Index v = 0; v < m; ++v) {
      pad(random_vector(150, static_cast<unsigned>(v)), 1.0, one);
      for (Eigen::Index i = 0; i < 50; ++i) x.segment<4>(4 * (m * i + v)) = one.segment<4>(4 * i);
    }
    padded.multiply_together(x, y);
    for (Eigen::Index v = 0; v < m; ++v) {
      for (Eigen::Index i = 0; i < 50; ++i) one.segment<4>(4 * i) = x.segment<4>(4 * (m * i + v));
      padded.multiply(one, expected);
      for (Eigen::Index i = 0; i < 50; ++i) one.segment<4>(4 * i) = y.segment<4>(4 * (m * i + v));
      EXPECT_LT((one - expected).norm(), 1e-6F * expected.norm()) << v << " of " << m;
    }
  }
}

TEST(PaddedMatrix, RefusesUnsymmetricMatrices) {
  const auto model = random_matrix(5, Symmetry::unsymmetric, 1);
  PaddedMatrix padded(*model.structure);
  EXPECT_THROW(padded.copy(*model.matrix), std::invalid_argument);
}

}  // namespace
}  // namespace sundrape
