// Processor in the loop: a library for your own main loop, stepped with the messages that a
// simulation of its whole graph recorded, must answer what the nodes answered there.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <eagerx/message.hpp>
#include <eagerx/random.hpp>
#include <eagerx/trace.hpp>
#include <type_traits>
#ifdef __linux__
#include <charconv>
#include <cstdio>
#include <string_view>
#else
#include <targets/common/bare-metal/console.hpp>
#endif

// Words of 32 bits: seed, episodes; for each episode its number of steps, and for each step actions
// and observations, every element as canonical_bits() in as many words as its type has.
asm(R"(
  .pushsection .rodata
  .balign 8
  .global eagerx_pil_recorded
eagerx_pil_recorded:
  .incbin "recorded.bin"
  .popsection
)");
extern "C" const std::uint32_t eagerx_pil_recorded[];

namespace eagerx::pil {

#ifdef __linux__
struct Console {
  void text(std::string_view text) { std::fwrite(text.data(), 1, text.size(), stdout); }
  template <class T>
  void number(T value) {
    char buffer[64];
    text({buffer, std::to_chars(buffer, buffer + sizeof buffer, value).ptr});
  }
  void flush() { std::fflush(stdout); }
};
inline Console console;
#else
using board::console;
#endif

inline constexpr int kSame = 0, kSelfTestFailed = 1, kDiffers = 1;

/// Reads the recorded elements one after the other.
class Reader {
 public:
  explicit Reader(const std::uint32_t* words) : words_(words) {}

  std::uint32_t word() { return *words_++; }
  template <class T>
  T element() {
    std::uint64_t bits = word();
    if constexpr (sizeof(T) == 8) bits |= std::uint64_t{word()} << 32U;
    if constexpr (std::is_same_v<T, float>) {
      return std::bit_cast<float>(static_cast<std::uint32_t>(bits));
    } else if constexpr (std::is_same_v<T, double>) {
      return std::bit_cast<double>(bits);
    } else {
      return static_cast<T>(bits);
    }
  }

 private:
  const std::uint32_t* words_;
};

template <class T>
void say_number(T value) {
  if constexpr (std::is_same_v<T, bool>) {
    console.text(value ? "true" : "false");
  } else if constexpr (sizeof(T) == 1) {
    console.number(static_cast<int>(value));
  } else {
    console.number(value);
  }
}

inline void say_times(std::uint64_t count, const char* what) {
  console.number(count);
  console.text(" ");
  console.text(what);
  console.text(count == 1 ? "" : "s");
}

/// The steps of one episode; false at the first difference, which it prints.
template <class Graph, class Limits, class Program>
class Episode {
 public:
  Episode(Program& program, Reader& recorded, std::uint32_t number)
      : program_(program), recorded_(recorded), number_(number) {}

  bool run(std::uint32_t steps) {
    for (step_ = 0; step_ < steps; ++step_) {
      typename Limits::Action action = Graph::zero();
      Limits::for_each_action(action, [&](const char* /*name*/, auto& message, const auto&) {
        using Message = std::remove_cvref_t<decltype(message)>;
        for (std::size_t i = 0; i < size_of<Message>; ++i)
          element(message, i) = recorded_.element<ScalarOf<Message>>();
      });
      step(action);
      if (differs_) return false;
    }
    return true;
  }
  [[nodiscard]] std::uint64_t compared() const { return compared_; }

 private:
  /// The comparison uses the messages of the nodes, before a guard limits the outputs.
  void step(const typename Limits::Action& action) {
    if constexpr (requires { program_.guard.acts(); }) {
      const auto checked = program_.guard.check(action, 0);
      if (!program_.guard.acts()) {
        differs_ = true;
        tell_place();
        console.text("the library's guard lets no node run\n");
        return;
      }
      auto seen = program_.step_unguarded(checked);
      compare(seen);
      program_.guard.leave(seen);
    } else {
      compare(program_.step(action));
    }
  }

  void compare(const typename Limits::Observation& seen) {
    Limits::for_each_observation(seen, [&](const char* name, const auto& window, const auto&) {
      const auto& message = window.back();
      using Message = std::remove_cvref_t<decltype(message)>;
      for (std::size_t i = 0; i < size_of<Message>; ++i) {
        const auto is = element(message, i);
        const auto was = recorded_.element<ScalarOf<Message>>();
        if (!differs_ && canonical_bits(is) != canonical_bits(was)) {
          differs_ = true;
          tell(name, i, size_of<Message>, is, was);
        }
      }
      ++compared_;
    });
  }

  void tell_place() {
    console.text("first difference at ");
    using Rate = typename Graph::Rate;
    console.number(static_cast<float>(step_) * static_cast<float>(Rate::den) /
                   static_cast<float>(Rate::num));
    console.text(" s, step ");
    console.number(step_);
    console.text(" of episode ");
    console.number(number_);
    console.text(": ");
  }
  template <class T>
  void tell(const char* name, std::size_t i, std::size_t size, T is, T was) {
    tell_place();
    console.text(name);
    if (size > 1) {
      console.text("[");
      console.number(static_cast<std::uint32_t>(i));
      console.text("]");
    }
    console.text(" is ");
    say_number(is);
    console.text(", in the simulation ");
    say_number(was);
    console.text("\n");
  }

  Program& program_;
  Reader& recorded_;
  std::uint32_t number_, step_ = 0;
  std::uint64_t compared_ = 0;
  bool differs_ = false;
};

template <class Program>
void say_guard(const Program& program) {
  if constexpr (requires { program.guard; }) {
    program.guard.for_each_count([](const char* name, std::uint64_t count) {
      if (count == 0) return;
      console.text("the library's guard: ");
      console.text(name);
      console.text(" ");
      console.number(count);
      console.text("\n");
    });
  }
}

/// The exit code of the program.
template <class Graph, class Limits, class Program>
int run(Program& program) {
  if (!Graph::self_test()) {
    console.text("bits differ on this processor: Graph::self_test() is false\n");
    console.flush();
    return kSelfTestFailed;
  }
  Reader recorded(eagerx_pil_recorded);
  const auto seed = recorded.element<std::uint64_t>();
  const std::uint32_t episodes = recorded.word();
  std::uint64_t steps = 0, compared = 0;
  bool same = true;
  for (std::uint32_t number = 0; same && number < episodes; ++number) {
    program.reset(Graph::sample({.seed = seed, .environment = 0, .episode = number}));
    const std::uint32_t length = recorded.word();
    Episode<Graph, Limits, Program> episode(program, recorded, number);
    same = episode.run(length);
    steps += length;
    compared += episode.compared();
  }
  if (same) {
    say_times(steps, "step");
    console.text(" in ");
    say_times(episodes, "episode");
    console.text(": ");
    say_times(compared, "output");
    console.text(" as in the simulation, bit for bit\n");
  }
  say_guard(program);
  console.flush();
  return same ? kSame : kDiffers;
}

}  // namespace eagerx::pil
