// Limits of a signal, element by element.
#pragma once

#include <cstddef>
#include <cstdint>
#include <eagerx/math.hpp>
#include <eagerx/message.hpp>
#include <eagerx/rate.hpp>
#include <models/nodes/action_limits/per_element.hpp>
#include <models/nodes/block.hpp>
#include <type_traits>

namespace eagerx::models {

/// Every tick: `limited` := the last `action`, each element within [low, high]; zero moved into
/// them replaces NaN, also before the first message.
template <class Io>
class ActionLimits {
 public:
  void reset(const typename Io::States& /*states*/) {}

  void callback(const Tick& /*tick*/, const typename Io::Inputs& in, typename Io::Outputs& out) {
    using Result = std::remove_cvref_t<decltype(out.limited)>;
    static_assert(size_of<Result> == kSize,
                  "ActionLimits: `limited` must have as many elements as `action`");
    TruthOf<Real> changed = false;
    for (std::size_t i = 0; i < kSize; ++i) {
      const Real wanted = newest<Real>(in.action, i);
      const Real number = select(eagerx::isnan(wanted), Real(0), wanted);
      const Real limited = eagerx::clamp(number, value_for<Real>(Io::Config::low, i),
                                         value_for<Real>(Io::Config::high, i));
      changed = changed || limited != wanted;
      element(out.limited, i) = static_cast<ScalarOf<Result>>(limited);
    }
    limited_ += one_if<Real>(changed && !in.action.empty());
  }

  /// Calls f(name, count) for each count; counts continue over episodes.
  template <class F>
  void for_each_count(F&& f) const {
    f("limited", limited_);
  }

 private:
  using Real = typename Io::Real;
  using Message = typename decltype(Io::Inputs::action)::value_type;
  static constexpr std::size_t kSize = size_of<Message>;
  static_assert(is_one_or_each(Io::Config::low, kSize) && is_one_or_each(Io::Config::high, kSize),
                "ActionLimits: `low` and `high` have one value, or one for each element");

  CountOf<Real> limited_{};
};

}  // namespace eagerx::models
