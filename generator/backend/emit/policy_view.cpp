#include "generator/backend/emit/policy_view.hpp"

#include <fmt/compile.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <runtime/host/base/hash.hpp>
#include <string>
#include <string_view>

#include "generator/backend/emit/literals.hpp"
#include "generator/backend/emit/policy_tables.hpp"
#include "generator/policy/network/buffers.hpp"
#include "generator/policy/network/cost.hpp"
#include "generator/policy/network/evaluate.hpp"
#include "generator/policy/network/int8.hpp"
#include "generator/policy/network/panels.hpp"

namespace eagerx::gen {
namespace {

using kainjow::mustache::data;

/// A table that is written value by value, eight a line.
class Table {
 public:
  explicit Table(std::size_t count) : left_(count) { text_.reserve(count * kTypicalLiteral); }

  void add(float value) {
    if (in_line_ == 0) text_ += text_.empty() ? "     " : "\n     ";
    text_ += ' ';
    add_literal(value);
    if (--left_ > 0) text_ += ',';
    in_line_ = (in_line_ + 1) % kInLine;
  }
  void add_comment(const std::string& comment) {
    if (!text_.empty()) text_ += '\n';
    text_ += comment;
    in_line_ = 0;
  }
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  /// float_literal(value), without a string for each: networks have millions.
  void add_literal(float value) {
    if (!std::isfinite(value)) {
      text_ += float_literal(value);
      return;
    }
    char digits[kLongestLiteral];
    const char* const end = fmt::format_to(digits, FMT_COMPILE("{}"), value);
    const std::string_view literal(digits, static_cast<std::size_t>(end - digits));
    text_ += literal;
    text_ += literal.find_first_of(".e") == std::string_view::npos ? ".0F" : "F";
  }

  static constexpr std::size_t kTypicalLiteral = 16;
  static constexpr std::size_t kLongestLiteral = 32;
  static constexpr std::size_t kInLine = 8;
  std::string text_;
  std::size_t left_;
  std::size_t in_line_ = 0;
};

}  // namespace

std::string list_of(const std::vector<float>& values) {
  std::vector<std::string> literals;
  literals.reserve(values.size());
  for (const float value : values) literals.push_back(float_literal(value));
  return joined(literals);
}

std::string list_of(const std::vector<double>& values) {
  std::vector<std::string> literals;
  literals.reserve(values.size());
  for (const double value : values) literals.push_back(double_literal(value));
  return joined(literals);
}

std::string int8_table(const Layer& layer) {
  const std::vector<int> values = int8_stored(layer);
  constexpr std::size_t kInLine = 16;
  std::string text;
  for (std::size_t i = 0; i < values.size(); ++i) {
    text += i % kInLine == 0 ? (i == 0 ? "      " : ",\n      ") : ", ";
    text += std::to_string(values[i]);
  }
  return text;
}

std::string bias_table(const Layer& layer) {
  const std::size_t count = padded_outputs(layer.outputs);
  Table table(count);
  for (std::size_t k = 0; k < count; ++k) table.add(k < layer.outputs ? layer.bias[k] : 0.0F);
  return table.text();
}

std::string weight_table(const Layer& layer) {
  const std::size_t count = padded_outputs(layer.outputs);
  Table table(count * layer.inputs);
  for (const auto& [first, last, end] : panels_of(layer.outputs)) {
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

std::string slope_argument(const Layer& layer) {
  return layer.slope == 0.0F ? std::string() : ", " + float_literal(layer.slope);
}

namespace {

/// The variable of a value: -1 the observation, i the result of layer i.
std::string variable_of(const Network& network, std::int32_t value) {
  if (value < 0) return network.normalization ? "normalized" : "observation";
  const auto i = static_cast<std::size_t>(value);
  return i + 1 == network.layers.size() ? std::string("action") : fmt::format("hidden{}", i + 1);
}

std::string inputs_of(const Network& network, std::size_t i) {
  std::vector<std::string> names;
  for (const std::int32_t value : network.taken_by(i)) {
    names.push_back(variable_of(network, value));
  }
  return joined(names);
}

/// The result of a layer in a network with branches: a part of a buffer, or of what the layer
/// takes.
std::string declaration_of(const Network& network, const BufferPlan& plan, std::size_t i,
                           const std::string& real) {
  const Layer& layer = network.layers[i];
  const std::string name = variable_of(network, static_cast<std::int32_t>(i));
  if (plan.places[i]) {
    return fmt::format("{}(&{})[{}] = eagerx::policy::front<{}>(buffer{});", real, name,
                       layer.outputs, layer.outputs, *plan.places[i] + 1);
  }
  return fmt::format("const {}(&{})[{}] = {};", real, name, layer.outputs,
                     slice_expression(layer, inputs_of(network, i)));
}

/// Weights and biases of a dense layer.
void add_dense(const Layer& layer, PolicyTables& tables, data& view) {
  const bool int8 = !layer.rounded.empty();
  tables.add(layer);
  view.set("int8", data{int8 && !tables.is_stored()});
  view.set("float32", data{!int8 && !tables.is_stored()});
  view.set("weights", tables.text([&] { return int8 ? int8_table(layer) : weight_table(layer); }));
  view.set("biases", tables.text([&] { return int8 ? list_of(layer.bias) : bias_table(layer); }));
  if (int8) view.set("scales", tables.text([&] { return list_of(layer.scales); }));
}

data layer_view(const Network& network, const BufferPlan* plan, std::size_t i, PolicyTables& tables,
                const std::string& real) {
  const Layer& layer = network.layers[i];
  const std::size_t begin = tables.begin();
  const bool last = i + 1 == network.layers.size();
  data view{data::type::object};
  view.set("number", std::to_string(i + 1));
  view.set("inputs", std::to_string(layer.inputs));
  view.set("outputs", std::to_string(layer.outputs));
  view.set("activation", std::string(to_string(layer.activation)));
  view.set("slope", slope_argument(layer));
  const bool int8 = layer.is_dense() && !layer.rounded.empty();
  view.set("is_dense", layer.is_dense());
  view.set("int8", data{false});
  view.set("float32", data{false});
  view.set("weights", "");
  view.set("biases", "");
  if (layer.is_dense()) add_dense(layer, tables, view);
  view.set("dense", network.profile == Profile::fast && !int8 ? "fast_dense" : "dense");
  view.set("input", inputs_of(network, i));
  view.set("output", variable_of(network, static_cast<std::int32_t>(i)));
  view.set("hidden", data{plan == nullptr && !last});
  view.set("in_buffer", data{plan != nullptr && !last});
  if (plan != nullptr && !last) view.set("declaration", declaration_of(network, *plan, i, real));
  const bool plain = layer.is_dense() && layer.activation == Activation::identity;
  view.set("note", note_of(layer) + (plain ? " identity" : ""));
  view.set("norm", data{layer.norm.has_value()});
  if (layer.norm) {
    view.set("gamma", list_of(layer.norm->gamma));
    view.set("beta", list_of(layer.norm->beta));
    view.set("epsilon", float_literal(layer.norm->epsilon));
  }
  add_form(layer, {i + 1, plan != nullptr, real}, tables, view);
  if (layer.is_dense())
    view["stored"] =
        tables.declaration(begin,
                           fmt::format("eagerx::{}Weights<{}, {}>", int8 ? "Int8" : "Dense",
                                       layer.inputs, layer.outputs),
                           fmt::format("kLayer{}", i + 1), "");
  return view;
}

void add_statistics(const Network& network, data& view) {
  view.set("normalization", data{network.normalization.has_value()});
  if (!network.normalization) return;
  const Normalization& statistics = *network.normalization;
  std::vector<double> deviation;
  for (const double variance : statistics.variance) {
    deviation.push_back(std::sqrt(variance + statistics.epsilon));
  }
  view.set("source", statistics.source);
  view.set("mean", list_of(statistics.mean));
  view.set("deviation", list_of(deviation));
  view.set("clip", double_literal(statistics.clip));
}

void add_self_test(const Network& network, data& view) {
  data rows{data::type::list};
  Memory<float> memory;  // rows of a network that remembers are one sequence
  for (const std::vector<float>& observation : network.self_test) {
    data row{data::type::object};
    row.set("observation", list_of(observation));
    row.set("answer", list_of(evaluate(network, normalized(network, observation), &memory)));
    rows.push_back(row);
  }
  view.set("rows", std::to_string(network.self_test.size()));
  view.set("has_rows", data{!network.self_test.empty()});
  view.set("self_test", rows);
}

}  // namespace

namespace {

void add_buffers(const std::optional<BufferPlan>& plan, data& view) {
  data buffers{data::type::list};
  for (std::size_t i = 0; plan && i < plan->sizes.size(); ++i) {
    data item{data::type::object};
    item.set("buffer", std::to_string(i + 1));
    item.set("size", std::to_string(plan->sizes[i]));
    buffers.push_back(item);
  }
  view.set("has_branches", data{plan.has_value()});
  view.set("buffers", buffers);
}

/// The file of the tables, if they have one.
void add_stored(const PolicyTables& tables, data& view) {
  view["stored"] = data{false};
  if (!tables.is_stored()) return;
  data item{data::type::object};
  item.set("size", std::to_string(tables.bytes().size()));
  item.set("hash", host::hex_text(host::fnv1a(tables.bytes())));
  view["stored"] = std::move(item);
}

}  // namespace

std::size_t flash_bytes(const Network& network) {
  std::size_t sum = 0;
  for (const Layer& layer : network.layers)
    sum += layer.rounded.empty() ? cost_of(layer).bytes : int8_bytes(layer);
  return sum;
}

data policy_view(const Network& network, PolicyTables& tables, const std::string& real) {
  data layers{data::type::list};
  std::size_t parameters = 0;
  bool int8 = false;
  const auto plan = network.is_chain() ? std::nullopt : std::optional(plan_buffers(network));
  for (std::size_t i = 0; i < network.layers.size(); ++i) {
    const Layer& layer = network.layers[i];
    parameters += cost_of(layer).parameters;
    int8 = int8 || !layer.rounded.empty();
    layers.push_back(layer_view(network, plan ? &*plan : nullptr, i, tables, real));
  }
  data view{data::type::object};
  view.set("file", network.file);
  view.set("format", network.format);
  view.set("real", real);
  view.set("inputs", std::to_string(network.inputs()));
  view.set("outputs", std::to_string(network.outputs()));
  view.set("parameters", std::to_string(parameters));
  view.set("bytes", std::to_string(flash_bytes(network)));
  view.set("has_int8", data{int8});
  view.set("fast", data{network.profile == Profile::fast});
  view.set("tolerance", network.profile == Profile::fast ? ", 1e-4F" : "");
  view.set("layers", layers);
  view.set("has_memory", network.has_memory());
  add_buffers(plan, view);
  add_headers(network, view);
  add_statistics(network, view);
  add_self_test(network, view);
  add_stored(tables, view);
  return view;
}

}  // namespace eagerx::gen
