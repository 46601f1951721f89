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
  return fabric;
}

}  // namespace sundrape
