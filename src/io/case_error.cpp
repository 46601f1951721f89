#include "sundrape/io/case_error.hpp"

#include <fmt/format.h>

namespace sundrape {
namespace {

std::string one_line(const std::string& file, int line, const std::string& key, const std::string& message) {
  std::string text = line > 0 ? fmt::format("{}:{}: ", file, line) : fmt::format("{}: ", file);
  if (!key.empty()) text += key + ": ";
  text += message;
  for (char& c : text)
    if (c == '\n' || c == '\r') c = ' ';
  return text;
}

}  // namespace

CaseError::CaseError(const std::string& file, int line, const std::string& key, const std::string& message)
    : std::runtime_error(one_line(file, line, key, message)), file_(file), line_(line), key_(key), message_(message) {}

}  // namespace sundrape
