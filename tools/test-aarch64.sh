#!/usr/bin/env bash
# Builds the tracer for 64-bit ARM and runs C++ tests in QEMU: the bits of the kernels must be those of x86.
#
#   tools/test-aarch64.sh [OPTIONS OF CTEST...]      for example -R GatherKernel
#
# Installs a cross compiler and QEMU (tools/aarch64-packages.txt). ARM's libraries are unpacked into build/aarch64-root
# and not installed: apt works there with a state of its own, so this machine stays of one architecture.

set -euo pipefail
cd "$(dirname "$0")/.."
root=$PWD/build/aarch64-root

# packages KIND: the lines of that kind.
packages() { sed -n "s/^$1 //p" tools/aarch64-packages.txt; }

as_root() {
  if [ "$(id -u)" -eq 0 ]; then "$@"; else sudo "$@"; fi
}

install_on_this_machine() {
  local package missing=()
  for package in $(packages host); do
    dpkg-query -W -f '${Status}' "$package" 2>/dev/null | grep -q '^install ok installed$' || missing+=("$package")
  done
  [ ${#missing[@]} -eq 0 ] || as_root env DEBIAN_FRONTEND=noninteractive \
    apt-get -q -y -o DPkg::Lock::Timeout=300 install --no-install-recommends "${missing[@]}" </dev/null
}

# Download ARM's packages and all they depend on, as if for a machine on which nothing is installed, and unpack them.
make_root() {
  local stamp=$root/packages.txt state=$PWD/build/aarch64-apt file
  if cmp -s "$stamp" tools/aarch64-packages.txt; then return; fi
  rm -rf "$root" "$state"
  mkdir -p "$root" "$state/lists/partial" "$state/archives/partial"
  : >"$state/status"
  local apt=(apt-get -q -y -o APT::Architecture=arm64 -o APT::Architectures=arm64 -o Dir::State="$state"
    -o Dir::State::status="$state/status" -o Dir::Cache="$state" -o APT::Sandbox::User=root -o Debug::NoLocking=1)
  "${apt[@]}" update </dev/null
  # shellcheck disable=SC2046  # one word a package
  "${apt[@]}" --no-install-recommends --download-only install $(packages arm64) </dev/null
  for file in "$state"/archives/*.deb; do dpkg-deb -x "$file" "$root"; done
  cp tools/aarch64-packages.txt "$stamp"
}

# Build and run what holds formulas and kernels. The whole tracer builds as well: tools/build.sh aarch64.
programs=(test_base test_optics test_photon)
install_on_this_machine
make_root
tools/build.sh aarch64 "${programs[@]}"
ctest --test-dir build/aarch64 --output-on-failure --no-tests=error --parallel "${JOBS:-$(nproc)}" \
  --exclude-regex _NOT_BUILT "$@"
