#!/usr/bin/env bash
# try_bundle.sh ARCHIVE: unpacked somewhere else, with an empty environment, it checks a cube that breaks the rule.
set -euo pipefail

place=$(mktemp -d)
trap 'rm -r "$place"' EXIT
tar -C "$place" -xzf "$1"
program=("$place"/*/bin/gabarit)
if ldd "${program[0]}" | grep -E '=> ' | grep -vE "$place/|/lib(c|m|dl|rt|pthread|resolv|util)\.so"; then
  echo "The bundle uses these libraries of the system" >&2
  exit 1
fi
printf '%s\n' OFF '8 6 0' '0 0 0' '90 0 0' '90 90 0' '0 90 0' '0 0 90' '90 0 90' '90 90 90' '0 90 90' \
  '4 0 3 2 1' '4 4 5 6 7' '4 0 1 5 4' '4 1 2 6 5' '4 2 3 7 6' '4 3 0 4 7' >"$place/cube.off"
code=0
(cd "$place" && env -i "${program[0]}" check cube.off --rules motorcycle-column --out report >log 2>&1) || code=$?
if [ "$code" -ne 1 ] || [ ! -s "$place/report/violations.stl" ]; then
  cat "$place/log" >&2
  echo "A cube breaks the rule: the unpacked program should have ended with 1, not with $code" >&2
  exit 1
fi
if [ ! -s "$place"/*/share/gabarit/fonts/DejaVuSans.ttf ]; then
  echo "The bundle brings no fonts" >&2
  exit 1
fi
if ! pdffonts "$place/report/report.pdf" | grep -q DejaVu; then
  echo "The unpacked program did not find its fonts" >&2
  exit 1
fi
