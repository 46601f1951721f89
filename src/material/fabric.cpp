#include "sundrape/material/fabric.hpp"

#include <cmath>
#include <stdexcept>

namespace sundrape {
namespace {

bool is_positive(double x) { return std::isfinite(x) && x > 0; }

/// What both kinds of fabric have.
Fabric sheet(double poisson, double thickness, double area_density) {
  if (!(poisson >= 0 && poisson < 0.5)) throw std::invalid_argument("Poisson's ratio must lie in [0, 0.5)");
  if (!is_positive(thickness)) throw std::invalid_argument("the thickness must be positive [m]");
  if (!is_positive(area_density)) throw std::invalid_argument("the mass per area must be positive [kg/m²]");
  Fabric fabric;
  fabric.thickness = thickness;
  fabric.area_density = area_density;
  fabric.poisson = poisson;
  return fabric;
}

/// ν₁₂ ν₂₁ of moduli or rigidities.
double coupling(double poisson, double warp, double weft) {
  const double product = poisson * poisson * weft / warp;
  if (!(product < 1)) throw std::invalid_argument("no elastic sheet has this Poisson's ratio: ν₁₂ ν₂₁ must be below 1");
  return product;
}

/// The shear stiffness that goes with two others where it is not measured: E/(2 (1 + ν)) in the isotropic case.
double shear_between(double warp, double weft, double product) {
  return std::sqrt(warp * weft) / (2 * (1 + std::sqrt(product)));
}

}  // namespace

Fabric isotropic_fabric(double youngs_modulus, double poisson, double thickness, double area_density) {
  if (!is_positive(youngs_modulus)) throw std::invalid_argument("Young's modulus must be positive [Pa]");
  Fabric fabric = sheet(poisson, thickness, area_density);
  fabric.warp_membrane = fabric.weft_membrane = youngs_modulus * thickness;                        // (38)
  fabric.shear_membrane = youngs_modulus * thickness / (2 * (1 + poisson));                        // (40)
  fabric.warp_bending = youngs_modulus * std::pow(thickness, 3) / (12 * (1 - poisson * poisson));  // (45), (46)
  fabric.weft_bending = fabric.warp_bending;
  fabric.bending_coupling = poisson * fabric.warp_bending;
  fabric.twist_bending = 0.5 * (1 - poisson) * fabric.warp_bending;
  fabric.transverse_shear = fabric.shear_membrane;  // (24)
  return fabric;
}

Fabric orthotropic_fabric(double warp_modulus, double weft_modulus, double shear_modulus, double poisson,
                          double thickness, double area_density) {
  if (!is_positive(warp_modulus) || !is_positive(weft_modulus) || !is_positive(shear_modulus))
    throw std::invalid_argument("the moduli must be positive [Pa]");
  Fabric fabric = sheet(poisson, thickness, area_density);
  const double second_moment = thickness * thickness * thickness / 12;  // per width
  fabric.warp_membrane = warp_modulus * thickness;
  fabric.weft_membrane = weft_modulus * thickness;
  fabric.shear_membrane = shear_modulus * thickness;
  fabric.transverse_shear =
      shear_between(fabric.warp_membrane, fabric.weft_membrane, coupling(poisson, warp_modulus, weft_modulus));
  set_measured_bending(fabric, warp_modulus * second_moment, weft_modulus * second_moment,
                       shear_modulus * second_moment);
  return fabric;
}

void set_measured_bending(Fabric& fabric, double warp, double weft, std::optional<double> twist) {
  if (!is_positive(warp) || !is_positive(weft) || !is_positive(twist.value_or(1)))
    throw std::invalid_argument("the bending rigidities must be positive [N m]");
  const double product = coupling(fabric.poisson, warp, weft);
  fabric.warp_bending = warp / (1 - product);
  fabric.weft_bending = weft / (1 - product);
  fabric.bending_coupling = fabric.poisson * fabric.weft_bending;
  fabric.twist_bending = twist.value_or(shear_between(warp, weft, product));
  fabric.measured_bending.reset();
}

void set_measured_bending(Fabric& fabric, const Fabric::MeasuredBending& strips) {
  const Eigen::Matrix3d rigidity = PlateBending(strips.form, strips.warp, strips.weft, fabric.poisson).rigidity();
  fabric.measured_bending = strips;
  fabric.warp_bending = rigidity(0, 0);
  fabric.weft_bending = rigidity(1, 1);
  fabric.bending_coupling = rigidity(0, 1);
  fabric.twist_bending = rigidity(2, 2);
}

Fabric scaled(Fabric fabric, double membrane, double bending) {
  if (!(membrane > 0 && bending > 0)) throw std::invalid_argument("factors on stiffnesses must be positive");
  for (double* stiffness : {&fabric.warp_membrane, &fabric.weft_membrane, &fabric.shear_membrane})
    *stiffness *= membrane;
  for (double* stiffness :
       {&fabric.warp_bending, &fabric.weft_bending, &fabric.bending_coupling, &fabric.twist_bending})
    *stiffness *= bending;
  if (auto& strips = fabric.measured_bending) {
    strips->warp = strips->warp.scaled(bending);
    strips->weft = strips->weft.scaled(bending);
  }
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
