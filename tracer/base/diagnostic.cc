#include "base/diagnostic.h"

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

InputError::InputError(const std::vector<Diagnostic>& found) : std::runtime_error(joined(found)) {}

}  // namespace vitrail
