#!/usr/bin/env bash
# Builds and runs the benchmarks of the tracer on one thread, and names the machine they ran on.
#
#   tools/bench.sh [OPTIONS OF GOOGLE BENCHMARK...]      for example --benchmark_filter=gather

set -euo pipefail
cd "$(dirname "$0")/.."

tools/build.sh release benchmarks
mkdir -p build/bench
.venv/bin/vitrail emit tracer scenes/calibration/ball_lens.yaml --out build/bench >/dev/null

grep -m1 'model name' /proc/cpuinfo | sed 's/.*: /machine: /' || true
printf 'cores: %s, load: %s\n' "$(nproc)" "$(cut -d' ' -f1 /proc/loadavg)"

# Run every benchmark program that the build made.
export VITRAIL_BENCHMARK_SCENE=build/bench/scene.json
while IFS= read -r program; do
  printf '\n== %s\n' "$(basename "$program")"
  "$program" "$@"
done < <(find build/release/benchmarks -type f -executable -name 'benchmark_*' | sort)
