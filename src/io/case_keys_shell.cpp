#include "case_choices.hpp"
#include "case_keys.hpp"

namespace sundrape {

using namespace keys;

std::vector<Section> shell_keys() {
  return {{
      .name = "shell",
      .heading = "`[shell]`",
      .doc =
          "The elements of `model = \"shell\"`: quadrilaterals with four nodes, each with a position and a director.",
      .keys =
          {
              {.name = "membrane",
               .type = KeyType::choice,
               .choices = choices::membrane.list(),
               .default_value = "\"centre\"",
               .doc = "Membrane strains: those at the centre, with stabilised hourglass modes (`centre`); plain 2×2 "
                      "integration (`bilinear`); tied at the midpoints of the edges (`edge-tied`); the assumed stress "
                      "field of Pian–Sumihara that Simo, Fox and Rifai use (`mixed`)."},
              {.name = "hourglass_factor",
               .range = above_to(0, 10),
               .default_note = "0.1, and 1 in elements that span the sheet from edge to edge",
               .doc = "Stiffness of the hourglass modes of `membrane = \"centre\"`; with 1 an element bends in its "
                      "plane like a beam."},
              {.name = "bending",
               .type = KeyType::choice,
               .choices = choices::bending.list(),
               .default_value = "\"geodesic\"",
               .doc = "Curvature of a turn Δ of the director over the length a: Δ/a, exact for circles (`geodesic`), "
                      "or the chapter's (17), 2 sin(Δ/2)/a (`bilinear`)."},
              {.name = "shear_correction",
               .range = above_to(0, 10),
               .default_value = "0.8333333333333334",
               .doc = "Factor κ on the transverse shear stiffness G_s h, once; 5/6 for a homogeneous sheet."},
              {.name = "director",
               .type = KeyType::choice,
               .choices = choices::director.list(),
               .default_value = "\"auto\"",
               .doc =
                   "With rotary inertia (`inertia`, and `auto`) the motion is an ODE for any integrator, which goes on "
                   "through sharp folds and without damping; `massless` directors make it a DAE, for `integrator = "
                   "\"ida\"` and a fabric with damping, which stops where a fold is sharper than the mesh."},
              {.name = "rotary_inertia",
               .range = above_to(0, 1000),
               .default_value = "1",
               .doc = "Factor on the rotary inertia ρ h³/12 of the directors."},
          },
  }};
}

}  // namespace sundrape
