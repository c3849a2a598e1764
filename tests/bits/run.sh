#!/bin/sh
# Builds math_bits.cpp with every compiler and optimisation level and compares the hashes.
#   run.sh [directory for the programs]
# CXX_LIST and the flags below can be overridden in the environment. Exit status 1 on a difference.
set -eu

here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../.." && pwd)
out=${1:-$(mktemp -d)}
mkdir -p "$out"

compilers=${CXX_LIST:-g++ clang++}
common="-std=c++20 -ffp-contract=off -fno-math-errno -Wall -Wextra -Werror -I$root/runtime"
expected=$(cat "$here/math_bits.expected")
status=0

check() { # compiler, flags
  program="$out/math_bits"
  # shellcheck disable=SC2086 -- flags are several words
  $1 $common $2 "$here/math_bits.cpp" -o "$program"
  hash=$("$program")
  if [ "$hash" = "$expected" ]; then
    echo "same      $hash  $1 $2"
  else
    echo "DIFFERENT $hash  $1 $2"
    status=1
  fi
}

for compiler in $compilers; do
  if ! command -v "$compiler" >/dev/null; then
    echo "SKIPPED: $compiler is not installed"
    continue
  fi
  for level in -O0 -O2 -O3; do
    check "$compiler" "$level"
    check "$compiler" "$level -march=native"
  done
  check "$compiler" "-O2 -fno-trapping-math"
done
[ "$status" = 0 ] || echo "expected  $expected (tests/bits/math_bits.expected)"
exit "$status"
