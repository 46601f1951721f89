#include "sundrape/app/check.hpp"

#include <fmt/format.h>

#include "sundrape/app/model.hpp"
#include "sundrape/io/case_reader.hpp"

namespace sundrape {
namespace {

std::string size_of(const Case& c, const CaseModel& model) {
  const auto nodes = static_cast<double>(model.mesh.nodes());
  const auto frames = static_cast<double>(c.output.frame_times.size());
  const double megabyte = 1 << 20;
  std::string text =
      fmt::format("\n# size\nnodes = {}\nquads = {}\nunknowns = {}\nblocks of the tangent = {}\n", model.mesh.nodes(),
                  model.mesh.quads.size(), model.system->unknowns().size(), model.system->structure().blocks());
  text += fmt::format("memory for the tangent = {:.1f} MB\n",
                      static_cast<double>(model.system->structure().blocks()) * 9 * 8 / megabyte);
  if (c.analysis == Analysis::dynamics)
    text += fmt::format("frames = {}, about {:.1f} MB of result\n", frames, frames * nodes * 9 * 8 / megabyte);
  if (model.contact) text += fmt::format("contact stiffness = {:.6g} N/m^3\n", model.contact->law().stiffness());
  text += fmt::format("weight of the cloth under its load = {:.6g} N\n", model.weight);
  return text;
}

}  // namespace

std::string check_case(const std::filesystem::path& file, const std::vector<std::string>& sets) {
  const Case c = read_case(file, sets);
  return describe(c) + size_of(c, build_model(c));
}

}  // namespace sundrape
