// The Python that torch.jit.save writes: functions of assignments, calls, returns and ifs. It is
// read, never run.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "generator/policy/network/problem.hpp"

namespace eagerx::gen {

struct TorchExpression {
  enum class Kind : std::uint8_t {
    name,       // text
    integer,    // integer
    real,       // real
    text,       // text
    attribute,  // parts[0].text
    call,       // parts[0](parts[1], …)
    subscript,  // parts[0][parts[1]]
    tuple,      // parts
    list,       // parts
  };
  Kind kind = Kind::name;
  std::string text{};
  std::int64_t integer = 0;
  double real = 0.0;
  std::vector<TorchExpression> parts{};
  std::vector<std::string> keywords{};  // of a call: names of its last arguments
};

struct TorchStatement {
  enum class Kind : std::uint8_t {
    assign,   // targets = value
    compute,  // value
    give,     // return value
    choose,   // if value: then, else: otherwise
    pass,
    other,  // text: what it begins with, which is not known
  };
  Kind kind = Kind::pass;
  int line = 0;
  std::vector<TorchExpression> targets{};  // names, or attributes
  TorchExpression value{};
  std::vector<TorchStatement> then{}, otherwise{};
  std::string text{};
};

struct TorchFunction {
  struct Parameter {
    std::string name;
    std::string type{};  // as it is written, without blanks; empty: none is
    std::optional<TorchExpression> otherwise{};
  };
  std::string file;  // in the archive
  int line = 0;
  std::vector<Parameter> parameters{};
  std::vector<TorchStatement> body{};
};

/// Functions of a file: "elu", "Linear.forward".
using TorchFunctions = std::map<std::string, TorchFunction, std::less<>>;

/// E0753 where the text is not of this kind.
std::optional<TorchFunctions> parse_torch_code(std::string_view text, const std::string& file,
                                               PolicyProblem& problem);

}  // namespace eagerx::gen
