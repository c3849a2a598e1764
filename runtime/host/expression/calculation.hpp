// Evaluates a typed expression in a loop: on a stack of fixed size, without allocation.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <runtime/host/expression/typed.hpp>
#include <string>
#include <vector>

namespace eagerx::expression {

/// A number that a calculation reads.
struct Read {
  static constexpr std::size_t kTime = SIZE_MAX;  // a variable that is the time
  std::size_t variable = kTime;
  std::uint64_t element = 0;  // row-major
  bool is_before = false;     // its value one step before
};

class Calculation {
 public:
  /// The index of a number among the values; nullopt if there is no more room.
  using Places = std::function<std::optional<std::size_t>(const Read& read)>;

  /// Why it cannot be calculated, or nothing.
  std::string prepare(const Typed& expression, const Places& places);

  /// The result for these values. A condition returns 0 or 1; a comparison with NaN is false (`!=`:
  /// true). min and max of NaN are NaN, like all other results of NaN.
  double value(const double* values) const;

  /// One operation on the stack: a number, a variable, or an operator or function of its top
  /// elements.
  struct Step {
    Typed::Op op = Typed::Op::number;
    double number = 0.0;
    std::size_t place = 0;  // variable
    double (*one)(double) = nullptr;
    double (*two)(double, double) = nullptr;
  };
  static constexpr std::size_t kDeepest = 64;  // values on the stack
  static constexpr std::size_t kMostSteps = 10'000;

 private:
  std::vector<Step> steps_;  // in postfix order
};

}  // namespace eagerx::expression
