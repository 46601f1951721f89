#include "sundrape/material/fabric.hpp"

#include <cmath>
#include <stdexcept>

namespace sundrape {
namespace {

bool is_positive(double x) { return std::isfinite(x) && x > 0; }

}  // namespace

Fabric isotropic_fabric(double youngs_modulus, double poisson, double thickness, double area_density) {
  if (!is_positive(youngs_modulus)) throw std::invalid_argument("Young's modulus must be positive [Pa]");
  if (!(poisson >= 0 && poisson < 0.5)) throw std::invalid_argument("Poisson's ratio must lie in [0, 0.5)");
  if (!is_positive(thickness)) throw std::invalid_argument("the thickness must be positive [m]");
  if (!is_positive(area_density)) throw std::invalid_argument("the mass per area must be positive [kg/m²]");

  Fabric fabric;
  fabric.thickness = thickness;
  fabric.area_density = area_density;
  fabric.poisson = poisson;
  fabric.warp_membrane = fabric.weft_membrane = youngs_modulus * thickness;                        // (38)
  fabric.shear_membrane = youngs_modulus * thickness / (2 * (1 + poisson));                        // (40)
  fabric.warp_bending = youngs_modulus * std::pow(thickness, 3) / (12 * (1 - poisson * poisson));  // (45), (46)
  fabric.weft_bending = fabric.warp_bending;
  fabric.bending_coupling = poisson * fabric.warp_bending;
  fabric.twist_bending = 0.5 * (1 - poisson) * fabric.warp_bending;
  fabric.transverse_shear = fabric.shear_membrane;  // (24)
  return fabric;
}

PlateBending plate_bending(const Fabric& fabric) {
  if (const auto& m = fabric.measured_bending) return {m->form, m->warp, m->weft, fabric.poisson};
  Eigen::Matrix3d rigidity =
      Eigen::Vector3d(fabric.warp_bending, fabric.weft_bending, fabric.twist_bending).asDiagonal();
  rigidity(0, 1) = rigidity(1, 0) = fabric.bending_coupling;
  return PlateBending(rigidity);
}

Eigen::Matrix3d membrane_stiffness(const Fabric& fabric) {
  const double ratio = fabric.weft_membrane / fabric.warp_membrane;
  const double plate = 1 / (1 - fabric.poisson * fabric.poisson * ratio);
  Eigen::Matrix3d c =
      Eigen::Vector3d(plate * fabric.warp_membrane, plate * fabric.weft_membrane, fabric.shear_membrane).asDiagonal();
  c(0, 1) = c(1, 0) = fabric.poisson * c(1, 1);
  return c;
}

}  // namespace sundrape
