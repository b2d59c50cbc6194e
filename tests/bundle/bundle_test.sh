#!/usr/bin/env bash
# bundle_test.sh BUILD_FOLDER: packs the program that is built there as a bundle is packed, and tries it elsewhere.
set -euo pipefail

place=$(mktemp -d)
trap 'rm -r "$place"' EXIT
cmake --install "$1" --component bundle --prefix "$place/gabarit" --strip >/dev/null
tar -C "$place" -c gabarit | gzip -1 >"$place/bundle.tar.gz"
rm -r "$place/gabarit"
"$(dirname "$0")/try_bundle.sh" "$place/bundle.tar.gz"
