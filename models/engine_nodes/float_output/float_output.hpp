// One element of an array.
#pragma once

#include <cstddef>
#include <eagerx/message.hpp>
#include <eagerx/rate.hpp>
#include <type_traits>

namespace eagerx::models {

/// Every tick: observation [] := element `idx` of the last observation_array [n]; zero before the
/// first message (skipped connections).
template <class Io>
class FloatOutput {
 public:
  using Simulator = typename Io::Simulator;

  void reset(const typename Io::States& /*states*/, Simulator& /*simulator*/) {}

  void callback(const Tick& /*tick*/, const typename Io::Inputs& in, typename Io::Outputs& out,
                Simulator& /*simulator*/) {
    using Message = std::remove_cvref_t<decltype(out.observation)>;
    constexpr auto kIndex = static_cast<std::size_t>(Io::Config::idx);
    static_assert(kIndex < size_of<Source>,
                  "FloatOutput: `idx` is beyond the end of `observation_array`");
    element(out.observation, 0) =
        static_cast<ScalarOf<Message>>(element(in.observation_array.back_or(Source{}), kIndex));
  }

 private:
  using Source = typename decltype(Io::Inputs::observation_array)::value_type;
};

}  // namespace eagerx::models
