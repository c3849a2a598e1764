// Errors of a sensor: scale, offset, drift, noise, drop-outs.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <eagerx/random.hpp>
#include <eagerx/rate.hpp>
#include <models/nodes/action_limits/per_element.hpp>
#include <models/nodes/block.hpp>

namespace eagerx::models {

/// y = quantised(clamp(scale·signal + bias + drift·t + noise·normal + spread·even, low, high)),
/// element by element; with the probability `drop_out` the y of the tick before. A reset may set
/// scale, bias, drift and the seed. Zero before the first signal; NaN passes. Random numbers
/// (Philox) come from the seed, the tick and the element alone, lane by lane.
template <class Io>
class SensorModel {
 public:
  void reset(const typename Io::States& states) {
    static_assert(is_one_or_each(kScale, kSize) && is_one_or_each(kBias, kSize) &&
                      is_one_or_each(kDrift, kSize) && is_one_or_each(kNoise, kSize) &&
                      is_one_or_each(kSpread, kSize),
                  "SensorModel: `scale`, `bias`, `drift`, `noise` and `spread` have one value, or "
                  "one for each element");
    for (std::size_t i = 0; i < kSize; ++i) {
      last_[i] = Real(0);
      scale_[i].reset(each<Real>(kScale, i));
      bias_[i].reset(each<Real>(kBias, i));
      drift_[i].reset(each<Real>(kDrift, i));
      if constexpr (requires { states.scale; }) set(scale_[i], states.scale, i, kScale.size());
      if constexpr (requires { states.bias; }) set(bias_[i], states.bias, i, kBias.size());
      if constexpr (requires { states.drift; }) set(drift_[i], states.drift, i, kDrift.size());
    }
    if constexpr (requires { states.seed; }) {
      if (states.seed) difference_ = CountOf<Real>(*states.seed) ^ CountOf<Real>(kSeed);
    }
  }

  template <class AnyTick = Tick>
  void callback(const AnyTick& tick, const typename Io::Inputs& in, typename Io::Outputs& out) {
    const TruthOf<Real> missing = in.signal.empty();
    change_where<Real>(!missing, last_, [&] { measure(tick, in); });
    for (std::size_t i = 0; i < kSize; ++i) put(out.y, i, last_[i]);
  }

 private:
  using Real = typename Io::Real;
  using Lane = LaneOf<Real>;

  void measure(const auto& tick, const typename Io::Inputs& in) {
    const auto time = seconds_at<typename Io::Rate, Real>(tick);
    std::array<Real, kSize> noise{};
    std::array<Real, kSize> chance{};
    std::array<Real, kSize> even{};
    for (int k = 0; k < lanes<Real>; ++k) sample(tick, k, noise, chance);
    for (int k = 0; kSpreads && k < lanes<Real>; ++k) sample_even(tick, k, even);
    for (std::size_t i = 0; i < kSize; ++i) {
      const Real true_value = newest<Real>(in.signal, i);
      Real y = ((scale_[i].value * true_value + bias_[i].value) + drift_[i].value * time) +
               each<Real>(kNoise, i) * noise[i];
      if constexpr (kSpreads) y = y + each<Real>(kSpread, i) * even[i];
      y = eagerx::clamp(y, Real(constant<Real>(Io::Config::low)),
                        Real(constant<Real>(Io::Config::high)));
      if constexpr (Io::Config::resolution > 0.0) {
        y = eagerx::quantized(y, Real(constant<Real>(Io::Config::resolution)));
      }
      last_[i] = select(chance[i] < Real(kDropOut), last_[i], y);
    }
  }

  static constexpr std::size_t kSize = elements_of<decltype(Io::Outputs::y)>;
  static constexpr auto kScale = constants<Real>(Io::Config::scale);
  static constexpr auto kBias = constants<Real>(Io::Config::bias);
  static constexpr auto kDrift = constants<Real>(Io::Config::drift);
  static constexpr auto kNoise = constants<Real>(Io::Config::noise);
  static constexpr auto kSpread = constants<Real>(Io::Config::spread);
  static constexpr bool kSpreads = [] {
    for (const Lane width : kSpread) {
      if (width != Lane(0)) return true;
    }
    return false;
  }();
  static constexpr auto kDropOut = constant<Real>(Io::Config::drop_out);
  static constexpr auto kSeed = static_cast<std::uint32_t>(Io::Config::seed);
  static_assert(Io::Config::low < Io::Config::high, "SensorModel: `low` is below `high`");

  template <class State>
  static void set(ResetNumber<Real>& number, const State& state, std::size_t i, std::size_t size) {
    if (state) number.set(static_cast<Real>(element(*state, size == 1 ? 0 : i)));
  }

  /// For lane `k`: a normal number and one in [0, 1) for each element, whether they are used or
  /// not, so that one parameter does not change the samples of another.
  void sample(const auto& tick, int k, std::array<Real, kSize>& noise,
              std::array<Real, kSize>& chance) {
    constexpr std::uint32_t kWords = sizeof(Lane) == 4 ? 3 : 6;  // of one element
    constexpr std::uint32_t kBlocks = (static_cast<std::uint32_t>(kSize) * kWords + 3) / 4;
    const auto seed = static_cast<std::uint32_t>(lane(difference_, k)) ^ kSeed;
    auto random = Random::of_step({seed, 0, 0}, entity_id("SensorModel"), tick.in_lane(k), kBlocks);
    for (std::size_t i = 0; i < kSize; ++i) {
      set_noise_lane(noise[i], k, random.normal(Lane(0), Lane(1)));
      set_lane(chance[i], k, random.uniform(Lane(0), Lane(1)));
    }
  }

  /// Of a stream of its own: what `sample` gives stays as it is without `spread`.
  void sample_even(const auto& tick, int k, std::array<Real, kSize>& even) {
    constexpr std::uint32_t kWords = sizeof(Lane) == 4 ? 1 : 2;  // of one element
    constexpr std::uint32_t kBlocks = (static_cast<std::uint32_t>(kSize) * kWords + 3) / 4;
    const auto seed = static_cast<std::uint32_t>(lane(difference_, k)) ^ kSeed;
    auto random =
        Random::of_step({seed, 0, 0}, entity_id("SensorModel/even"), tick.in_lane(k), kBlocks);
    for (std::size_t i = 0; i < kSize; ++i)
      set_noise_lane(even[i], k, random.uniform(Lane(-1), Lane(1)));
  }

  std::array<ResetNumber<Real>, kSize> scale_{};
  std::array<ResetNumber<Real>, kSize> bias_{};
  std::array<ResetNumber<Real>, kSize> drift_{};
  std::array<Real, kSize> last_{};
  CountOf<Real> difference_{};  // bits in which the seed differs from the parameter
};

}  // namespace eagerx::models
