#pragma once

namespace sundrape {

/// One visitor of a variant, made of functions for its alternatives.
template <class... Visitors>
struct Overload : Visitors... {
  using Visitors::operator()...;
};
template <class... Visitors>
Overload(Visitors...) -> Overload<Visitors...>;  // clang deduces it by itself from version 17 on

}  // namespace sundrape
