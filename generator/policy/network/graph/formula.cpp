// Formulas that exporters write out operator by operator: LayerNorm before opset 17, gelu before
// opset 20. Each operator recognises the next part; the last one becomes one step.
#include <cmath>

#include "generator/policy/network/graph/operators.hpp"

namespace eagerx::gen {
namespace {

using Kind = NetValue::Kind;
using Role = NetPart::Role;
using Operation = Elementwise::Operation;

constexpr float kSqrtTwo = 1.41421356F;
constexpr float kSqrtTwoOverPi = 0.79788456F;
constexpr float kCubic = 0.044715F;

bool near(const std::optional<float>& value, float wanted) {
  constexpr float kRelative = 1e-5F;  // constants are written in float32, or as text
  return value && std::fabs(*value - wanted) <= kRelative * wanted;
}

/// The role of an input in a formula: a part of one, the data itself, a number.
class Formula {
 public:
  explicit Formula(const NetCall& call) : call_(call), a_(call.input(0)), b_(call.input(1)) {}

  std::optional<NetValue> next(NetFormula what) {
    switch (what) {
      case NetFormula::root:
        return is(a_, Role::variance) ? change(a_, Role::deviation) : std::nullopt;
      case NetFormula::erf:
        return erf();
      case NetFormula::tanh:
        return is(a_, Role::gelu_inner) ? by_tanh() : std::nullopt;
      case NetFormula::mean:
        return mean();
      default:
        break;
    }
    const std::optional<Dims> shape = broadcast(a_.shape, b_.shape);
    if (!shape || !is_each_with_each(*shape)) return std::nullopt;
    auto value = of_two(what);
    if (value && value->shape) value->shape = shape;
    return value;
  }

 private:
  using Result = std::optional<NetValue>;

  /// Number by number, or all with the same one: no outer product of a row and a column.
  bool is_each_with_each(const Dims& shape) const {
    const auto count = element_count(shape);
    return count == element_count(*a_.shape) || count == element_count(*b_.shape);
  }
  Result of_two(NetFormula what) const {
    if (what == NetFormula::sum) return add();
    if (what == NetFormula::difference) return subtract();
    if (what == NetFormula::product) return multiply();
    if (what == NetFormula::quotient) return divide();
    return power();
  }

  static bool is(const NetValue& value, Role role) {
    return value.kind == Kind::other && value.part.role == role;
  }
  static bool is_data(const NetValue& value) { return value.kind == Kind::data; }
  /// The part and the other input, in any order.
  bool pick(Role role, const NetValue*& part, const NetValue*& rest) const {
    if (!is(a_, role) && !is(b_, role)) return false;
    part = is(a_, role) ? &a_ : &b_;
    rest = is(a_, role) ? &b_ : &a_;
    return true;
  }
  /// Data that is x times (or divided by) a number: the step of x.
  bool is_scaled(const NetValue& data, Elementwise::Operation operation, float number,
                 std::int32_t& before) const {
    const NetStep* step = is_data(data) ? call_.step_of(data) : nullptr;
    const auto* work = step != nullptr ? step->form<Elementwise>() : nullptr;
    if (work == nullptr || work->operation != operation) return false;
    NetValue constant;
    constant.kind = Kind::constant;
    constant.constant = *std::get<NetLayer>(step->what).bias;
    before = step->before;
    return near(scalar_of(constant), number);
  }

  /// Should the action depend on a part alone, this is what is wrong with it.
  NetValue part(Role role, std::int32_t of, const std::optional<Dims>& shape) const {
    NetValue value = call_.misused("that is not a part of a LayerNorm or a gelu", shape);
    value.problem = {"E0613", "has " + call_.who() + " that is not a part of a LayerNorm or a gelu",
                     "export the actor alone, layer by layer"};
    value.part = {role, of, false, 0.0F};
    return value;
  }
  Result change(const NetValue& from, Role role) const {
    NetValue value = part(role, from.part.of, from.shape);
    value.part.by_tanh = from.part.by_tanh;
    value.part.epsilon = from.part.epsilon;
    return value;
  }

  Result mean() const {
    if (!is_data(a_) && !is(a_, Role::centred_square)) return std::nullopt;
    const Dims& dims = *a_.shape;
    const bool whole = is_over_last_axis(call_) && element_count(dims) == dims.back() &&
                       call_.integer("keepdims", 1) != 0;
    if (!whole) return std::nullopt;
    if (is(a_, Role::centred_square)) return change(a_, Role::variance);
    return part(Role::mean, a_.step, Dims(dims.size(), 1));
  }
  Result subtract() const {
    const bool fits = is_data(a_) && is(b_, Role::mean) && b_.part.of == a_.step;
    return fits ? Result(part(Role::centred, a_.step, a_.shape)) : std::nullopt;
  }
  Result power() const {
    const auto exponent = scalar_of(b_);
    if (is(a_, Role::centred) && exponent == 2.0F) return change(a_, Role::centred_square);
    if (is_data(a_) && exponent == 3.0F) return part(Role::cube, a_.step, a_.shape);
    if (is_data(a_) && exponent == 2.0F) return part(Role::square, a_.step, a_.shape);
    return std::nullopt;
  }
  Result divide() const {
    if (!is(a_, Role::centred) || !is(b_, Role::deviation) || a_.part.of != b_.part.of) {
      return std::nullopt;
    }
    return call_.data_after(a_.part.of, NetNorm{std::nullopt, std::nullopt, b_.part.epsilon},
                            *a_.shape);
  }
  Result erf() const {
    std::int32_t before = -1;
    if (!is_scaled(a_, Operation::divide, kSqrtTwo, before) &&
        !is_scaled(a_, Operation::multiply, 1.0F / kSqrtTwo, before)) {
      return std::nullopt;
    }
    return part(Role::erf, before, a_.shape);
  }
  Result by_tanh() const {
    NetValue value = part(Role::erf, a_.part.of, a_.shape);
    value.part.by_tanh = true;
    return value;
  }

  Result add() const {
    const NetValue* found = nullptr;
    const NetValue* rest = nullptr;
    if (pick(Role::variance, found, rest)) {
      const auto epsilon = scalar_of(*rest);
      if (!epsilon || *epsilon < 0.0F) return std::nullopt;
      Result value = change(*found, Role::variance);
      value->part.epsilon += *epsilon;
      return value;
    }
    if (pick(Role::erf, found, rest) && near(scalar_of(*rest), 1.0F)) {
      return change(*found, Role::one_plus_erf);
    }
    if (pick(Role::cubic, found, rest) && is_data(*rest) && rest->step == found->part.of) {
      return change(*found, Role::gelu_sum);
    }
    return is_data(a_) ? parameter_of_norm(a_, b_, false) : parameter_of_norm(b_, a_, false);
  }

  Result multiply() const {
    const NetValue* found = nullptr;
    const NetValue* rest = nullptr;
    const auto of_x = [&] { return is_data(*rest) && rest->step == found->part.of; };
    if (is(a_, Role::centred) && is(b_, Role::centred) && a_.part.of == b_.part.of) {
      return change(a_, Role::centred_square);
    }
    if (is_data(a_) && is_data(b_) && a_.step == b_.step) {
      return part(Role::square, a_.step, a_.shape);
    }
    if (pick(Role::square, found, rest) && of_x()) return change(*found, Role::cube);
    if (pick(Role::cube, found, rest) && near(scalar_of(*rest), kCubic)) {
      return change(*found, Role::cubic);
    }
    if (pick(Role::gelu_sum, found, rest) && near(scalar_of(*rest), kSqrtTwoOverPi)) {
      return change(*found, Role::gelu_inner);
    }
    if (pick(Role::one_plus_erf, found, rest)) return from_one_plus_erf(*found, *rest);
    if (pick(Role::half_plus_erf, found, rest) && of_x()) return gelu(*found, *rest->shape);
    if (pick(Role::twice_gelu, found, rest) && near(scalar_of(*rest), 0.5F)) {
      return gelu(*found, *found->shape);
    }
    return is_data(a_) ? parameter_of_norm(a_, b_, true) : parameter_of_norm(b_, a_, true);
  }
  Result from_one_plus_erf(const NetValue& found, const NetValue& rest) const {
    if (near(scalar_of(rest), 0.5F)) return change(found, Role::half_plus_erf);
    if (is_data(rest) && rest.step == found.part.of) return change(found, Role::twice_gelu);
    std::int32_t before = -1;
    if (is_scaled(rest, Elementwise::Operation::multiply, 0.5F, before) &&
        before == found.part.of) {
      return gelu(found, *rest.shape);
    }
    return std::nullopt;
  }
  Result gelu(const NetValue& found, const Dims& shape) const {
    const Activation kind = found.part.by_tanh ? Activation::gelu_tanh : Activation::gelu;
    return call_.data_after(found.part.of, NetActivation{kind}, shape);
  }

  /// gamma or beta of a LayerNorm that has none yet.
  Result parameter_of_norm(const NetValue& data, const NetValue& constant, bool is_gamma) const {
    const NetStep* step = is_data(data) ? call_.step_of(data) : nullptr;
    const auto* work = step != nullptr ? std::get_if<NetNorm>(&step->what) : nullptr;
    if (work == nullptr || work->beta || constant.kind != Kind::constant ||
        constant.constant.transposed || element_count(constant.constant.dims) != step->count ||
        !broadcast(data.shape, constant.shape)) {
      return std::nullopt;
    }
    NetNorm norm = *work;
    if (is_gamma && norm.gamma) return std::nullopt;
    (is_gamma ? norm.gamma : norm.beta) = constant.constant;
    return call_.data_after(step->before, std::move(norm), *data.shape);
  }

  const NetCall& call_;
  const NetValue& a_;
  const NetValue& b_;
};

}  // namespace

std::optional<NetValue> part_of_formula(const NetCall& call, NetFormula next) {
  return Formula(call).next(next);
}

}  // namespace eagerx::gen
