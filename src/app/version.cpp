#include "sundrape/version.hpp"

namespace sundrape {

std::string version() { return SUNDRAPE_VERSION; }

}  // namespace sundrape
