#!/usr/bin/env bash
# Checks what formatters and linters can check; with --fix it lets the formatters write.

set -uo pipefail
cd "$(dirname "$0")/.."
fix=${1:-}
status=0

mapfile -t cpp_files < <(find tracer tests benchmarks -name '*.cc' -o -name '*.cpp' -o -name '*.h' | sort)

# Format first, because the linters report lines.
if [ "$fix" = --fix ]; then
  [ ${#cpp_files[@]} -eq 0 ] || clang-format -i "${cpp_files[@]}" || status=1
  .venv/bin/ruff check -q --fix . || status=1
  .venv/bin/ruff format -q . || status=1
else
  [ ${#cpp_files[@]} -eq 0 ] || clang-format --dry-run --Werror "${cpp_files[@]}" || status=1
  .venv/bin/ruff check -q . || status=1
  .venv/bin/ruff format -q --check --diff . || status=1
  .venv/bin/mypy --no-error-summary || status=1
fi
exit $status
