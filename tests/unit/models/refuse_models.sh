#!/usr/bin/env bash
# Wrong configurations must not compile, and the compiler must say why in the words of the manifest.
# Argument: a compiler.
set -eu
cd "$(dirname "$0")/../../.."
failures=0

# compile CODE: what the compiler says to CODE among the models, its exit status.
among='"tests/unit/models/all_entities.cpp"'
compile() {
  printf "#include $among"'\nnamespace eagerx::models {\nusing namespace testing;\n%s\n}\n' "$1" |
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
  refuse "$1" "struct Wrong { static constexpr int order = $2; static constexpr auto initial = FilterInitial::zero; static constexpr auto type = FilterType::$3;
    static constexpr std::array<double, $4> cutoff_hz = {$5}; };
    template class ButterworthFilter<eagerx::models::FilterIo<float, Wrong>>;"
}

compiler=$1
compile 'struct Right { static constexpr int order = 2; static constexpr auto type = FilterType::lowpass;
    static constexpr auto initial = FilterInitial::zero; static constexpr std::array<double, 1> cutoff_hz = {49.0}; };
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
cast() { # SAYS: a model on rodas4 whose derivative leaves Io::Real
  echo "template <class Io> struct Cast {
    using Real = typename Io::Real;
    static constexpr std::size_t kStates = 1, kInputs = 1, kParameters = 1;
    $1
    static constexpr Array<Real, 1> default_parameters() { return {{Real(1)}}; }
    static Array<Real, 1> derivative(const Array<Real, 1>&, const Array<Real, 1>&, Array<Real, 1> x) {
      return {{Real(static_cast<int>(x[0]))}};
    }
  };
  struct Rodas4Config : OdeConfig { static constexpr auto method = OdeMethod::rodas4; };
  inline void use(OdeSimulator<Cast<PendulumModelIo<float>>>& s) { tick<EngineIo<float, Rodas4Config>>(s); }"
}
refuse 'a number with derivatives cannot become a plain one' "$(cast '')"
compile "$(cast 'static constexpr bool dual_numbers = false;')"
compile "$(cast 'template <class P, class U> static Array<Real, 1, 1> jacobian(P, U, Array<Real, 1>) { return {{Real(0)}}; }')"
# refuse_block WORDS BLOCK IO CONFIG: a block with another configuration than that of its Io.
refuse_block() {
  local header among='"tests/unit/models/dynamic_block_io.hpp"'
  header=$(sed 's/\([a-z]\)\([A-Z2]\)/\1_\2/g' <<<"$2" | tr '[:upper:]' '[:lower:]')
  among+=$'\n'"#include <models/nodes/$header/$header.hpp>"
  refuse "$1" "struct Wrong : blocks::$3 { struct Config : blocks::$3::Config { $4 }; };
    template class $2<Wrong>;"
}
one() { echo "static constexpr std::array<double, 1> $1 = {$2};"; }
two() { echo "static constexpr std::array<double, 2> $1 = {$2};"; }
refuse_block '`gains` has one value, or one for each input' Sum 'SumIo<float>' "$(two gains '1, 2')"
refuse_block '`low` is not above `high`' Saturation 'LimitsIo<float>' "$(one low 3)"
refuse_block '`step` is above 0' Quantizer 'QuantizerIo<float>' "$(one step 0)"
refuse_block 'each value of `x` is above the one before' LookupTable 'TableIo<float>' \
  'static constexpr std::array<double, 4> x = {0, 1, 1, 2};'
refuse_block '`sizes` are together the number of elements' Demux 'DemuxIo<float>' \
  'static constexpr std::array<int, 3> sizes = {1, 2, 2};'
refuse_block '`a` has order x order values' StateSpace 'SpaceIo<float>' "$(two a '1, 2')"
refuse_block 'the first value of `a` is not 0' DiscreteTransferFunction 'TransferIo<float>' "$(two a '0, 1')"
refuse_block '`delay` is not above `max_delay`' TransportDelay 'DelayIo<float>' 'static constexpr double delay = 1.0;'
refuse_block '`gain` has `rows` times as many values' StateFeedback 'FeedbackIo<float>' "$(two gain '1, 2')"
refuse_block '`p` and `q` have a value for each state' KalmanFilter 'SystemIo<float>' "$(two q '1, 2')"
refuse_block 'the lowest output is below the highest' PidController 'SetpointPidIo<float>' 'static constexpr double low = 200.0;'
refuse_block '`sizes` are together the number' Demux 'DemuxIo<float>' 'static constexpr std::array<int, 2> sizes = {1, 2};'
among='<models/nodes/mux/mux.hpp>
#include "tests/unit/models/block_io.hpp"'
refuse '`size` is the number of elements of all inputs together' \
  'struct Wrong : blocks::MuxIo<float> { struct Outputs { Array<float, 5>& y; }; };
   template class Mux<Wrong>;'
[ $failures -eq 0 ] && echo "all wrong configurations are refused by $compiler"
