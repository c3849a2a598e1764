// Shared parts of control blocks: messages as numbers, and constants of a configuration.
//
// Blocks are written so that `Real` may be a SIMD vector (eagerx/simd.hpp): use `select` for
// choices that depend on numbers, and `if` only for conditions that are the same in all lanes (the
// messages of a window).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <eagerx/math.hpp>
#include <eagerx/message.hpp>
#include <eagerx/rate.hpp>
#include <eagerx/time.hpp>
#include <type_traits>

namespace eagerx::models {

/// The message that an input or output carries.
template <class Port>
struct PortMessage {
  using type = typename Port::value_type;
};
template <class Message>
struct PortMessage<Message&> {
  using type = std::remove_const_t<Message>;
};
/// Number of elements of `Io::Inputs::name` or `Io::Outputs::name`, by decltype.
template <class Port>
inline constexpr std::size_t elements_of = size_of<typename PortMessage<Port>::type>;

/// Element `i` of the newest message, or `otherwise` before the first message.
template <class Real, class Window>
constexpr Real newest(const Window& window, std::size_t i,
                      const std::type_identity_t<Real>& otherwise = Real(0)) {
  const auto empty = window.empty();
  if constexpr (std::is_same_v<decltype(empty), const bool>) {
    return empty ? otherwise : static_cast<Real>(element(window.back(), i));
  } else {  // in each lane
    return select(empty, otherwise, static_cast<Real>(element(window.back(), i)));
  }
}

/// Seconds since the reset at a tick of `Rate`, in each lane.
template <class Rate, class Real, class AnyTick>
constexpr Real seconds_at(const AnyTick& tick) {
  Real result(LaneOf<Real>(0));
  for (int k = 0; k < lanes<Real>; ++k)
    set_lane(result, k, Rate::template seconds<LaneOf<Real>>(tick.in_lane(k)));
  return result;
}

/// A sum that does not stall: its rounding error is kept, and added with the next term. TwoSum:
/// Knuth, The Art of Computer Programming 2, 4.2.2, theorem B.
template <class Real>
struct CompensatedSum {
  Real value{};
  Real rest{};  // at most half a unit in the last place of value

  void set(const Real& x) {
    value = x;
    rest = Real(0);
  }
  [[nodiscard]] CompensatedSum plus(const Real& x) const {
    const Real term = x + rest;
    const Real sum = value + term;
    const Real added = sum - value;
    const Real lost = (value - (sum - added)) + (term - added);
    return {sum, select(eagerx::isfinite(lost), lost, Real(0))};
  }
  /// The sum clamped to limits, without a remainder.
  [[nodiscard]] CompensatedSum within(const Real& low, const Real& high) const {
    const Real limited = eagerx::clamp(value, low, high);
    return {limited, select(limited == value, rest, Real(0))};
  }
};

/// f() changes `state`, which consists of Real and CountOf<Real>, but only in the lanes of `where`.
template <class Real, class State, class F>
constexpr void change_where(const std::type_identity_t<TruthOf<Real>>& where, State& state,
                            const F& f) {
  if constexpr (lanes<Real> == 1) {
    if (where) f();
  } else {
    static_assert(std::is_trivially_destructible_v<State> && sizeof(State) % sizeof(Real) == 0);
    constexpr std::size_t kNumbers = sizeof(State) / sizeof(Real);
    Real before[kNumbers];
    Real after[kNumbers];
    std::memcpy(static_cast<void*>(before), &state, sizeof before);
    f();
    std::memcpy(static_cast<void*>(after), &state, sizeof after);
    for (std::size_t i = 0; i < kNumbers; ++i) after[i] = select(where, after[i], before[i]);
    std::memcpy(static_cast<void*>(&state), after, sizeof after);
  }
}

/// Element `i` of a message becomes `value`, in the message's type.
template <class Message, class Real>
constexpr void put(Message& message, std::size_t i, const Real& value) {
  element(message, i) = static_cast<ScalarOf<Message>>(value);
}

/// The list of a configuration in the type that a Real consists of, rounded by the compiler.
template <class Real, std::size_t N>
constexpr std::array<LaneOf<Real>, N> constants(const std::array<double, N>& list) {
  std::array<LaneOf<Real>, N> result{};
  for (std::size_t i = 0; i < N; ++i) result[i] = static_cast<LaneOf<Real>>(list[i]);
  return result;
}
template <class Real>
constexpr LaneOf<Real> constant(double value) {
  return static_cast<LaneOf<Real>>(value);
}

/// Number `i` of a list that has one for all elements, or one for each.
template <class Real, class List>
constexpr Real each(const List& list, std::size_t i) {
  return Real(list[list.size() == 1 ? 0 : i]);
}

/// Whether there are at least two values, each above the one before.
template <std::size_t N>
constexpr bool increases(const std::array<double, N>& list) {
  for (std::size_t k = 1; k < N; ++k) {
    if (!(list[k - 1] < list[k])) return false;
  }
  return N >= 2;
}

/// Whether low[i] <= high[i] for every element; either list has one value, or one for each.
template <std::size_t L, std::size_t H>
constexpr bool in_order(const std::array<double, L>& low, const std::array<double, H>& high) {
  for (std::size_t i = 0; i < L || i < H; ++i) {
    if (!(low[L == 1 ? 0 : i] <= high[H == 1 ? 0 : i])) return false;
  }
  return true;
}

/// `x` moved by whole turns into [−turn/2, turn/2]; unchanged if `turn` is 0.
template <class Real>
constexpr Real within_turn(const Real& x, LaneOf<Real> turn) {
  if (!(turn > LaneOf<Real>(0))) return x;
  return x - Real(turn) * eagerx::round(x / Real(turn));
}

/// Row `row` of a matrix [rows][columns] times a vector, added from left to right.
template <class Real, class Matrix, class Vector>
constexpr Real row_times(const Matrix& matrix, std::size_t row, const Vector& x) {
  Real sum = Real(matrix[row * x.size()]) * x[0];
  for (std::size_t k = 1; k < x.size(); ++k) sum += Real(matrix[row * x.size() + k]) * x[k];
  return sum;
}

/// The last finite number, initially zero, which replaces a number that is not finite.
template <class Real>
struct Held {
  Real last{};
  const Real& operator()(const Real& x) { return last = select(eagerx::isfinite(x), x, last); }
};

/// A number that a reset may set. If no reset does, it keeps its value, at first `otherwise`.
template <class Real>
struct ResetNumber {
  Real value{};
  CountOf<Real> is_set{};  // 0 before the first reset

  void reset(const Real& otherwise) {
    value = select(is_set == CountOf<Real>(0U), otherwise, value);
    is_set = CountOf<Real>(1U);
  }
  void set(const Real& x) {
    value = x;
    is_set = CountOf<Real>(1U);
  }
};

/// A parameter that a graph may make `tunable:`. If it does, Io::States has a state of this name,
/// `Settable`, and a reset may set the number; otherwise it is the constant, and nothing is stored.
/// With `tunable: running`, the class's tune(), which its reset() calls, also sets it. `Number`
/// distinguishes the parameters of a class, so that constant ones take no memory.
template <class Real, bool Settable, int Number>
struct Tunable {
  ResetNumber<Real> number{};

  template <class State>
  void reset(const State& state, const Real& constant, std::size_t i = 0) {
    number.reset(constant);
    if (state) number.set(static_cast<Real>(element(*state, i)));
  }
  [[nodiscard]] const Real& or_constant(const Real& /*constant*/) const { return number.value; }
};

template <class Real, int Number>
struct Tunable<Real, false, Number> {
  [[nodiscard]] static Real or_constant(const Real& constant) { return constant; }
};

/// The same of a list of N numbers, with one for all elements or one for each.
template <class Real, std::size_t N, bool Settable, int Number>
struct TunableList {
  using Constants = std::array<LaneOf<Real>, N>;
  std::array<Tunable<Real, true, Number>, N> numbers{};

  template <class State>
  void reset(const State& state, const Constants& constants) {
    for (std::size_t i = 0; i < N; ++i) numbers[i].reset(state, Real(constants[i]), i);
  }
  /// The parameters of element `i`: these or the constants.
  const TunableList& or_constants(const Constants& /*constants*/) const { return *this; }
  static constexpr std::size_t size() { return N; }
  const Real& operator[](std::size_t i) const { return numbers[i].number.value; }
};

template <class Real, std::size_t N, int Number>
struct TunableList<Real, N, false, Number> {
  using Constants = std::array<LaneOf<Real>, N>;
  static constexpr const Constants& or_constants(const Constants& constants) { return constants; }
};

}  // namespace eagerx::models
