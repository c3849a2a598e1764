// The same as mixer.py, number by number.
#pragma once

#include <cstddef>
#include <cstdint>
#include <eagerx/message.hpp>
#include <eagerx/rate.hpp>

namespace languages_test {

template <class Io>
class Mixer {
 public:
  void reset(const typename Io::States& /*states*/) {
    seen_ = 0;
    for (float& value : mean_) value = 0.0F;
  }
  void callback(const eagerx::Tick& tick, const typename Io::Inputs& in,
                typename Io::Outputs& out) {
    using A = typename decltype(Io::Inputs::a)::value_type;
    constexpr auto kWeight = static_cast<float>(Io::Config::weight);
    float sums[2] = {0.0F, 0.0F};
    for (std::uint32_t i = 0; i < in.a.size(); ++i) {
      for (std::size_t k = 0; k < eagerx::size_of<A>; ++k)
        sums[0] = sums[0] + eagerx::element(in.a[i], k);
    }
    for (std::uint32_t i = 0; i < in.b.size(); ++i) sums[1] = sums[1] + in.b[i];
    for (std::size_t k = 0; k < 2; ++k) {
      mean_[k] = kWeight * mean_[k] + sums[k];
      eagerx::element(out.mean, k) = mean_[k];
    }
    seen_ += in.a.size() + in.b.size();
    out.seen = static_cast<std::int64_t>(seen_);
    eagerx::element(out.high, 0) = mean_[0] > 0.0F;
    eagerx::element(out.high, 1) = mean_[1] > 0.0F;
    eagerx::element(out.high, 2) = tick.n % 2 == 1;
  }

 private:
  float mean_[2]{};
  std::uint64_t seen_ = 0;
};

}  // namespace languages_test
