#!/usr/bin/env bash
# Compiles every header of models/ alone, then every entity, as boards do. Argument: a compiler and, after
# it, flags of its own. Headers below a folder `linux` are for Linux only, with libraries.
set -eu
cd "$(dirname "$0")/../../.."
flags=(-std=c++20 -O2 -fno-exceptions -fno-rtti -ffp-contract=off -Wall -Wextra -Wpedantic -Wconversion
  -Wshadow -Wdouble-promotion -Werror -I. -Iruntime -x c++)
linux=(-not -path '*/linux/*')
if [ "$("$@" -dumpmachine | grep -c linux)" = 1 ] && pkg-config --exists libftdi1; then
  linux=()
  flags+=("$(pkg-config --cflags-only-I libftdi1 | sed 's/ .*//; s/^-I/-isystem/')")
fi
mapfile -t headers < <(find models -name '*.hpp' "${linux[@]}" | sort)
# Headers that need the Open Dynamics Engine compile only if it is installed. Objects, engine nodes and engine states do
# not need it.
if ! echo '#include <ode/ode.h>' | "$@" -x c++ -fsyntax-only - 2>/dev/null; then
  mapfile -t headers < <(grep -LE '<ode/ode.h>|/(rigid_world|rigid_parts|open_dynamics_simulator).hpp>' "${headers[@]}")
fi
[ ${#headers[@]} -gt 0 ]
for header in "${headers[@]}"; do
  # Twice: the second time must not matter.
  printf '#include <%s>\n#include <%s>\n' "$header" "$header" | "$@" "${flags[@]}" -fsyntax-only - ||
    { echo "$header does not compile alone" >&2; exit 1; }
done
"$@" "${flags[@]}" -S -o /dev/null tests/unit/models/all_entities.cpp
echo "${#headers[@]} headers and every entity compiled with $1"
