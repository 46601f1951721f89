#pragma once
#include <stdexcept>

namespace sundrape {

/// A file that could not be created, read, written or understood; the text names the file, what was tried and why it
/// failed.
class FileError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace sundrape
