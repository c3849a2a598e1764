// Step response at a port: the program's messages with an added step and without it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <eagerx/math.hpp>
#include <eagerx/message.hpp>
#include <eagerx/number.hpp>
#include <memory>
#include <type_traits>
#include <vector>

namespace eagerx::linearize {

/// A step of an element of all messages of a channel.
struct StepRequest {
  std::uint64_t hyperperiods = 0;  // 0: none is asked for
  double size = 0.0;
};

/// Adds the step for readers, and records the sent messages.
struct AddedStep {
  std::uint32_t channel = 0;
  std::size_t element = 0;
  double size = 0.0;
  std::vector<double> sent;

  template <class Message>
  void on_message(std::uint32_t at, Message& message) {
    if (at != channel || element >= size_of<Message>) return;
    auto& x = eagerx::element(message, element);
    using Scalar = std::remove_cvref_t<decltype(x)>;
    if constexpr (std::is_same_v<Scalar, Number>) {
      sent.push_back(x.value);
      x = Number(x.value + size);
    }
  }
};

/// `start`: the program at its operating point; `step(program)` runs it. Ends where a number is not
/// finite.
template <class Program, class Step>
void print_step_response(const Program& start, const StepRequest& request, std::uint32_t channel,
                         std::size_t element, Step step) {
  const char* separator = "{";
  for (const double size : {0.0, request.size}) {
    AddedStep added{channel, element, size, {}};
    auto copy = std::make_unique<Program>(start);
    copy->hooks.added = &added;
    const std::uint64_t steps = request.hyperperiods * Program::kPhases;
    for (std::uint64_t i = 0; i < steps; ++i) step(*copy);
    std::printf("%s\"%s\": [", separator, size == 0.0 ? "without" : "with");
    for (std::size_t i = 0; i < added.sent.size() && eagerx::isfinite(added.sent[i]); ++i)
      std::printf(i == 0 ? "%.17g" : ", %.17g", added.sent[i]);
    std::printf("]");
    separator = ",\n";
  }
  std::printf("}\n");
}

}  // namespace eagerx::linearize
