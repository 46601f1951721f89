#include <fmt/format.h>
#include <fmt/ranges.h>

#include "case_section.hpp"

namespace sundrape {

InBox CaseSection::corners(std::string_view name) const {
  Key three = key(name);
  three.entries = 3;
  const auto* array = value(name).as_array();
  if (array == nullptr || array->size() != 2 || !array->get(0)->is_array() || !array->get(1)->is_array())
    fail(name, "two opposite corners [[x, y, z], [x, y, z]] are expected");
  const auto a = list(three, *array->get(0)->as_array());
  const auto b = list(three, *array->get(1)->as_array());
  const Vector3 first(a[0], a[1], a[2]);
  const Vector3 second(b[0], b[1], b[2]);
  return {first.cwiseMin(second), first.cwiseMax(second)};
}

Selector CaseSection::selector(std::string_view name) const {
  const toml::node& node = value(name);
  if (const auto* set = node.as_string()) {
    if (set->get().empty()) fail(name, "the name of a node set is empty");
    return NamedSet{set->get()};
  }
  const Section& ways = key_section("selector");
  if (!node.is_table() || node.as_table()->size() != 1)
    fail(name, fmt::format("the name of a node set or a table with exactly one of {} is expected",
                           fmt::join(ways.names(""), ", ")));
  const CaseSection way(*context_, ways, node.as_table(), source(name));
  way.check();
  if (way.has("near")) return Near{way.vector3("near")};
  if (way.has("box")) return way.corners("box");
  if (way.has("plane")) {
    const CaseSection plane = way.table("plane");
    return OnPlane{plane.vector3("point"), plane.direction("normal")};
  }
  const CaseSection sphere = way.table("sphere");
  return InSphere{sphere.vector3("centre"), sphere.number("radius")};
}

}  // namespace sundrape
