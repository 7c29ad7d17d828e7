#!/usr/bin/env bash
# Renders the picture at the top of README.md: scenes/paper/goblet.yaml, larger and with more light. Some minutes on two cores.
#
#   tools/picture.sh [OUT.png]        docs/pictures/goblet.png unless another file is named

set -euo pipefail
cd "$(dirname "$0")/.."
out=$(realpath -m "${1:-docs/pictures/goblet.png}")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

sed 's/width: 192, height: 144/width: 768, height: 576/' scenes/paper/goblet.yaml >"$work/goblet.yaml"
nice .venv/bin/vitrail render "$work/goblet.yaml" --out "$work/goblet.exr" --samples 9 --photons 3000000 \
  --set gather_radius_m=0.0008 --png
mv "$work/goblet.png" "$out"
