#pragma once
#include <stdexcept>
#include <string>

#include "sundrape/io/case.hpp"

namespace sundrape {

/// A case that cannot be run as it stands. what() is one line: `CASE.toml:17: material.poisson: 0.7 is outside [0,
/// 0.5)`, or, for a key given on the command line, `--set material.poisson=0.7: material.poisson: 0.7 is outside [0,
/// 0.5)`.
class CaseError : public std::runtime_error {
 public:
  CaseError(const std::string& file, int line, const std::string& key, const std::string& message);
  /// For problems found later, when the mesh is known: the entry's own file, line and key.
  CaseError(const SourceLine& source, const std::string& message)
      : CaseError(source.file, source.line, source.key, message) {}

  [[nodiscard]] const std::string& file() const { return file_; }
  [[nodiscard]] int line() const { return line_; }               // 0: no line, as for --set
  [[nodiscard]] const std::string& key() const { return key_; }  // dotted, empty for a syntax error
  [[nodiscard]] const std::string& message() const { return message_; }

 private:
  std::string file_;
  int line_;
  std::string key_;
  std::string message_;
};

}  // namespace sundrape
