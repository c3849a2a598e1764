#!/bin/sh
# Functions that the linker may take from any file must not be in those that are compiled for AVX: a machine without it
# would run them. What depends on the width of a register is in one file only.
#   tests/unit/train/symbols.sh OBJECT...
found=0
for object in "$@"; do
  case $object in *kernels_avx*) ;; *) continue ;; esac
  found=1
  shared=$(nm -C "$object" | grep ' W ' | grep -v '\(KernelsOf<\|Registers<[a-z ]*, \|Simd<float, 16ul, \)\(8\|16\)ul')
  if [ -n "$shared" ]; then
    echo "$object:"
    echo "$shared"
    exit 1
  fi
done
if [ $found = 0 ] && [ "$(uname -m)" = x86_64 ]; then
  echo "there are no kernels for AVX among: $*"
  exit 1
fi
