#pragma once
#include <string>
#include <vector>

namespace sundrape {

/// Numbers of the frames that a range names: "a:b:s" is every s-th from a on, without b, as in Python; each part may be
/// left out, a negative one counts from the end, and "k" is one frame. An empty text is all.
/// @param frames  how many there are
/// @throws std::invalid_argument  no such range, or one that picks nothing
[[nodiscard]] std::vector<std::size_t> select_frames(const std::string& range, std::size_t frames);

}  // namespace sundrape
