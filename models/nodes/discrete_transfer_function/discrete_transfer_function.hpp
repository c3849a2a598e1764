// A filter from the coefficients of its transfer function.
#pragma once

#include <array>
#include <cstddef>
#include <eagerx/rate.hpp>
#include <models/nodes/block.hpp>

namespace eagerx::models {

/// Y(z)/X(z) = (b[0] + b[1]·z⁻¹ + …)/(a[0] + a[1]·z⁻¹ + …), element by element, in transposed
/// direct form II as scipy.signal.lfilter; in δ = z − 1 where the coefficients of z cancel, that
/// is, where a is nearly 0 at z = 1, as of low corners and integrators (Goodall: Perspectives on
/// processing for real-time control, 2001). The last finite signal replaces one that is not finite;
/// before the first it is 0. An overflow resets the state.
template <class Io>
class DiscreteTransferFunction {
 public:
  void reset(const typename Io::States& /*states*/) {
    held_ = {};
    memory_ = {};
  }

  void callback(const Tick& /*tick*/, const typename Io::Inputs& in, typename Io::Outputs& out) {
    static_assert(kA.size() > 0 && Io::Config::a[0] != 0.0,
                  "DiscreteTransferFunction: the first value of `a` is not 0");
    for (std::size_t i = 0; i < kSize; ++i) {
      const Real x = held_[i](newest<Real>(in.signal, i, held_[i].last));
      Memory& memory = memory_[i];  // the last one stays 0
      const Real y = Real(kB[0]) * x + memory[0].value;
      auto finite = eagerx::isfinite(y);
      for (std::size_t k = 0; k < kOrder; ++k) {
        const Real next = (memory[k + 1].value + Real(kB[k + 1]) * x) - Real(kA[k + 1]) * y;
        if constexpr (kCancels) {
          memory[k] = memory[k].plus(next);
        } else {
          memory[k].set(next);
        }
        finite = finite && eagerx::isfinite(memory[k].value);
      }
      change_where<Real>(!finite, memory, [&] { memory = {}; });
      put(out.y, i, y);
    }
  }

 private:
  using Real = typename Io::Real;
  static constexpr std::size_t kSize = elements_of<decltype(Io::Outputs::y)>;
  static constexpr std::size_t kOrder =
      (Io::Config::a.size() > Io::Config::b.size() ? Io::Config::a.size() : Io::Config::b.size()) -
      1;

  using Memory = std::array<CompensatedSum<Real>, kOrder + 1>;

  /// Divided by a[0], and as many of either.
  template <std::size_t N>
  static constexpr auto divided(const std::array<double, N>& list) {
    std::array<double, kOrder + 1> result{};
    constexpr double kFirst = Io::Config::a[0];
    if (kFirst == 0.0) return result;  // refused above
    for (std::size_t i = 0; i < N; ++i) result[i] = list[i] / kFirst;
    return result;
  }
  static constexpr bool kCancels = [] {
    double sum = 0.0;
    double size = 0.0;
    for (const double a : divided(Io::Config::a)) {
      sum += a;
      size += a < 0.0 ? -a : a;
    }
    return sum < 0.02 * size && -sum < 0.02 * size;
  }();
  /// The coefficients of z, or of z = 1 + δ by Horner's division.
  template <std::size_t N>
  static constexpr auto normalised(const std::array<double, N>& list) {
    auto result = divided(list);
    for (std::size_t last = kOrder; kCancels && last > 0; --last) {
      for (std::size_t k = 1; k <= last; ++k) result[k] += result[k - 1];
    }
    return constants<Real>(result);
  }
  static constexpr auto kB = normalised(Io::Config::b);
  static constexpr auto kA = normalised(Io::Config::a);

  std::array<Held<Real>, kSize> held_{};
  std::array<Memory, kSize> memory_{};
};

}  // namespace eagerx::models
