#!/usr/bin/env bash
# Builds the C++ side with one preset of CMakePresets.json into build/<preset>.
#
#   tools/build.sh PRESET [TARGET...]

set -euo pipefail
cd "$(dirname "$0")/.."
preset=${1:?usage: tools/build.sh PRESET [TARGET...]}
shift

# Keep objects between clean builds where the machine has a compiler cache.
launcher=()
if command -v ccache >/dev/null; then
  launcher=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache)
fi

targets=()
if [ $# -gt 0 ]; then
  targets=(--target "$@")
fi

mkdir -p build
cmake --preset "$preset" "${launcher[@]}" >"build/$preset.configure.log" 2>&1 </dev/null || {
  cat "build/$preset.configure.log" >&2
  printf 'build: FAILED: cmake --preset %s; run tools/setup.sh if a package is missing\n' "$preset" >&2
  exit 1
}
cmake --build "build/$preset" --parallel "${JOBS:-$(nproc)}" "${targets[@]}" </dev/null
