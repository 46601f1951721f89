#include "sundrape/export/frame_range.hpp"

#include <algorithm>
#include <charconv>
#include <optional>
#include <stdexcept>
#include <string_view>

#include <fmt/format.h>

namespace sundrape {
namespace {

using Number = long long;

/// One part of a range; nothing where it was left out.
std::optional<Number> part(std::string_view text, const std::string& range) {
  if (text.empty()) return std::nullopt;
  Number value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size())
    throw std::invalid_argument(fmt::format(
        "\"{}\" is no range of frames: write first:end:step in whole numbers, e.g. 0:100:2, -10: or 5", range));
  return value;
}

std::vector<std::string_view> split(std::string_view text) {
  std::vector<std::string_view> parts;
  for (std::size_t begin = 0;;) {
    const auto colon = text.find(':', begin);
    parts.push_back(text.substr(begin, colon - begin));
    if (colon == std::string_view::npos) return parts;
    begin = colon + 1;
  }
}

}  // namespace

std::vector<std::size_t> select_frames(const std::string& range, std::size_t frames) {
  const auto parts = split(range.empty() ? std::string_view(":") : std::string_view(range));
  const auto count = static_cast<Number>(frames);
  const auto from_start = [&](Number n) { return n < 0 ? n + count : n; };
  if (parts.size() > 3) static_cast<void>(part("?", range));
  if (parts.size() == 1) {
    const auto frame = from_start(*part(parts[0], range));
    if (frame < 0 || frame >= count)
      throw std::invalid_argument(fmt::format("there is no frame {}: the result has {}", range, frames));
    return {static_cast<std::size_t>(frame)};
  }
  const auto step = parts.size() == 3 ? part(parts[2], range).value_or(1) : 1;
  if (step < 1) throw std::invalid_argument(fmt::format("\"{}\": the step must be 1 or more", range));
  const auto first = std::clamp<Number>(from_start(part(parts[0], range).value_or(0)), 0, count);
  const auto end = std::clamp<Number>(from_start(part(parts[1], range).value_or(count)), 0, count);
  std::vector<std::size_t> chosen;
  for (auto k = first; k < end; k += step) chosen.push_back(static_cast<std::size_t>(k));
  if (chosen.empty())
    throw std::invalid_argument(fmt::format("\"{}\" picks none of the result's {} frames", range, frames));
  return chosen;
}

}  // namespace sundrape
