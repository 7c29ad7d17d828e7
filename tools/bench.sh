#!/usr/bin/env bash
# Builds and runs the benchmarks of the tracer on one thread, and names the machine they ran on.
#
#   tools/bench.sh [OPTIONS OF GOOGLE BENCHMARK...]      for example --benchmark_filter=gather

set -euo pipefail
cd "$(dirname "$0")/.."

mkdir -p build/bench
cmake --preset release -DVITRAIL_BENCHMARKS=ON >build/bench/configure.log </dev/null ||
  { cat build/bench/configure.log >&2; echo 'bench: FAILED: cmake; run tools/setup.sh if a package is missing' >&2; exit 1; }
cmake --build build/release --parallel "${JOBS:-$(nproc)}" --target tracer_benchmark </dev/null
.venv/bin/vitrail emit tracer scenes/calibration/ball_lens.yaml --out build/bench >/dev/null

grep -m1 'model name' /proc/cpuinfo | sed 's/.*: /machine: /' || true
printf 'cores: %s, load: %s\n' "$(nproc)" "$(cut -d' ' -f1 /proc/loadavg)"
VITRAIL_BENCHMARK_SCENE=build/bench/scene.json build/release/benchmarks/tracer_benchmark "$@"
