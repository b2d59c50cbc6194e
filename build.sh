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
  bundle    out/gabarit-VERSION-linux-x86_64.tar.gz: runs on any Linux with glibc 2.36, with and without a GPU;
            tried in another folder with an empty environment; and a Debian package beside it
  sanitize  run the tests under AddressSanitizer and UndefinedBehaviorSanitizer
  lint      clang-format and clang-tidy
TEXT
}

packages=(g++ cmake ninja-build libcgal-dev libopenmesh-dev libyaml-cpp-dev libhpdf-dev libtbb-dev libcli11-dev
  nlohmann-json3-dev libfmt-dev libgmp-dev libmpfr-dev libssl-dev libpng-dev zlib1g-dev fonts-dejavu-core
  libocct-data-exchange-dev libfontconfig-dev libgtest-dev libgmock-dev libbenchmark-dev poppler-utils
  fonts-ipafont-gothic)

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
  LSAN_OPTIONS="suppressions=$PWD/tests/leaks.supp:print_suppressions=0" \
    ctest --test-dir build-sanitize --output-on-failure --parallel "$(nproc)"
}

bench() {
  build -DGABARIT_BENCH=ON
  for program in build/bench_*; do
    if [ -x "$program" ]; then "$program"; fi
  done
}

# The GPUs that a bundle has code for (and PTX of the newest, for those to come), as far as this nvcc knows them.
bundle_architectures() {
  local nvcc known wanted=()
  nvcc=$(command -v nvcc || echo /usr/local/cuda/bin/nvcc)
  if [ ! -x "$nvcc" ]; then echo "No nvcc here: this bundle computes on the CPU only." >&2; return; fi
  known=$("$nvcc" --list-gpu-arch)
  for architecture in 75 80 86 89; do
    if grep -qx "compute_$architecture" <<<"$known"; then wanted+=("$architecture-real")
    else echo "This nvcc no longer makes code for sm_$architecture." >&2; fi
  done
  local IFS=';'
  echo "-DCMAKE_CUDA_ARCHITECTURES=${wanted[*]};90"
  # The code of six kinds of GPU is most of the program: as small as this nvcc can pack it.
  if "$nvcc" --help | grep -q -- --compress-mode; then echo "-DCMAKE_CUDA_FLAGS=--compress-mode=size"; fi
}

# licence_texts FOLDER: of every library and font in the bundle, and of what was compiled in.
licence_texts() {
  local folder=$1/share/doc/gabarit/licences libraries=("$1"/lib/*) file package cuda
  mkdir -p "$folder"
  {
    dpkg -S "${libraries[@]/#*\//*/x86_64-linux-gnu/}" | cut -d: -f1
    printf '%s\n' fonts-dejavu-core libcgal-dev libmpfr6 nlohmann-json3-dev libcli11-dev libssl-dev
  } | sort -u | while read -r package; do
    cp "/usr/share/doc/$package/copyright" "$folder/$package.txt" ||
      { echo "There is no licence text of $package" >&2; exit 1; }
  done
  # Of Boost's 50,000 lines only what its headers stand under.
  sed -n '/^ Boost Software License - Version 1.0/,/^$/p' /usr/share/doc/libboost1.74-dev/copyright >"$folder/libboost1.74-dev.txt"
  # The texts that these refer to.
  { grep -rhoE '/usr/share/common-licenses/[A-Za-z0-9.-]*[A-Za-z0-9]' "$folder" || true; } | sort -u |
    while read -r file; do if [ -f "$file" ]; then cp -L "$file" "$folder/"; fi; done
  cuda=$(find -L /usr/local/cuda -path '*cuda_runtime*' -type f -iname 'license*' -print -quit 2>/dev/null || true)
  if [ -z "$cuda" ]; then cuda=$(find -L /usr/local/cuda -maxdepth 2 -type f -iname 'EULA*' -print -quit 2>/dev/null || true); fi
  if [ -n "$cuda" ]; then cp "$cuda" "$folder/cuda-runtime.txt"; fi
  # Each text once.
  local texts=("$folder"/*) i
  for ((i = 1; i < ${#texts[@]}; ++i)); do
    for file in "${texts[@]:0:i}"; do
      if [ ! -L "$file" ] && cmp -s "$file" "${texts[i]}"; then ln -sf "${file##*/}" "${texts[i]}"; break; fi
    done
  done
}

bundle() {
  deps
  install dpkg-dev
  local name folder archive options=(-DCMAKE_BUILD_TYPE=Release -DGABARIT_TESTS=OFF)
  mapfile -t -O "${#options[@]}" options < <(bundle_architectures)
  configure build-bundle "${options[@]}" -DGABARIT_BUNDLE=ON -U'OPENSSL_*'
  cmake --build build-bundle --target gabarit
  name=gabarit-$(build-bundle/gabarit --version | grep -oE '[0-9.]+' | head -1)-linux-x86_64
  folder=out/$name archive=out/$name.tar.gz
  rm -rf "$folder"
  cmake --install build-bundle --prefix "$folder" --strip >/dev/null
  licence_texts "$folder"
  tar -C out --sort=name --owner=0 --group=0 --numeric-owner --mtime="@${SOURCE_DATE_EPOCH:-0}" -c "$name" |
    gzip -9n >"$archive"
  tests/bundle/try_bundle.sh "$archive"
  if [ "$(du -sb "$folder" | cut -f1)" -ge 64000000 ]; then
    echo "$folder has $(du -sb "$folder" | cut -f1) bytes, more than 64 MB" >&2
    exit 1
  fi
  # The Debian package takes OpenSSL from the system again.
  configure build-bundle "${options[@]}" -DGABARIT_BUNDLE=OFF -DCMAKE_INSTALL_PREFIX=/usr -U'OPENSSL_*'
  cmake --build build-bundle --target gabarit
  (cd build-bundle && cpack -B "$PWD/packages" >/dev/null)
  cp build-bundle/packages/*.deb out/
  du -sh "$folder" "$archive" out/*.deb
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
  bundle) bundle ;;
  sanitize) sanitize ;;
  lint) lint ;;
  -h | --help | help) usage ;;
  *) usage >&2; exit 2 ;;
esac
