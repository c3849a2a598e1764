// A Luenberger observer.
#pragma once

#include <array>
#include <cstddef>
#include <eagerx/rate.hpp>
#include <models/nodes/observer/linear_model.hpp>

namespace eagerx::models {

/// p = A·x + B·u, then x := p + gain·(measured − C·p); at the first tick p is the initial x. An
/// element of measured that is not finite or is missing corrects nothing. An x that overflows
/// begins anew.
template <class Io>
class Observer {
 public:
  void reset(const typename Io::States& states) {
    model_.reset(states);
    tune(states);
  }
  void tune([[maybe_unused]] const typename Io::States& states) {
    if constexpr (requires { states.gain; }) gain_.reset(states.gain, kGain);
  }

  template <class AnyTick = Tick>
  void callback(const AnyTick& tick, const typename Io::Inputs& in, typename Io::Outputs& out) {
    change_where<Real>(!tick.is_first(), model_, [&] { model_.predict(in); });
    std::array<Real, Model::kMeasured> innovation;
    for (std::size_t i = 0; i < Model::kMeasured; ++i) {
      innovation[i] = model_.innovation(in, i);
    }
    for (std::size_t i = 0; i < Model::kOrder; ++i) {
      model_.x.add(i, row_times<Real>(gain_.or_constants(kGain), i, innovation));
    }
    change_where<Real>(!model_.x.is_finite(), model_, [&] { model_.begin(); });
    for (std::size_t i = 0; i < Model::kOrder; ++i) put(out.x, i, model_.x.x[i].value);
  }

 private:
  using Real = typename Io::Real;
  using Model = LinearModel<Io>;
  static constexpr auto kGain = constants<Real>(Io::Config::gain);
  static_assert(kGain.size() == Model::kOrder * Model::kMeasured,
                "Observer: `gain` has `order` times as many values as `measured` has elements");

  Model model_{};

  using States = typename Io::States;
  static constexpr bool kTunesGain = requires(States s) { s.gain; };
  [[no_unique_address]] TunableList<Real, kGain.size(), kTunesGain, 0> gain_{};
};

}  // namespace eagerx::models
