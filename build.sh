#!/usr/bin/env bash
# Builds and runs Gabarit: ./build.sh [deps | build | demo | test | bench]
set -euo pipefail
cd "$(dirname "$0")"

packages=(g++ cmake ninja-build libcgal-dev libopenmesh-dev libyaml-cpp-dev libhpdf-dev libtbb-dev libcli11-dev
  nlohmann-json3-dev libfmt-dev libgmp-dev libmpfr-dev libssl-dev libpng-dev zlib1g-dev fonts-dejavu-core
  libgtest-dev libgmock-dev libbenchmark-dev poppler-utils)

deps() {
  local missing=()
  for package in "${packages[@]}"; do
    dpkg-query -W -f='${Status}' "$package" 2>/dev/null | grep -q 'ok installed' || missing+=("$package")
  done
  if [ ${#missing[@]} -eq 0 ]; then return; fi
  echo "Installing Debian packages: ${missing[*]}"
  local as_root=()
  if [ "$(id -u)" -ne 0 ]; then as_root=(sudo); fi
  "${as_root[@]}" apt-get update -qq
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "${missing[@]}"
}

build() {
  deps
  cmake -S . -B build -G Ninja -DCMAKE_BUILD_TYPE=Release -DGABARIT_TESTS=ON "$@"
  cmake --build build
}

run_tests() {
  build
  ctest --test-dir build --output-on-failure --parallel "$(nproc)"
}

case "${1:-build}" in
  deps) deps ;;
  build) build ;;
  test) run_tests ;;
  *) echo "usage: ./build.sh [deps | build | demo | test | bench]" >&2; exit 2 ;;
esac
