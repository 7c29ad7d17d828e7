#!/usr/bin/env bash
# Installs what Vitrail needs: Debian packages by apt, Python packages into .venv. Safe to run again; a second run is quick.
#
#   tools/setup.sh            install what is missing
#
# VITRAIL_PYTHON names the Python to build .venv with (3.11 or newer); otherwise the first that works is taken.

set -euo pipefail
cd "$(dirname "$0")/.."

say() { printf 'setup: %s\n' "$*"; }

# Say what failed and what to do about it, in one line each, and stop.
fail() {
  printf 'setup: FAILED: %s\n' "$1" >&2
  printf 'setup: to do:  %s\n' "$2" >&2
  exit 1
}

# Let one set-up run at a time, so that two terminals do not fill the same environment at once.
lock() {
  mkdir -p build
  exec 9>build/setup.lock
  flock 9 || fail "cannot lock build/setup.lock" "check that build/ can be written"
}

# --- Debian packages --------------------------------------------------------------------------------------------------

wanted_packages() { sed -e 's/#.*//' -e '/^[[:space:]]*$/d' tools/debian-packages.txt; }

missing_packages() {
  local package
  for package in $(wanted_packages); do
    dpkg-query -W -f '${Status}' "$package" 2>/dev/null | grep -q '^install ok installed$' || echo "$package"
  done
}

# Run a command as root, through sudo where we are not root already.
as_root() {
  if [ "$(id -u)" -eq 0 ]; then
    env DEBIAN_FRONTEND=noninteractive "$@"
  else
    sudo env DEBIAN_FRONTEND=noninteractive "$@"
  fi
}

install_debian_packages() {
  command -v dpkg-query >/dev/null && command -v apt-get >/dev/null ||
    fail "this is not a Debian system (no apt-get)" \
      "install the counterparts of tools/debian-packages.txt by hand, or use Debian 12"
  local missing
  missing=$(missing_packages | tr '\n' ' ')
  if [ -z "$missing" ]; then
    say "Debian packages: all there"
    return
  fi
  say "Debian packages to install: $missing"
  [ "$(id -u)" -eq 0 ] || command -v sudo >/dev/null ||
    fail "installing packages needs root, and there is no sudo" "as root: apt-get install $missing"
  as_root apt-get -q -o DPkg::Lock::Timeout=300 update </dev/null ||
    fail "apt-get update did not succeed" "check the network and /etc/apt/sources.list, then run this again"
  # shellcheck disable=SC2086  # one word a package
  as_root apt-get -q -y -o DPkg::Lock::Timeout=300 -o Dpkg::Use-Pty=0 install --no-install-recommends $missing </dev/null ||
    fail "apt-get could not install: $missing" "read apt's message above; 'apt-get -f install' repairs half-done installs"
  missing=$(missing_packages | tr '\n' ' ')
  [ -z "$missing" ] || fail "still missing after the installation: $missing" "install them by hand and run this again"
}

# --- Python environment -----------------------------------------------------------------------------------------------

is_new_enough() { "$1" -c 'import sys; sys.exit(sys.version_info < (3, 11))' >/dev/null 2>&1; }

# Take the first Python of at least 3.11 that can make an environment with pip in it.
find_python() {
  local candidate
  for candidate in "${VITRAIL_PYTHON:-}" python3.11 /usr/bin/python3.11 python3.12 python3.13 python3 /usr/bin/python3; do
    if [ -n "$candidate" ] && is_new_enough "$candidate" && "$candidate" -c 'import venv, ensurepip' >/dev/null 2>&1; then
      command -v "$candidate"
      return
    fi
  done
  return 1
}

# Name the state of the environment by everything it is made from.
environment_key() {
  { cat pyproject.toml constraints.txt && .venv/bin/python --version && pwd; } | sha256sum | cut -d' ' -f1
}

make_python_environment() {
  local stamp=.venv/vitrail-setup.stamp python
  if [ -e .venv ] && ! is_new_enough .venv/bin/python; then
    say "the Python in .venv does not run or is older than 3.11: making .venv anew"
    rm -rf .venv
  fi
  if [ ! -e .venv ]; then
    python=$(find_python) || fail "no Python 3.11 or newer with venv and ensurepip" \
      "apt-get install python3 python3-venv, or set VITRAIL_PYTHON"
    say "making .venv with $python"
    "$python" -m venv .venv || { rm -rf .venv; fail "$python -m venv .venv" "apt-get install python3-venv"; }
  fi
  if [ "$(cat "$stamp" 2>/dev/null)" = "$(environment_key)" ]; then
    say "Python packages: all there"
    return
  fi
  say "installing the Python packages of pyproject.toml in the versions of constraints.txt"
  rm -f "$stamp"
  local pip=(.venv/bin/python -m pip --disable-pip-version-check --no-input -q install --progress-bar off
    --retries 5 -c constraints.txt)
  "${pip[@]}" scikit_build_core pathspec packaging </dev/null ||
    fail "pip could not install the build back end" "check the network and pip's index, then run this again"
  "${pip[@]}" --no-build-isolation --config-settings=wheel.cmake=false -e '.[test,lint]' </dev/null ||
    fail "pip could not install Vitrail and its packages" "read pip's message above; removing .venv starts afresh"
  environment_key >"$stamp"
}

lock
install_debian_packages
make_python_environment
say "ready"
