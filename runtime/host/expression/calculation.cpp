#include <array>
#include <eagerx/math.hpp>
#include <runtime/host/expression/calculation.hpp>
#include <string_view>
#include <utility>

namespace eagerx::expression {
namespace {

using Step = Calculation::Step;
using Code = Typed::Op;

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

/// By how many the values on the stack become more.
int growth(const Step& step) {
  switch (step.op) {
    case Code::number:
    case Code::variable:
      return 1;
    case Code::negate:
    case Code::logical_not:
      return 0;
    case Code::choose:
      return -2;
    default:
      return step.one != nullptr ? 0 : -1;
  }
}

class Writer {
 public:
  Writer(const Calculation::Places& places, std::vector<Step>& steps)
      : places_(places), steps_(steps) {}

  /// Of a list, this element.
  void write(const Typed& part, std::uint64_t element) {
    if (!problem_.empty()) return;
    switch (part.op) {
      case Code::number:
        return add({.op = Code::number, .number = part.value});
      case Code::truth:
        return add({.op = Code::number, .number = part.truth ? 1.0 : 0.0});
      case Code::time:
        return read({});
      case Code::variable:
      case Code::before:
        return read({part.variable, part.is_list() ? element : 0, part.op == Code::before});
      case Code::element:
        return write(part.operands[0], part.count);
      case Code::sum:
      case Code::mean:
      case Code::norm:
      case Code::least:
      case Code::most:
        return reduce(part);
      default:
        if (part.function == "clamp") return clamp(part, element);
        for (const Typed& operand : part.operands) write(operand, element);
        return apply(part);
    }
  }
  const std::string& problem() const { return problem_; }

 private:
  void apply(const Typed& part) {
    if (part.op == Code::function) return call(part.function);
    if (part.op == Code::power) return call(part.count == 2 ? "square" : "cube");
    add({.op = part.op});
  }

  void call(std::string_view name) {
    if (name == "min") return add({.op = Code::least});
    if (name == "max") return add({.op = Code::most});
    for (const One& each : kOne)
      if (each.name == name) return add({.op = Code::function, .one = each.function});
    for (const Two& each : kTwo)
      if (each.name == name) return add({.op = Code::function, .two = each.function});
    problem_ = "`" + std::string(name) + "` cannot be calculated here";
  }

  /// As eagerx::clamp: the bound below first.
  void clamp(const Typed& part, std::uint64_t element) {
    write(part.operands[0], element);
    write(part.operands[1], element);
    add({.op = Code::most});
    write(part.operands[2], element);
    add({.op = Code::least});
  }

  /// In the order of the elements.
  void reduce(const Typed& part) {
    const Typed& list = part.operands[0];
    const bool extreme = part.op == Code::least || part.op == Code::most;
    const Code join = part.op == Code::least  ? Code::least
                      : part.op == Code::most ? Code::most
                                              : Code::add;
    if (extreme && list.size() == 0) problem_ = "a list without elements has no least or most";
    if (!extreme) add({.op = Code::number});
    for (std::uint64_t i = 0; i < list.size() && problem_.empty(); ++i) {
      write(list, i);
      if (part.op == Code::norm) call("square");
      if (i > 0 || !extreme) add({.op = join});
    }
    if (part.op == Code::norm) call("sqrt");
    if (part.op != Code::mean) return;
    add({.op = Code::number, .number = static_cast<double>(list.size())});
    add({.op = Code::divide});
  }

  void read(const Read& what) {
    if (const auto place = places_(what)) return add({.op = Code::variable, .place = *place});
    problem_ = "it reads too many different numbers";
  }

  void add(Step step) {
    height_ += growth(step);
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
    case Code::function:
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
      case Code::variable:
        stack[size++] = values[step.place];
        break;
      case Code::negate:
        last = -last;
        break;
      case Code::logical_not:
        last = last != 0.0 ? 0.0 : 1.0;
        break;
      case Code::choose:
        size -= 2;
        stack[size - 1] = stack[size - 1] != 0.0 ? stack[size] : stack[size + 1];
        break;
      default:
        if (step.one != nullptr) {
          last = step.one(last);
          break;
        }
        --size;
        stack[size - 1] = joined(step, stack[size - 1], stack[size]);
    }
  }
  return stack[0];
}

}  // namespace eagerx::expression
