#!/usr/bin/env bash
# Wrong names in configurations and scenes must not compile, and the compiler must say why. Argument: a compiler.
set -eu
cd "$(dirname "$0")/../../.."
failures=0
compile() {
  printf '#include "tests/unit/rigid/nodes_io.hpp"\nnamespace eagerx::models {\nusing namespace testing;\nusing Arm = OpenDynamicsSimulator<ArmModel>;\nusing Box = OpenDynamicsSimulator<BoxModel>;\n%s\n}\n' "$1" |
    "$compiler" -std=c++20 -I. -Iruntime -fsyntax-only -x c++ - 2>&1
}
# refuse WORDS CODE: compiling CODE must fail with WORDS.
refuse() {
  local output
  if output=$(compile "$2"); then
    echo "compiles, but must not: $2" >&2
    failures=$((failures + 1))
  elif ! grep -qF -- "$1" <<<"$output"; then
    printf 'does not say "%s":\n%s\n' "$1" "$output" >&2
    failures=$((failures + 1))
  fi
}

compiler=$1
compile 'auto a = &JointPositionSensor<JointsIo<Arm, 2>>::callback; auto b = &BodyPoseSensor<BodyIo<Box, 7>>::callback;'
refuse '`joints` names a joint that the object'"'"'s model does not have' \
  'struct Wrong : JointsIo<Arm, 2> { struct Config { static constexpr const char* joints = "elbow wrist"; }; };
   auto use = &JointPositionSensor<Wrong>::callback;'
refuse '`size` must be how many numbers the joints have together' 'auto use = &JointPositionSensor<JointsIo<Arm, 3>>::callback;'
refuse '`body` is not a body of the object'"'"'s model' \
  'struct Wrong : BodyIo<Box, 7> { struct Config { static constexpr const char* body = "bax"; }; };
   auto use = &BodyPoseSensor<Wrong>::callback;'
refuse '`geometry` is not a geometry of the object'"'"'s model' \
  'struct Wrong : GeometryIo<Box> { struct Config { static constexpr const char* geometry = "wall"; }; };
   template class ContactForceSensor<Wrong>;'
refuse '`body` hangs on a joint: use JointState' \
  'struct Wrong : BodyIo<Arm, 7> { struct Config { static constexpr const char* body = "upper_arm"; }; };
   template struct BodyPose<RigidStateIo<Wrong, Array<float, 7>>>;'
refuse 'a joint or geometry of the model names a body that it does not have' \
  'struct Wrong : BoxModel { static constexpr std::array<RigidJoint, 1> kJoints = {{{.name = "j", .child = "bix"}}}; };
   template class OpenDynamicsSimulator<Wrong>;'
refuse 'joints must make a tree, with parents before their children' \
  'struct Wrong : ArmModel { static constexpr std::array<RigidJoint, 2> kJoints = {{
     {.name = "elbow", .parent = "upper_arm", .child = "lower_arm"}, {.name = "shoulder", .child = "upper_arm"}}}; };
   template class OpenDynamicsSimulator<Wrong>;'
refuse 'heights of the ground need a plane that they are above, a level one' \
  'struct Wrong : BoxModel { static constexpr HeightField<2, 2> kHeights{};
     static constexpr std::array<RigidGeometry, 1> kGeometries = {{{.kind = ShapeKind::plane, .axis = {{0.0, 0.6, 0.8}}}}}; };
   template class OpenDynamicsSimulator<Wrong>;'
refuse 'heights of the ground need a plane that they are above, a level one' \
  'struct Wrong : BoxModel { static constexpr HeightField<2, 2> kHeights{}; static constexpr std::array<RigidGeometry, 0> kGeometries = {}; };
   template class OpenDynamicsSimulator<Wrong>;'
[ $failures -eq 0 ] && echo "all wrong names are refused by $compiler"
