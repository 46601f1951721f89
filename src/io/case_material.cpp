#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "case_parts.hpp"

namespace sundrape {
namespace {

constexpr double standard_gravity = 9.80665;  // what weights in gf, kgf and ozf refer to [m/s²]

double resolve_area_density(const CaseSection& material) {
  std::vector<std::string> given;
  for (const auto* name : {"weight", "density_area", "density"})
    if (material.has(name)) given.emplace_back(name);
  if (given.empty()) material.fail("weight", "missing: one of weight, density_area, density is needed");
  if (given.size() > 1)
    material.fail(given[1], fmt::format("given twice over, by {}: one is enough", fmt::join(given, " and ")));
  const double value = material.number(given.front());
  if (given.front() == "weight") return value / standard_gravity;
  return given.front() == "density" ? value * material.number("thickness") : value;
}

Fabric resolve_orthotropic(const CaseSection& material, double area_density) {
  for (const auto* name : {"warp_modulus", "weft_modulus", "shear_modulus"})
    if (!material.has(name))
      material.fail(name, "missing: an orthotropic fabric needs warp_modulus, weft_modulus and shear_modulus");
  const double warp = material.number("warp_modulus");
  const double weft = material.number("weft_modulus");
  const double poisson = material.number("poisson");
  const double coupling = poisson * poisson * weft / warp;  // ν₁₂ ν₂₁, since ν₂₁ E₁ = ν₁₂ E₂
  if (!(coupling < 1))
    material.fail("poisson", fmt::format("{} is outside [0, {:.4g}): no elastic sheet has it with these moduli",
                                         poisson, std::sqrt(warp / weft)));
  return orthotropic_fabric(warp, weft, material.number("shear_modulus"), poisson, material.number("thickness"),
                            area_density);
}

Fabric resolve_elasticity(const CaseSection& material) {
  const double area_density = resolve_area_density(material);
  std::string orthotropic;
  for (const auto* name : {"warp_modulus", "weft_modulus", "shear_modulus"})
    if (material.has(name)) orthotropic = name;
  if (material.has("youngs_modulus")) {
    if (!orthotropic.empty()) material.fail(orthotropic, "youngs_modulus has set it already: give either, not both");
    return isotropic_fabric(material.number("youngs_modulus"), material.number("poisson"), material.number("thickness"),
                            area_density);
  }
  if (orthotropic.empty())
    material.fail("youngs_modulus",
                  "missing: it, or warp_modulus, weft_modulus and shear_modulus, say how the fabric stretches");
  return resolve_orthotropic(material, area_density);
}

}  // namespace

Fabric resolve_fabric(const CaseSection& material) {
  Fabric fabric = resolve_elasticity(material);
  if (material.has("bending")) resolve_bending(material.table("bending"), fabric);
  const CaseSection scale = material.table("scale");
  fabric = scaled(std::move(fabric), scale.number("membrane"), scale.number("bending"));
  const CaseSection damping = material.table("damping");
  fabric.damping = {damping.number("mass"), damping.number("membrane"), damping.number("bending")};
  const CaseSection net = material.table("net");
  fabric.net.compression_factor = net.number("compression_factor");
  fabric.net.shear_factor = net.number("shear_factor");
  fabric.net.diagonal_springs = net.text("shear") == "diagonals";
  fabric.net.diagonal_compression_factor = net.number("diagonal_compression_factor");
  return fabric;
}

}  // namespace sundrape
