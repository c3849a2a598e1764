#!/usr/bin/env bash
# Wrong configurations must not compile, and the compiler must say why in the words of the manifest.
# Argument: a compiler.
set -eu
cd "$(dirname "$0")/../../.."
failures=0

# compile CODE: what the compiler says to CODE among the models, its exit status.
compile() {
  printf '#include "tests/unit/models/all_entities.cpp"\nnamespace eagerx::models {\nusing namespace testing;\n%s\n}\n' "$1" |
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

# refuse_filter WORDS ORDER TYPE COUNT FREQUENCIES, at 100 Hz
refuse_filter() {
  refuse "$1" "struct Wrong { static constexpr int order = $2; static constexpr auto type = FilterType::$3;
    static constexpr std::array<double, $4> cutoff_hz = {$5}; };
    template class ButterworthFilter<eagerx::models::FilterIo<float, Wrong>>;"
}

compiler=$1
compile 'struct Right { static constexpr int order = 2; static constexpr auto type = FilterType::lowpass;
    static constexpr std::array<double, 1> cutoff_hz = {49.0}; };
    template class ButterworthFilter<eagerx::models::FilterIo<float, Right>>;' # a right one compiles
refuse_filter '`order` must be 1 to 8' 9 lowpass 1 10.0
refuse_filter '`cutoff_hz` must be one frequency for lowpass and highpass, and two for' 2 lowpass 2 '10.0, 20.0'
refuse_filter '`cutoff_hz` must be one frequency for lowpass and highpass, and two for' 2 bandpass 1 10.0
refuse_filter 'must be above 0 and below half the rate' 2 lowpass 1 50.0
refuse_filter 'must be above 0 and below half the rate' 2 bandstop 2 '0.0, 20.0'
refuse_filter 'the first frequency in `cutoff_hz` must be below the second' 2 bandpass 2 '20.0, 20.0'
refuse '`default_action` must have as many elements as the action' \
  'struct Wrong : OdeInputIo<PendulumSimulator<float>, Latest> {
     struct Config { static constexpr std::array<double, 2> default_action = {0.0, 0.0}; }; };
   template class OdeInput<Wrong>;'
refuse '`idx` is beyond the end of `observation_array`' \
  'struct Wrong : FloatOutputIo<PendulumSimulator<float>, Latest> {
     struct Config { static constexpr int idx = 2; }; };
   template class FloatOutput<Wrong>;'
refuse 'an element of `indices` is not a parameter of the model' \
  'struct Wrong : OneParameterIo<PendulumSimulator<float>> {
     struct Config { static constexpr std::array<int, 1> indices = {8}; }; };
   template struct OdeParameters<Wrong>;'
refuse 'the model has no attribute called `attribute`' \
  'struct Wrong : MassIo<GymPendulumSimulator<float>> {
     struct Config { static constexpr const char* attribute = "mass"; }; };
   template struct SetGymAttribute<Wrong>;'
refuse 'the window of `signal` must be at least `N`' \
  'template class WindowedButterworth<testing::WindowedIo<float, Stop8, eagerx::Rate<100>, 7, true>>;'
refuse '`size` must be one more than the message has elements' \
  'template struct AngleDecomposition<testing::ProcessorIo<float, Array<float, 4>, Array<float, 4>>>;'
refuse '`filtered` must have as many elements as `signal`' \
  'template class MovingAverageFilter<MeanIo<float, TwoFloats, float>>;'
[ $failures -eq 0 ] && echo "all wrong configurations are refused by $compiler"
