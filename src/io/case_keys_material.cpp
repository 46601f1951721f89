#include "sundrape/material/moment_curvature.hpp"

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
              {.name = "fabric",
               .type = KeyType::text,
               .default_note = "none",
               .doc =
                   "A fabric of the [library](fabrics.md) by its name, or a `.toml` file with the keys of a material, "
                   "relative to the case; keys beside it replace its own."},
              {.name = "title",
               .type = KeyType::text,
               .default_note = "the fabric's name",
               .doc = "A line for people."},
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
              {.name = "breaking_strain",
               .range = positive(),
               .default_note = "0.5 where supports or obstacles move, else none",
               .doc = "A mesh edge that is stretched further ends the run: the cloth has torn."},
              {.name = "youngs_modulus", .unit = "N/m^2", .range = positive(), .doc = "E of an isotropic fabric."},
              {.name = "warp_modulus", .unit = "N/m^2", .range = positive(), .doc = "E₁ of an orthotropic fabric."},
              {.name = "weft_modulus", .unit = "N/m^2", .range = positive(), .doc = "E₂ of an orthotropic fabric."},
              {.name = "shear_modulus", .unit = "N/m^2", .range = positive(), .doc = "G of an orthotropic fabric."},
              {.name = "poisson",
               .entries = 1,
               .range = {.low = 0, .high = 0.5, .low_included = true},
               .default_value = "0",
               .doc = "ν, or `[ν₁₂]` of an orthotropic fabric: the membrane's C₁₂ is ν₁₂ E₂ h/(1 − ν₁₂ ν₂₁) with ν₂₁ = "
                      "ν₁₂ E₂/E₁. In bending as well, with B in the place of E."},
              {.name = "bending",
               .type = KeyType::table,
               .holds = "material.bending",
               .default_note = "from the moduli: B = E h³/12",
               .doc = "Bending measured apart from the membrane."},
              {.name = "damping",
               .type = KeyType::table,
               .holds = "material.damping",
               .doc = "What turns motion into heat."},
              {.name = "scale",
               .type = KeyType::table,
               .holds = "material.scale",
               .doc = "Factors on the stiffnesses, for studies."},
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
      .doc =
          "What a bending test measures on strips, which are free to curl across: B, or M = f(K), per width. The "
          "sheet bends into a cylinder, which takes D₁₁ = B₁/(1 − ν₁₂ ν₂₁), D₂₂ = B₂/(1 − ν₁₂ ν₂₁), D₁₂ = ν₁₂ D₂₂, "
          "with ν₂₁ = ν₁₂ B₂/B₁.",
      .keys =
          {
              {.name = "law",
               .type = KeyType::choice,
               .choices = {"linear", "polynomial"},
               .default_value = "\"linear\"",
               .doc = "Moment over curvature of a strip."},
              {.name = "rigidity",
               .unit = "N m",
               .entries = 2,
               .range = positive(),
               .required = true,
               .kinds = {"linear"},
               .doc =
                   "Moment per width and curvature of a strip, or `[warp, weft]` of it, e.g. `\"0.589 gf*cm^2/cm\"`."},
              {.name = "twist_rigidity",
               .unit = "N m",
               .range = positive(),
               .default_note = "√(B₁ B₂) / (2 (1 + √(ν₁₂ ν₂₁)))",
               .kinds = {"linear"},
               .doc = "Twisting moment m₁₂ per width and engineering twist 2κ₁₂; its default is D (1 − ν)/2 where warp "
                      "and weft are alike."},
              {.name = "coefficients",
               .type = KeyType::lists,
               .entries = MomentCurvature::most_terms,
               .required = true,
               .kinds = {"polynomial"},
               .doc = "α₁, α₂, … of M = α₁ K + α₂ K² + … for K > 0, extended as an odd function; or `[warp list, weft "
                      "list]`. M must grow all the way to `max_curvature`."},
              {.name = "curvature_unit",
               .type = KeyType::unit,
               .unit = "1/m",
               .required = true,
               .kinds = {"polynomial"},
               .doc = "Of K in the polynomial, e.g. `\"1/cm\"`."},
              {.name = "moment_unit",
               .type = KeyType::unit,
               .unit = "N",
               .required = true,
               .kinds = {"polynomial"},
               .doc = "Of M per width, e.g. `\"gf*cm/cm\"`."},
              {.name = "max_curvature",
               .unit = "1/m",
               .entries = 2,
               .range = positive(),
               .required = true,
               .kinds = {"polynomial"},
               .doc = "Where the test ended, or `[warp, weft]` of it; from there on M grows by the slope that it has."},
              {.name = "form",
               .type = KeyType::choice,
               .choices = {"energy", "paper"},
               .default_value = "\"energy\"",
               .kinds = {"polynomial"},
               .doc = "From strips to the sheet of a shell. `energy`: symmetric, and where warp and weft are alike "
                      "bending follows the same law in every direction. `paper`: equations (32)–(34) in orthonormal "
                      "warp–weft axes; "
                      "unsymmetric for ν ≠ 0, to be solved by LU."},
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

Section scale() {
  const auto factor = [](const char* name, const char* doc) {
    return Key{.name = name, .range = positive(), .default_value = "1", .doc = doc};
  };
  return {
      .name = "material.scale",
      .heading = "`scale = { ... }` of `[material]`",
      .doc = "Factors on what the fabric has, whatever its laws: to ask what a stiffness matters.",
      .keys =
          {
              factor("membrane",
                     "On the stiffnesses of the membrane, in-plane shear included; transverse shear stays."),
              factor("bending", "On all moments of bending."),
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

std::vector<Section> material_keys() { return {material(), bending(), damping(), scale(), net()}; }

}  // namespace sundrape
