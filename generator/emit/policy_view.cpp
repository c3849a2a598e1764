#include "generator/emit/policy_view.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cstddef>
#include <string>
#include <string_view>

namespace eagerx::gen {
namespace {

using kainjow::mustache::data;

constexpr std::size_t kPanel = 8;  // as eagerx::DenseWeights lays them out

/// The shortest decimal literal that is exactly `value`: "0.1F", "-0.0F", "1e-07F".
void append_literal(std::string& text, float value) {
  constexpr std::size_t kLongest = 24;
  std::array<char, kLongest> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
  const std::string_view shortest(digits.data(), static_cast<std::size_t>(end - digits.data()));
  text += shortest;
  if (shortest.find_first_of(".e") == std::string_view::npos) text += ".0";
  text += 'F';
}

/// Number of outputs after padding.
std::size_t padded(std::size_t outputs) {
  const std::size_t tail = outputs % kPanel;
  return outputs - tail + (tail == 0 ? 0 : std::bit_ceil(tail));
}

/// A table that is written value by value, eight a line.
class Table {
 public:
  explicit Table(std::size_t count) : left_(count) { text_.reserve(count * kTypicalLiteral); }

  void add(float value) {
    if (in_line_ == 0) text_ += text_.empty() ? "     " : "\n     ";
    text_ += ' ';
    append_literal(text_, value);
    if (--left_ > 0) text_ += ',';
    in_line_ = (in_line_ + 1) % kPanel;
  }
  void add_comment(const std::string& comment) {
    if (!text_.empty()) text_ += '\n';
    text_ += comment;
    in_line_ = 0;
  }
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  static constexpr std::size_t kTypicalLiteral = 16;
  std::string text_;
  std::size_t left_;
  std::size_t in_line_ = 0;
};

std::string bias_table(const DenseLayer& layer) {
  const std::size_t count = padded(layer.outputs);
  Table table(count);
  for (std::size_t k = 0; k < count; ++k) table.add(k < layer.outputs ? layer.bias[k] : 0.0F);
  return table.text();
}

/// Weights in panels of outputs: in a full panel, a line holds the weights of one input.
std::string weight_table(const DenseLayer& layer) {
  const std::size_t count = padded(layer.outputs);
  Table table(count * layer.inputs);
  for (std::size_t first = 0; first < layer.outputs; first += kPanel) {
    const std::size_t end = std::min(first + kPanel, count);
    const std::size_t last = std::min<std::size_t>(end, layer.outputs) - 1;
    table.add_comment(first == last ? fmt::format("      // output {}", first)
                                    : fmt::format("      // outputs {} to {}", first, last));
    for (std::size_t in = 0; in < layer.inputs; ++in) {
      for (std::size_t out = first; out < end; ++out) {
        table.add(out < layer.outputs ? layer.weights[out * layer.inputs + in] : 0.0F);
      }
    }
  }
  return table.text();
}

std::string_view activation_name(Activation activation) {
  switch (activation) {
    case Activation::relu:
      return "relu";
    case Activation::tanh:
      return "tanh";
    case Activation::identity:
      break;
  }
  return "identity";
}

/// Names out of a file must not end a comment's line; `read_policy` cleans those from inside of it.
std::string comment_text(std::string_view text) {
  std::string line(text);
  std::replace_if(
      line.begin(), line.end(), [](char c) { return c == '\n' || c == '\r' || c == '\\'; }, '?');
  return line;
}

}  // namespace

data policy_view(const Network& network) {
  data layers{data::type::list};
  std::size_t parameters = 0;
  std::size_t stored = 0;
  for (std::size_t i = 0; i < network.layers.size(); ++i) {
    const DenseLayer& layer = network.layers[i];
    const bool last = i + 1 == network.layers.size();
    parameters += layer.weights.size() + layer.bias.size();
    stored += padded(layer.outputs) * (layer.inputs + std::size_t{1});
    data view{data::type::object};
    view.set("number", std::to_string(i + 1));
    view.set("inputs", std::to_string(layer.inputs));
    view.set("outputs", std::to_string(layer.outputs));
    view.set("activation", std::string(activation_name(layer.activation)));
    view.set("weights", weight_table(layer));
    view.set("biases", bias_table(layer));
    view.set("input", i == 0 ? std::string("observation") : fmt::format("hidden{}", i));
    view.set("output", last ? std::string("action") : fmt::format("hidden{}", i + 1));
    view.set("hidden", data{!last});
    layers.push_back(view);
  }
  data view{data::type::object};
  view.set("file", comment_text(network.file));
  view.set("format", comment_text(network.format));
  view.set("inputs", std::to_string(network.inputs()));
  view.set("outputs", std::to_string(network.outputs()));
  view.set("parameters", std::to_string(parameters));
  view.set("bytes", std::to_string(stored * sizeof(float)));
  view.set("layers", layers);
  return view;
}

}  // namespace eagerx::gen
