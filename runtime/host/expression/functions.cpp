#include <algorithm>
#include <array>
#include <runtime/host/expression/functions.hpp>

namespace eagerx::expression {
namespace {

constexpr std::array kFunctions = {
    Function{"abs", 1},   Function{"sqrt", 1},  Function{"exp", 1},     Function{"log", 1},
    Function{"log10", 1}, Function{"sin", 1},   Function{"cos", 1},     Function{"tan", 1},
    Function{"asin", 1},  Function{"acos", 1},  Function{"atan", 1},    Function{"sinh", 1},
    Function{"cosh", 1},  Function{"tanh", 1},  Function{"sigmoid", 1}, Function{"floor", 1},
    Function{"ceil", 1},  Function{"round", 1}, Function{"trunc", 1},   Function{"atan2", 2},
    Function{"pow", 2},   Function{"fmod", 2},  Function{"clamp", 3}};

/// Names of functions in Python, NumPy, torch, MATLAB and C.
constexpr auto kOtherNames =
    std::to_array<std::array<std::string_view, 2>>({{"square", "x^2"},
                                                    {"sq", "x^2"},
                                                    {"power", "pow(x, y)"},
                                                    {"absolute", "abs(x)"},
                                                    {"ln", "log(x)"},
                                                    {"clip", "clamp(x, low, high)"},
                                                    {"maximum", "max(x, y)"},
                                                    {"minimum", "min(x, y)"},
                                                    {"mod", "fmod(x, y)"},
                                                    {"arctan2", "atan2(y, x)"},
                                                    {"arcsin", "asin(x)"},
                                                    {"arccos", "acos(x)"},
                                                    {"arctan", "atan(x)"},
                                                    {"average", "mean(x)"},
                                                    {"select", "where(x > 0, a, b)"},
                                                    {"if", "where(x > 0, a, b)"},
                                                    {"hypot", "sqrt(x^2 + y^2)"},
                                                    {"sign", "where(x > 0, 1, -1)"}});

}  // namespace

std::span<const Function> functions() {
  return kFunctions;
}

std::string help_with_other_name(std::string_view name, const std::vector<std::string>& known) {
  const auto dot = name.rfind('.');
  const std::string_view last = dot == std::string_view::npos ? name : name.substr(dot + 1);
  for (const auto& [theirs, ours] : kOtherNames)
    if (theirs == last) return "write `" + std::string(ours) + "`";
  const bool is_known = std::ranges::find(known, last) != known.end();
  return dot != std::string_view::npos && is_known ? "write `" + std::string(last) + "`"
                                                   : std::string();
}

}  // namespace eagerx::expression
