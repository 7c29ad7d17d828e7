#include "base/diagnostic.h"

#include <utility>

namespace vitrail {

std::string Diagnostic::text() const { return path + ": " + what + "; " + remedy; }

namespace {

std::string joined(const std::vector<Diagnostic>& found) {
  std::string lines;
  for (const Diagnostic& diagnostic : found) {
    if (!lines.empty()) lines += '\n';
    lines += diagnostic.text();
  }
  return lines;
}

}  // namespace

InputError::InputError(std::vector<Diagnostic> found)
    : std::runtime_error(joined(found)), diagnostics_(std::move(found)) {}

}  // namespace vitrail
