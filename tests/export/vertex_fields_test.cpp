#include "sundrape/export/vertex_fields.hpp"

#include <cmath>

#include <Eigen/Geometry>
#include <Eigen/SVD>
#include <gtest/gtest.h>

#include "sundrape/mesh/builders.hpp"

namespace sundrape {
namespace {

TEST(VertexFields, StrainOfAHomogeneousDeformationIsItsLargestStretch) {
  const auto mesh = rectangle(0.3, 0.2, 12, 8);
  Matrix3 deformation;
  deformation << 1.02, 0.05, 0, 0.01, 0.97, 0, 0.1, 0.2, 1;
  auto positions = mesh.reference;
  for (auto& x : positions) x = deformation * x;
  const Eigen::Matrix<double, 3, 2> of_sheet = deformation.leftCols<2>();
  const double largest = of_sheet.jacobiSvd().singularValues()[0];
  for (const auto kind : {StrainOf::sides_and_diagonals, StrainOf::centre}) {
    const Vector strain = principal_strains(mesh, positions, kind);
    EXPECT_LT((strain.array() - (largest - 1)).abs().maxCoeff(), 1e-13);
  }
}

TEST(VertexFields, CurvatureOfACylinderIsOneOverItsRadius) {
  const auto mesh = rectangle(0.3, 0.2, 24, 8);
  const double radius = 0.1;
  auto positions = mesh.reference;
  for (auto& x : positions) x = {radius * std::sin(x.x() / radius), x.y(), radius * (1 - std::cos(x.x() / radius))};
  const Vector curvature = principal_curvatures(mesh, positions, node_normals(mesh, positions));
  const double step = 0.3 / 24 / radius;
  for (int row = 0; row <= 8; ++row)  // at the edge the normal is one-sided
    for (int column = 2; column <= 22; ++column) EXPECT_NEAR(curvature[25 * row + column] * radius, 1, step * step / 4);
}

TEST(VertexFields, AreFiniteWhereTheSheetHasCollapsed) {
  const auto mesh = rectangle(0.3, 0.2, 3, 2);
  const std::vector<Vector3> positions(mesh.reference.size(), Vector3::Zero());
  const auto normals = node_normals(mesh, positions);
  EXPECT_TRUE(principal_strains(mesh, positions, StrainOf::centre).allFinite());
  EXPECT_TRUE(principal_curvatures(mesh, positions, normals).allFinite());
}

}  // namespace
}  // namespace sundrape
