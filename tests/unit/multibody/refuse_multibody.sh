#!/usr/bin/env bash
# Models that MultibodyEngine cannot simulate must not compile, and the compiler must say why. Argument: a compiler.
set -eu
cd "$(dirname "$0")/../../.."
failures=0
compile() {
  printf '#include "tests/unit/multibody/robots.hpp"\nnamespace eagerx::models {\nusing namespace testing;\nusing Box = BoxOf<double>;\n%s\n}\n' "$1" |
    "$compiler" -std=c++20 -I. -Iruntime -fsyntax-only -x c++ - 2>&1
}
# refuse WORDS MEMBERS: the box with these members instead of its own must not compile, with WORDS.
refuse() {
  local output
  if output=$(compile "struct Wrong : Box { $2 }; template class MultibodySimulator<Wrong>;"); then
    echo "compiles, but must not: $2" >&2
    failures=$((failures + 1))
  elif ! grep -qF -- "$1" <<<"$output"; then
    printf 'does not say "%s":\n%s\n' "$1" "$output" >&2
    failures=$((failures + 1))
  fi
}

compiler=$1
compile 'template class MultibodySimulator<Box>;'
two='static constexpr std::array<RigidBody, 2> kBodies = {{{.name = "box"}, {.name = "other"}}};'
joint='static constexpr std::array<RigidJoint, 1> kJoints ='
refuse '`mimics` names a hinge or slider' \
  "$two $joint {{{.parent = \"box\", .child = \"other\", .mimics = \"it\"}}};"
refuse 'one body of an object may be free' "$two"
refuse 'joints are hinges, sliders and fixed ones' \
  "$two $joint {{{.kind = JointKind::ball, .parent = \"box\", .child = \"other\"}}};"
refuse 'an object with a free body has no joint on the world' "$two $joint {{{.child = \"other\"}}};"
refuse 'names a body that it does not have' "$joint {{{.child = \"bix\"}}};"
refuse 'bodies of an object do not touch each other' 'static constexpr bool kTouchesItself = true;'
refuse '`kPairs` names spheres and capsules of bodies' \
  'static constexpr std::array<std::array<const char*, 2>, 1> kPairs = {{{"box", "box"}}};'
refuse 'heights of the ground are above a level plane' \
  'static constexpr HeightField<2, 2> kHeights{}; static constexpr std::array<RigidGeometry, 1> kGeometries = {{{.kind = ShapeKind::plane, .axis = {{0.0, 0.6, 0.8}}}}};'
refuse 'heights of the ground need a plane' \
  'static constexpr HeightField<2, 2> kHeights{}; static constexpr std::array<RigidGeometry, 0> kGeometries = {};'
refuse 'an object touches one plane' \
  'static constexpr std::array<RigidGeometry, 2> kGeometries = {{{.kind = ShapeKind::plane}, {.kind = ShapeKind::plane}}};'
refuse 'so it has no configure()' 'template <class S> static void configure(S& simulator) { simulator.nothing(); }'
[ $failures -eq 0 ] && echo "all models that cannot be simulated are refused by $compiler"
