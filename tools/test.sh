#!/usr/bin/env bash
# Runs every check of the project in order of cost, says how long each took, and ends with pytest and its closing line.
# A stage that fails does not stop the later ones; the exit code is 0 only if all passed.

set -uo pipefail
cd "$(dirname "$0")/.."
failed=()

# stage NAME COMMAND...: run a command under a heading, remember a failure, tell the time it took.
stage() {
  local name=$1 began=$SECONDS
  shift
  printf '\n== %s\n' "$name"
  if "$@"; then
    printf '== %s: ok, %d s\n' "$name" $((SECONDS - began))
  else
    printf '== %s: FAILED, %d s\n' "$name" $((SECONDS - began))
    failed+=("$name")
  fi
}

# Run the C++ tests of one build; a test that is not found is a failure, not a pass.
run_ctest() { ctest --test-dir "build/$1" --output-on-failure --no-tests=error --parallel "${JOBS:-$(nproc)}"; }

# Stop at the first report of a sanitizer, with a stack that names lines.
export ASAN_OPTIONS=detect_leaks=1:strict_string_checks=1:abort_on_error=0
export UBSAN_OPTIONS=print_stacktrace=1:halt_on_error=1

stage "set up" tools/setup.sh
[ ${#failed[@]} -eq 0 ] || exit 1
stage "format and lint" tools/lint.sh
stage "build release" tools/build.sh release
stage "C++ tests, release" run_ctest release
stage "build asan-ubsan" tools/build.sh asan-ubsan cpp_tests
stage "C++ tests, asan-ubsan" run_ctest asan-ubsan

# Keep the tests of one file on one worker, so that a render is shared by the tests that look at it.
stage "Python tests" .venv/bin/python -m pytest -n "${JOBS:-2}" --dist loadfile -q

if [ ${#failed[@]} -gt 0 ]; then
  printf '\nfailed stages: %s\n' "$(IFS=,; echo "${failed[*]}")"
  exit 1
fi
