#include "case_keys.hpp"

namespace sundrape {
namespace {

using namespace keys;

Section material() {
  return {
      .name = "material",
      .heading = "`[material]`",
      .doc =
          "The fabric. Exactly one of `weight`, `density_area` and `density`; either `youngs_modulus`, or "
          "`warp_modulus`, "
          "`weft_modulus` and `shear_modulus` together.",
      .keys =
          {
              {.name = "thickness", .unit = "m", .range = positive(), .required = true, .doc = "h."},
              {.name = "weight",
               .unit = "N/m^2",
               .range = positive(),
               .default_note = "one of three",
               .doc = "Weight per area, for g = 9.80665 m/s²."},
              {.name = "density_area",
               .unit = "kg/m^2",
               .range = positive(),
               .default_note = "one of three",
               .doc = "Mass per area."},
              {.name = "density",
               .unit = "kg/m^3",
               .range = positive(),
               .default_note = "one of three",
               .doc = "Mass per volume; times h it is the mass per area."},
              {.name = "youngs_modulus", .unit = "N/m^2", .range = positive(), .doc = "E of an isotropic fabric."},
              {.name = "warp_modulus", .unit = "N/m^2", .range = positive(), .doc = "E₁ of an orthotropic fabric."},
              {.name = "weft_modulus", .unit = "N/m^2", .range = positive(), .doc = "E₂ of an orthotropic fabric."},
              {.name = "shear_modulus", .unit = "N/m^2", .range = positive(), .doc = "G of an orthotropic fabric."},
              {.name = "poisson",
               .entries = 1,
               .range = {.low = 0, .high = 0.5, .low_included = true},
               .default_value = "0",
               .doc = "ν, or `[ν₁₂]` of an orthotropic fabric."},
              {.name = "bending",
               .type = KeyType::table,
               .holds = "material.bending",
               .default_note = "from the moduli: E h³ / (12 (1 − ν²))",
               .doc = "Bending measured apart from the membrane."},
              {.name = "damping",
               .type = KeyType::table,
               .holds = "material.damping",
               .doc = "What turns motion into heat."},
              {.name = "net",
               .type = KeyType::table,
               .holds = "material.net",
               .doc = "Parameters of the particle net."},
          },
  };
}

Section bending() {
  return {
      .name = "material.bending",
      .heading = "`bending = { ... }` of `[material]`",
      .kind_key = "law",
      .keys =
          {
              {.name = "law",
               .type = KeyType::choice,
               .choices = {"linear"},
               .later = {"polynomial"},
               .default_value = "\"linear\"",
               .doc = "Moment over curvature."},
              {.name = "rigidity",
               .unit = "N m",
               .entries = 2,
               .range = positive(),
               .required = true,
               .doc = "Moment per width and curvature, or `[warp, weft]` of it, e.g. `\"0.589 gf*cm^2/cm\"`."},
          },
  };
}

Section damping() {
  return {
      .name = "material.damping",
      .heading = "`damping = { ... }` of `[material]`",
      .doc = "All three zero: no dissipation but the integrator's.",
      .keys =
          {
              {.name = "mass",
               .unit = "1/s",
               .range = not_negative(),
               .default_value = "0",
               .doc = "Drag against still air, per mass."},
              {.name = "membrane",
               .unit = "s",
               .range = not_negative(),
               .default_value = "\"1 ms\"",
               .doc = "Kelvin–Voigt relaxation time of stretch and in-plane shear."},
              {.name = "bending",
               .unit = "s",
               .range = not_negative(),
               .default_value = "\"0.3 ms\"",
               .doc = "Kelvin–Voigt relaxation time of bending."},
          },
  };
}

Section net() {
  return {
      .name = "material.net",
      .heading = "`net = { ... }` of `[material]`",
      .keys =
          {
              {.name = "compression_factor",
               .range = above_to(0, 1),
               .default_value = "1",
               .doc = "D': stiffness of a shortened thread over that of a stretched one."},
              {.name = "shear_factor", .range = above_to(0, 10), .default_value = "1", .doc = "B' of in-plane shear."},
              {.name = "shear",
               .type = KeyType::choice,
               .choices = {"cell", "diagonals"},
               .default_value = "\"cell\"",
               .doc = "In-plane shear from the difference of a cell's diagonals, or by a spring a diagonal, which "
                      "stiffens "
                      "the threads as well."},
              {.name = "diagonal_compression_factor",
               .range = above_to(0, 1),
               .default_value = "1",
               .doc = "B' of the shorter diagonal, with `shear = \"diagonals\"`."},
          },
  };
}

}  // namespace

std::vector<Section> material_keys() { return {material(), bending(), damping(), net()}; }

}  // namespace sundrape
