#include <array>
#include <eagerx/math.hpp>
#include <runtime/host/expression/calculation.hpp>
#include <string_view>
#include <utility>

namespace eagerx::expression {
namespace {

using Code = Calculation::Op;
using Step = Calculation::Step;

// As in the code that is generated for a task.
struct One {
  std::string_view name;
  double (*function)(double);
};
constexpr std::array kOne = {One{"abs", [](double x) { return eagerx::abs(x); }},
                             One{"sqrt", [](double x) { return eagerx::sqrt(x); }},
                             One{"exp", [](double x) { return eagerx::exp(x); }},
                             One{"log", [](double x) { return eagerx::log(x); }},
                             One{"log10", [](double x) { return eagerx::log10(x); }},
                             One{"sin", [](double x) { return eagerx::sin(x); }},
                             One{"cos", [](double x) { return eagerx::cos(x); }},
                             One{"tan", [](double x) { return eagerx::tan(x); }},
                             One{"asin", [](double x) { return eagerx::asin(x); }},
                             One{"acos", [](double x) { return eagerx::acos(x); }},
                             One{"atan", [](double x) { return eagerx::atan(x); }},
                             One{"sinh", [](double x) { return eagerx::sinh(x); }},
                             One{"cosh", [](double x) { return eagerx::cosh(x); }},
                             One{"tanh", [](double x) { return eagerx::tanh(x); }},
                             One{"sigmoid", [](double x) { return eagerx::sigmoid(x); }},
                             One{"floor", [](double x) { return eagerx::floor(x); }},
                             One{"ceil", [](double x) { return eagerx::ceil(x); }},
                             One{"round", [](double x) { return eagerx::round(x); }},
                             One{"trunc", [](double x) { return eagerx::trunc(x); }},
                             One{"square", [](double x) { return eagerx::square(x); }},
                             One{"cube", [](double x) { return eagerx::cube(x); }}};
struct Two {
  std::string_view name;
  double (*function)(double, double);
};
constexpr std::array kTwo = {Two{"atan2", [](double y, double x) { return eagerx::atan2(y, x); }},
                             Two{"pow", [](double x, double y) { return eagerx::pow(x, y); }},
                             Two{"fmod", [](double x, double y) { return eagerx::fmod(x, y); }}};

class Writer {
 public:
  Writer(const Calculation::Places& places, std::vector<Step>& steps)
      : places_(places), steps_(steps) {}

  /// Of a list, this element.
  void write(const Typed& part, std::uint64_t element) {
    if (!problem_.empty()) return;
    switch (part.op) {
      case Typed::Op::number:
        return add({.op = Code::number, .number = part.value});
      case Typed::Op::truth:
        return add({.op = Code::number, .number = part.truth ? 1.0 : 0.0});
      case Typed::Op::time:
        return read({});
      case Typed::Op::variable:
      case Typed::Op::before:
        return read({part.variable, part.is_list() ? element : 0, part.op == Typed::Op::before});
      case Typed::Op::element:
        return write(part.operands[0], part.count);
      case Typed::Op::sum:
      case Typed::Op::mean:
      case Typed::Op::norm:
      case Typed::Op::least:
      case Typed::Op::most:
        return reduce(part);
      default:
        for (const Typed& operand : part.operands) write(operand, element);
        return apply(part);
    }
  }
  const std::string& problem() const { return problem_; }

 private:
  void apply(const Typed& part) {
    switch (part.op) {
      case Typed::Op::function:
        return call(part.function);
      case Typed::Op::power:
        return call(part.count == 2 ? "square" : "cube");
      case Typed::Op::negate:
        return add({.op = Code::negate});
      case Typed::Op::logical_not:
        return add({.op = Code::logical_not});
      case Typed::Op::choose:
        return add({.op = Code::choose});
      case Typed::Op::add:
        return add({.op = Code::add});
      case Typed::Op::subtract:
        return add({.op = Code::subtract});
      case Typed::Op::multiply:
        return add({.op = Code::multiply});
      case Typed::Op::divide:
        return add({.op = Code::divide});
      case Typed::Op::less:
        return add({.op = Code::less});
      case Typed::Op::less_equal:
        return add({.op = Code::less_equal});
      case Typed::Op::greater:
        return add({.op = Code::greater});
      case Typed::Op::greater_equal:
        return add({.op = Code::greater_equal});
      case Typed::Op::equal:
        return add({.op = Code::equal});
      case Typed::Op::not_equal:
        return add({.op = Code::not_equal});
      case Typed::Op::logical_and:
        return add({.op = Code::logical_and});
      default:
        return add({.op = Code::logical_or});
    }
  }

  void call(std::string_view name) {
    if (name == "min") return add({.op = Code::least});
    if (name == "max") return add({.op = Code::most});
    if (name == "clamp") return add({.op = Code::clamp});
    for (const One& each : kOne)
      if (each.name == name) return add({.op = Code::one, .one = each.function});
    for (const Two& each : kTwo)
      if (each.name == name) return add({.op = Code::two, .two = each.function});
    problem_ = "`" + std::string(name) + "` cannot be calculated here";
  }

  /// In the order of the elements.
  void reduce(const Typed& part) {
    const Typed& list = part.operands[0];
    const bool extreme = part.op == Typed::Op::least || part.op == Typed::Op::most;
    const Code join = part.op == Typed::Op::least  ? Code::least
                      : part.op == Typed::Op::most ? Code::most
                                                   : Code::add;
    if (extreme && list.size() == 0) problem_ = "a list without elements has no least or most";
    if (!extreme) add({.op = Code::number});
    for (std::uint64_t i = 0; i < list.size() && problem_.empty(); ++i) {
      write(list, i);
      if (part.op == Typed::Op::norm) call("square");
      if (i > 0 || !extreme) add({.op = join});
    }
    if (part.op == Typed::Op::norm) call("sqrt");
    if (part.op != Typed::Op::mean) return;
    add({.op = Code::number, .number = static_cast<double>(list.size())});
    add({.op = Code::divide});
  }

  void read(const Read& what) {
    if (const auto place = places_(what)) return add({.op = Code::read, .place = *place});
    problem_ = "it reads too many different numbers";
  }

  void add(Step step) {
    constexpr int kOperands[] = {0, 0, 1, 1, 1, 2, 3, 3};  // of those before Code::add
    const auto op = static_cast<std::size_t>(step.op);
    height_ += 1 - (op < std::size(kOperands) ? kOperands[op] : 2);
    steps_.push_back(step);
    if (height_ > static_cast<int>(Calculation::kDeepest)) problem_ = "it is nested too deeply";
    if (steps_.size() > Calculation::kMostSteps) problem_ = "it takes too many operations";
  }

  const Calculation::Places& places_;
  std::vector<Step>& steps_;
  int height_ = 0;
  std::string problem_;
};

double joined(const Step& step, double a, double b) {
  switch (step.op) {
    case Code::two:
      return step.two(a, b);
    case Code::add:
      return a + b;
    case Code::subtract:
      return a - b;
    case Code::multiply:
      return a * b;
    case Code::divide:
      return a / b;
    case Code::least:
      return a < b || a != a ? a : b;
    case Code::most:
      return a > b || a != a ? a : b;
    case Code::less:
      return a < b ? 1.0 : 0.0;
    case Code::less_equal:
      return a <= b ? 1.0 : 0.0;
    case Code::greater:
      return a > b ? 1.0 : 0.0;
    case Code::greater_equal:
      return a >= b ? 1.0 : 0.0;
    case Code::equal:
      return a == b ? 1.0 : 0.0;
    case Code::not_equal:
      return a != b ? 1.0 : 0.0;
    case Code::logical_and:
      return a != 0.0 && b != 0.0 ? 1.0 : 0.0;
    default:
      return a != 0.0 || b != 0.0 ? 1.0 : 0.0;
  }
}

}  // namespace

std::string Calculation::prepare(const Typed& expression, const Places& places) {
  steps_.clear();
  Writer writer(places, steps_);
  writer.write(expression, 0);
  return writer.problem();
}

double Calculation::value(const double* values) const {
  std::array<double, kDeepest> stack;
  std::size_t size = 0;
  for (const Step& step : steps_) {
    double& last = stack[size > 0 ? size - 1 : 0];
    switch (step.op) {
      case Code::number:
        stack[size++] = step.number;
        break;
      case Code::read:
        stack[size++] = values[step.place];
        break;
      case Code::negate:
        last = -last;
        break;
      case Code::logical_not:
        last = last != 0.0 ? 0.0 : 1.0;
        break;
      case Code::one:
        last = step.one(last);
        break;
      case Code::clamp:
        size -= 2;
        stack[size - 1] = eagerx::clamp(stack[size - 1], stack[size], stack[size + 1]);
        break;
      case Code::choose:
        size -= 2;
        stack[size - 1] = stack[size - 1] != 0.0 ? stack[size] : stack[size + 1];
        break;
      default:
        --size;
        stack[size - 1] = joined(step, stack[size - 1], stack[size]);
    }
  }
  return stack[0];
}

}  // namespace eagerx::expression
