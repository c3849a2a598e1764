// Actions and observations of a graph in words, for --help.
#pragma once

#include <cstddef>
#include <cstdint>
#include <eagerx/message.hpp>
#include <eagerx/space.hpp>
#include <initializer_list>
#include <string>
#include <string_view>
#include <type_traits>

namespace eagerx::linux_sim {

/// The shortest text that reads back to the same bits.
std::string number_text(float value);
std::string number_text(double value);
std::string number_text(std::int64_t value);

/// Collects the lines "  name  float32, shape [1], from -2 to 2". Nothing of it depends on a graph.
class Description {
 public:
  void heading(std::string_view text);
  /// Begins a line; `kind` is "float", "int", "uint" or "bool".
  void field(std::string_view name, std::string_view kind, std::size_t bytes,
             std::initializer_list<std::size_t> shape);
  void window(std::uint32_t size);
  /// The bounds of one element after the other, then bounds_end().
  template <class T>
  void bound(T low, T high) {
    if constexpr (std::is_floating_point_v<T>) {
      bound_text(number_text(low), number_text(high));
    } else {
      bound_text(number_text(static_cast<std::int64_t>(low)),
                 number_text(static_cast<std::int64_t>(high)));
    }
  }
  void bounds_end();
  void end_line() { text_ += "\n"; }
  const std::string& text() const { return text_; }

 private:
  /// The bounds of one side: one text if all elements have the same.
  struct Side {
    std::string first;
    std::string all;
    bool equal = true;
    void add(const std::string& bound);
    std::string text() const { return equal ? first : "[" + all + "]"; }
  };
  void bound_text(const std::string& low, const std::string& high);

  std::string text_;
  Side low_;
  Side high_;
};

template <class T>
constexpr std::string_view kind_of() {
  if constexpr (std::is_same_v<T, bool>) return "bool";
  if constexpr (std::is_floating_point_v<T>) return "float";
  return std::is_signed_v<T> ? "int" : "uint";
}

template <class Message>
struct FieldOf {
  static void add(Description& text, const char* name) {
    text.field(name, kind_of<Message>(), sizeof(Message), {});
  }
};
template <class T, std::size_t... Shape>
struct FieldOf<Array<T, Shape...>> {
  static void add(Description& text, const char* name) {
    text.field(name, kind_of<T>(), sizeof(T), {Shape...});
  }
};

inline void add_bounds(Description& /*text*/) {}
template <class Message>
void add_bounds(Description& text, const Space<Message>& space) {
  for (std::size_t i = 0; i < size_of<Message>; ++i) {
    text.bound(element(space.low, i), element(space.high, i));
  }
  text.bounds_end();
}

/// A line for each action and observation.
template <class Graph>
std::string describe(const typename Graph::Observation& observation) {
  Description text;
  text.heading("Actions:");
  typename Graph::Action action = Graph::zero();
  Graph::for_each_action(action, [&](const char* name, const auto& message, const auto&... space) {
    FieldOf<std::remove_cvref_t<decltype(message)>>::add(text, name);
    add_bounds(text, space...);
    text.end_line();
  });
  text.heading("Observations:");
  Graph::for_each_observation(
      observation, [&](const char* name, const auto& window, const auto&... space) {
        FieldOf<typename std::remove_cvref_t<decltype(window)>::value_type>::add(text, name);
        text.window(window.size());
        add_bounds(text, space...);
        text.end_line();
      });
  return text.text();
}

}  // namespace eagerx::linux_sim
