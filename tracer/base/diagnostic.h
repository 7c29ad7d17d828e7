#pragma once
/// What is wrong with the input, where, and what to do about it. All errors are collected before stopping.

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

/// Thrown once, with everything that was found. Programs answer it with exit code 2.
class InputError : public std::runtime_error {
 public:
  explicit InputError(std::vector<Diagnostic> found);
  const std::vector<Diagnostic>& diagnostics() const { return diagnostics_; }

 private:
  std::vector<Diagnostic> diagnostics_;
};

}  // namespace vitrail
