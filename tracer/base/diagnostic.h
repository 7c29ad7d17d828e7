#pragma once
/// What went wrong, where, and what to do about it: with the input, with the output, or on the way.

#include <stdexcept>
#include <string>
#include <vector>

namespace vitrail {

struct Diagnostic {
  std::string path;    // path.to.key inside the lowered scene, or a file name
  std::string what;    // what is wrong, with the value found
  std::string remedy;  // what to write instead

  /// "path.to.key: what; remedy"
  std::string text() const;
};

/// The input is wrong: thrown once, with everything that was found, before any work begins.
class InputError : public std::runtime_error {
 public:
  explicit InputError(const std::vector<Diagnostic>& found);
};

/// A file cannot be written.
class OutputError : public std::runtime_error {
 public:
  explicit OutputError(const Diagnostic& found) : std::runtime_error(found.text()) {}
};

/// A limit of this program that shows only while it works, such as the depth of nested solids.
class LimitError : public std::runtime_error {
 public:
  explicit LimitError(const Diagnostic& found) : std::runtime_error(found.text()) {}
};

}  // namespace vitrail
