// Injected faults of an agent's observations and actions: a silent sensor, a number that is not
// finite.
#pragma once

#include <cstddef>
#include <cstdint>
#include <eagerx/rate.hpp>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace eagerx::target {

/// `NAME=KIND@STEP+STEPS`, such as `angle=silent@40` and `angle[0]=offset:0.1@40+5`.
struct Fault {
  enum class Kind : std::uint8_t {
    silent,  // nothing new comes: what was there before stays
    nan,
    offset,  // `number` is added
    value    // always `number`
  };
  std::string name;  // as written
  Kind kind = Kind::silent;
  double number = 0.0;
  std::optional<Seq> begins;  // step, from 0; empty: not said
  Seq steps = std::numeric_limits<Seq>::max();
  std::string written;  // all but the step

  bool acts(Seq step) const { return begins && step >= *begins && step - *begins < steps; }
};

/// For helps.
inline constexpr const char* kFaultForms =
    "NAME=silent, NAME=nan, NAME=offset:NUMBER or NAME=value:NUMBER, then @STEP at which it begins "
    "and +STEPS that it lasts; NAME is an observation, an action or one number of it (angle[0])";

/// nullopt if the text is none of the forms.
std::optional<Fault> parse_fault(std::string_view text);

/// An observation (all messages of its window together) or an action.
struct FaultPlace {
  std::string name;
  bool is_action = false;
  std::size_t size = 1;  // numbers
  bool is_real = true;   // else whole numbers, which can only be silent
};

/// A fault of the numbers [first, first + size) of places[place].
struct PlacedFault {
  Fault fault;
  std::size_t place = 0, first = 0, size = 0;

  bool acts(std::size_t at, std::size_t number, Seq step) const {
    return at == place && number >= first && number - first < size && fault.acts(step);
  }
};

/// Applies the faults of a place to the number `number`; `before` is the value one step earlier (in
/// step 0, the current one). A silent fault hides the others.
template <class T>
T with_faults(const std::vector<PlacedFault>& faults, std::size_t place, std::size_t number,
              Seq step, T now, T before) {
  T result = now;
  for (const PlacedFault& each : faults) {
    if (!each.acts(place, number, step)) continue;
    if (each.fault.kind == Fault::Kind::silent) return step == 0 ? now : before;
    if constexpr (std::is_floating_point_v<T>) {
      const T x = static_cast<T>(each.fault.number);
      if (each.fault.kind == Fault::Kind::nan) result = std::numeric_limits<T>::quiet_NaN();
      if (each.fault.kind == Fault::Kind::offset) result += x;
      if (each.fault.kind == Fault::Kind::value) result = x;
    }
  }
  return result;
}

struct FaultProblem {
  std::string what, help;
  std::string note = {};  // of a name with another separator, which is accepted
};

/// nullopt for a fault of an unknown element, or of one that cannot have it; see `problem`. If an
/// observation and an action have the same name, the prefix `observations.` or `actions.` selects
/// one.
std::optional<PlacedFault> place_fault(Fault fault, const std::vector<FaultPlace>& places,
                                       FaultProblem& problem);

}  // namespace eagerx::target
