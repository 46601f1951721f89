#include "sundrape/app/crosscheck_report.hpp"

#include <cmath>
#include <iterator>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "sundrape/app/rest_watch.hpp"

namespace sundrape {
namespace {

std::string stability(const EndState& end) {
  if (!end.negative_pivots) return "of unknown stability";
  return *end.negative_pivots == 0 ? "stable" : fmt::format("unstable, {} negative pivots", *end.negative_pivots);
}

std::string distance(const Crosscheck& check, double metres) {
  return fmt::format("{:.3g} m = {:.3g} % of the diagonal, {:.3g} % of L", metres, 100 * metres / check.diagonal,
                     100 * metres / check.size);
}

std::string verdict(const Crosscheck& check, const MethodPair& pair) {
  const auto &a = check.methods[pair.first], &b = check.methods[pair.second];
  switch (pair.verdict) {
    case MethodPair::Verdict::same_branch:
      return fmt::format("{} and {} are on the same branch.", a.name, b.name);
    case MethodPair::Verdict::other_branch:
      return fmt::format("{} and {} are on different branches{}.", a.name, b.name,
                         check.is_one_drape(pair.apart.rms) ? " of one drape" : "");
    case MethodPair::Verdict::undecided:
      break;
  }
  const bool balances = b.end->residual <= RestWatch::balanced;
  return fmt::format("whether {} and {} are on one branch is undecided: {} ended {}.", a.name, b.name, b.name,
                     balances ? "at an equilibrium that is " + stability(*b.end) : "where forces do not balance");
}

std::string verdict_name(MethodPair::Verdict verdict) {
  if (verdict == MethodPair::Verdict::undecided) return "undecided";
  return verdict == MethodPair::Verdict::same_branch ? "same branch" : "other branch";
}

void pair_text(const Crosscheck& check, const MethodPair& pair, std::string& text) {
  const auto out = std::back_inserter(text);
  const auto &a = check.methods[pair.first], &b = check.methods[pair.second];
  fmt::format_to(out, "\n{}\n", verdict(check, pair));
  fmt::format_to(out, "  RMS distance  {}\n  max distance  {}\n", distance(check, pair.apart.rms),
                 distance(check, pair.apart.max));
  const double gap = b.end->total_energy - a.end->total_energy;
  fmt::format_to(out, "  total energy  {} {:.6e} J, {} {:.6e} J: {:+.3g} % of weight × L\n", a.name,
                 a.end->total_energy, b.name, b.end->total_energy, 100 * gap / check.energy_scale);
  for (const auto& [name, force] : a.end->reactions) {
    const Vector3& other = pair.laid_on.reactions.at(name);
    fmt::format_to(out, "  reaction of '{}'  ({:.4e} {:.4e} {:.4e}) N against ({:.4e} {:.4e} {:.4e}) N\n", name,
                   force.x(), force.y(), force.z(), other.x(), other.y(), other.z());
  }
  if (!pair.relaxed) return;
  if (!pair.relaxed->end) {
    fmt::format_to(out, "  the end of {} could not be relaxed: {}\n", b.name, pair.relaxed->failure);
    return;
  }
  fmt::format_to(out, "  the end of {} relaxes to within {} of itself (at most {:.3g} m), {}\n", b.name,
                 distance(check, pair.relaxed->moved_rms), pair.relaxed->moved_max, stability(*pair.relaxed->end));
  if (check.is_one_branch(pair.relaxed->apart_rms))
    fmt::format_to(out, "  and there to within {} of {}: it had not arrived\n",
                   distance(check, pair.relaxed->apart_rms), a.name);
  else if (pair.verdict == MethodPair::Verdict::undecided)
    fmt::format_to(out, "  which is not where {} ended\n", a.name);
  else if (pair.relaxed->moved_rms < 0.1 * pair.relaxed->apart_rms)
    fmt::format_to(out, "  so it is an equilibrium of relaxation too, another one than it finds from the start\n");
  else
    fmt::format_to(out, "  so where {} ended is no equilibrium of relaxation\n", b.name);
}

}  // namespace

std::string crosscheck_text(const Crosscheck& check) {
  auto text = fmt::format("{}\n", check.title);
  const auto out = std::back_inserter(text);
  fmt::format_to(out, "  the case has {} {}, the identity included\n\n", check.symmetries,
                 check.symmetries == 1 ? "symmetry" : "symmetries");
  fmt::format_to(out, "{:<12} {:>13} {:>12} {:>12} {:>12} {:>12} {:>12} {:>12} {:>9}  stability\n", "energies [J]",
                 "total", "membrane", "shear", "bending", "gravity", "contact", "load", "residual");
  for (const auto& method : check.methods) {
    if (!method.end) {
      fmt::format_to(out, "{:<12} failed: {}\n", method.name, method.failure);
      continue;
    }
    const auto& e = method.end->energy;
    fmt::format_to(out, "{:<12} {:>13.6e} {:>12.5e} {:>12.5e} {:>12.5e} {:>12.5e} {:>12.5e} {:>12.5e} {:>9.1e}  {}\n",
                   method.name, method.end->total_energy, e.at("membrane"), e.at("shear"), e.at("bending"),
                   e.at("gravity"), e.at("contact"), e.at("load"), method.end->residual, stability(*method.end));
  }
  for (const auto& method : check.methods)
    for (const auto& warning : method.warnings) fmt::format_to(out, "{}: {}\n", method.name, warning);
  for (const auto& pair : check.pairs) pair_text(check, pair, text);
  return text;
}

nlohmann::json crosscheck_json(const Crosscheck& check, int nodes) {
  nlohmann::json json{{"format", "sundrape crosscheck"},
                      {"title", check.title},
                      {"diagonal_m", check.diagonal},
                      {"size_m", check.size},
                      {"weight_times_size_J", check.energy_scale},
                      {"same_drape_over_diagonal", check.same_drape},
                      {"same_branch_over_size", check.same_branch},
                      {"symmetries", check.symmetries},
                      {"methods", nlohmann::json::array()},
                      {"pairs", nlohmann::json::array()}};
  for (const auto& method : check.methods) {
    nlohmann::json entry = method.end ? to_json(*method.end) : nlohmann::json::object();
    entry.update({{"name", method.name},
                  {"result", method.result.filename().string()},
                  {"status", method.end ? "done" : "failed"},
                  {"message", method.failure},
                  {"warnings", method.warnings}});
    json["methods"].push_back(std::move(entry));
  }
  for (const auto& pair : check.pairs) {
    std::vector<std::array<double, 3>> shape;
    for (int i = 0; i < nodes; ++i) {
      const Vector3 x = point(pair.apart.aligned, i);
      shape.push_back({x.x(), x.y(), x.z()});
    }
    nlohmann::json entry{{"first", check.methods[pair.first].name},
                         {"second", check.methods[pair.second].name},
                         {"verdict", verdict_name(pair.verdict)},
                         {"same_branch", pair.verdict == MethodPair::Verdict::same_branch},
                         {"same_drape", check.is_one_drape(pair.apart.rms)},
                         {"rms_m", pair.apart.rms},
                         {"max_m", pair.apart.max},
                         {"rms_over_diagonal", pair.apart.rms / check.diagonal},
                         {"max_over_diagonal", pair.apart.max / check.diagonal},
                         {"rms_over_size", pair.apart.rms / check.size},
                         {"max_over_size", pair.apart.max / check.size},
                         {"symmetry", pair.apart.map},
                         {"second_laid_on_first", to_json(pair.laid_on)},
                         {"second_position_m", shape}};
    if (pair.relaxed) {
      entry["relaxed"] = pair.relaxed->end ? to_json(*pair.relaxed->end) : nlohmann::json::object();
      entry["relaxed"].update({{"result", pair.relaxed->result.filename().string()},
                               {"message", pair.relaxed->failure},
                               {"moved_rms_m", pair.relaxed->moved_rms},
                               {"moved_max_m", pair.relaxed->moved_max},
                               {"apart_rms_m", pair.relaxed->apart_rms}});
    }
    json["pairs"].push_back(std::move(entry));
  }
  return json;
}

}  // namespace sundrape
