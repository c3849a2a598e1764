// A state that an engine knows nothing about.
#pragma once

namespace eagerx::models {

/// At a reset: nothing. For states of an object that only other engines have.
template <class Io>
struct DummyState {
  static void reset(const typename Io::State& /*value*/, typename Io::Simulator& /*simulator*/) {}
};

}  // namespace eagerx::models
