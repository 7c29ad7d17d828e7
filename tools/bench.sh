#!/usr/bin/env bash
# Runs the benchmarks of the tracer, best of several repetitions, and prints the machine they ran on.

set -euo pipefail
cd "$(dirname "$0")/.."
grep -m1 'model name' /proc/cpuinfo | sed 's/.*: /machine: /' || true
printf 'cores: %s, load: %s\n' "$(nproc)" "$(cut -d' ' -f1 /proc/loadavg)"

# Take every benchmark program that the build made.
found=0
while IFS= read -r program; do
  found=1
  printf '\n== %s\n' "$(basename "$program")"
  "$program" --benchmark_repetitions="${REPETITIONS:-3}" --benchmark_report_aggregates_only=false "$@"
done < <(find build/release -type f -executable -name '*_benchmark' | sort)
[ "$found" -eq 1 ] || { echo 'bench: FAILED: no benchmark program under build/release' >&2; exit 1; }
