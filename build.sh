#!/usr/bin/env bash
# Builds, tries and tests Gabarit on Debian 12. See usage below.
set -euo pipefail
cd "$(dirname "$0")"

usage() {
  cat <<'TEXT'
usage: ./build.sh COMMAND
  deps      install the Debian packages that are missing (as root or by sudo)
  build     deps, then the program: build/gabarit
  demo      build, then check the example motorcycle and say where the report lies
  test      build with everything, then run every test
  bench     build, then run the benchmarks
  sanitize  run the tests under AddressSanitizer and UndefinedBehaviorSanitizer
  lint      clang-format and clang-tidy
TEXT
}

packages=(g++ cmake ninja-build libcgal-dev libopenmesh-dev libyaml-cpp-dev libhpdf-dev libtbb-dev libcli11-dev
  nlohmann-json3-dev libfmt-dev libgmp-dev libmpfr-dev libssl-dev libpng-dev zlib1g-dev fonts-dejavu-core
  libocct-data-exchange-dev libgtest-dev libgmock-dev libbenchmark-dev poppler-utils)

# Installs what is missing of the packages given; says so; silent when all is there.
install() {
  local missing=()
  for package in "$@"; do
    dpkg-query -W -f='${Status}' "$package" 2>/dev/null | grep -q 'ok installed' || missing+=("$package")
  done
  [ ${#missing[@]} -gt 0 ] || return 0
  echo "Installing Debian packages: ${missing[*]}"
  local as_root=()
  if [ "$(id -u)" -ne 0 ]; then
    command -v sudo >/dev/null || { echo "This needs root: install sudo, or run as root: apt-get install ${missing[*]}" >&2; exit 1; }
    as_root=(sudo)
  fi
  "${as_root[@]}" apt-get update -qq
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "${missing[@]}" >/dev/null
}

deps() { install "${packages[@]}"; }

# configure FOLDER [cmake options]; a folder that a run was interrupted in is picked up where it stopped.
configure() { cmake -S . -B "$1" -G Ninja "${@:2}" >/dev/null; }

build() {
  deps
  configure build -DCMAKE_BUILD_TYPE=Release "$@"
  cmake --build build
}

demo() {
  build -DGABARIT_TESTS=OFF
  local model=out/motorcycle.stl report=out/motorcycle-report code=0
  mkdir -p out
  build/generate_motorcycle --out "$model"
  build/gabarit check "$model" --rules rules/library/motorcycle-column.yaml --out "$report" || code=$?
  echo
  echo "Report:     $report/report.pdf"
  echo "Violations: $report/violations.stl"
  echo "Data:       $report/results.json"
  # The example breaks the rule by design: exit code 1, a proven violation, is the right answer.
  if [ "$code" -ne 1 ]; then
    echo "The example should be found in violation (exit code 1); gabarit ended with $code" >&2
    exit 1
  fi
}

run_tests() {
  build -DGABARIT_TESTS=ON -DGABARIT_WERROR=ON
  ctest --test-dir build --output-on-failure --parallel "$(nproc)"
}

sanitize() {
  deps
  configure build-sanitize -DCMAKE_BUILD_TYPE=RelWithDebInfo -DCMAKE_CXX_FLAGS_RELWITHDEBINFO="-O1 -g1" \
    -DGABARIT_SANITIZE=address,undefined -DGABARIT_CUDA=OFF
  cmake --build build-sanitize
  ctest --test-dir build-sanitize --output-on-failure --parallel "$(nproc)"
}

bench() {
  build -DGABARIT_BENCH=ON
  for program in build/bench_*; do
    if [ -x "$program" ]; then "$program"; fi
  done
}

lint() {
  deps
  install clang-format-14 clang-tidy-14
  git ls-files '*.h' '*.cpp' | xargs clang-format-14 --dry-run --Werror
  configure build-lint -DCMAKE_BUILD_TYPE=Release -DGABARIT_CUDA=OFF
  git ls-files '*.cpp' | grep -v -E '^(tests|bench|gpu/tests|gpu/bench)/' |
    xargs -P "$(nproc)" -n 4 clang-tidy-14 -p build-lint --quiet
}

case "${1:-}" in
  deps) deps ;;
  build) build ;;
  demo) demo ;;
  test) run_tests ;;
  bench) bench ;;
  sanitize) sanitize ;;
  lint) lint ;;
  -h | --help | help) usage ;;
  *) usage >&2; exit 2 ;;
esac
