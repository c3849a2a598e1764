// Layers other than dense ones as generated code.
#include <fmt/format.h>

#include "generator/backend/emit/policy_tables.hpp"
#include "generator/policy/network/buffers.hpp"
#include "generator/support/diagnostics/join.hpp"

namespace eagerx::gen {
namespace {

using kainjow::mustache::data;

/// The rows of a matrix, with weights of eight bits or not.
struct Rows {
  const std::vector<float>& weights;
  const std::vector<float>& bias;
  const std::vector<std::int8_t>& rounded;
  const std::vector<float>& scales;
};

/// The rows `first` to `last` of a matrix as a dense layer of their own.
Layer rows_of(const Rows& rows, std::size_t first, std::size_t last) {
  const std::size_t inputs = rows.weights.size() / rows.bias.size();
  const auto part_of = [](const auto& values, std::size_t begin, std::size_t end) {
    using Values = std::decay_t<decltype(values)>;
    const auto at = [&](std::size_t i) { return values.begin() + static_cast<std::ptrdiff_t>(i); };
    return values.empty() ? Values() : Values(at(begin), at(end));
  };
  Layer part;
  part.inputs = static_cast<std::uint32_t>(inputs);
  part.outputs = static_cast<std::uint32_t>(last - first);
  part.weights = part_of(rows.weights, first * inputs, last * inputs);
  part.bias = part_of(rows.bias, first, last);
  part.rounded = part_of(rows.rounded, first * inputs, last * inputs);
  part.scales = part_of(rows.scales, first, last);
  return part;
}

void add_part(const Layer& part, PolicyTables& tables, data& parts) {
  const bool int8 = !part.rounded.empty();
  tables.add(part);
  data item{data::type::object};
  item.set("weights", tables.text([&] { return int8 ? int8_table(part) : weight_table(part); }));
  item.set("biases",
           tables.text([&] { return int8 ? "      " + list_of(part.bias) : bias_table(part); }));
  data scales{false};
  if (int8) {
    scales = data{data::type::object};
    scales.set("values", tables.text([&] { return list_of(part.scales); }));
  }
  item["scales"] = std::move(scales);
  parts.push_back(item);
}

std::string kernel_literal(const KernelShape& kernel) {
  return fmt::format(
      "{{.channels = {}, .height = {}, .width = {}, .rows = {}, .columns = {},\n"
      "    .stride_down = {}, .stride_right = {}, .pad_top = {}, .pad_left = {},\n"
      "    .dilation_down = {}, .dilation_right = {}, .out_height = {}, .out_width = {}}}",
      kernel.channels, kernel.height, kernel.width, kernel.rows, kernel.columns, kernel.stride_down,
      kernel.stride_right, kernel.pad_top, kernel.pad_left, kernel.dilation_down,
      kernel.dilation_right, kernel.out_height, kernel.out_width);
}

/// The statements of one layer, and the constants that they name.
class Form {
 public:
  Form(const Layer& layer, const LayerText& text, PolicyTables& tables, data& view)
      : layer_(layer),
        tables_(tables),
        begin_(tables.bytes().size()),
        number_(text.number),
        branches_(text.branches),
        real_(text.real),
        x_(view.get("input")->string_value()),
        y_(view.get("output")->string_value()),
        view_(view) {}

  void write() {
    for (const char* key : {"kernel", "weighted", "constants", "indices", "memory", "stored"}) {
      view_.set(key, data{false});
    }
    std::visit([this](const auto& form) { write(form); }, layer_.form);
    if (!layer_.is_dense()) write_rest();
    data lines{data::type::list};
    for (const std::string& text : lines_) {
      data item{data::type::object};
      item.set("line", text);
      lines.push_back(item);
    }
    view_["lines"] = std::move(lines);
  }

 private:
  void write(const Dense& /*form*/) {}

  void write(const Convolution& form) {
    set_kernel(form.kernel);
    data parts{data::type::list};
    const std::size_t rows = form.channels / form.groups;
    for (std::size_t first = 0; first < form.channels; first += rows) {
      add_part(rows_of(own_rows(), first, first + rows), tables_, parts);
    }
    set_weights(fmt::format("eagerx::ConvolutionWeights<kKernel{}, {}, {}{}>", number_,
                            form.channels, form.groups, storage()),
                "{ {", "} }", std::move(parts));
    fused_ = !layer_.norm;
    const Activation activation = fused_ ? layer_.activation : Activation::identity;
    lines_.push_back(fmt::format("eagerx::convolve<eagerx::Activation::{}>(kLayer{}, {}, {}{});",
                                 to_string(activation), number_, x_, y_,
                                 fused_ ? slope_argument(layer_) : ""));
  }

  void write(const Pooling& form) {
    set_kernel(form.kernel);
    const std::string arguments = fmt::format("({}, {});", x_, y_);
    if (form.kind == Pooling::Kind::max) {
      lines_.push_back(fmt::format("eagerx::max_pool<kKernel{}>{}", number_, arguments));
      return;
    }
    lines_.push_back(fmt::format("eagerx::average_pool<kKernel{}, {}>{}", number_,
                                 form.kind == Pooling::Kind::average_with_padding, arguments));
  }

  void write(const Recurrence& cell) {
    data parts{data::type::list};
    const std::size_t rows = layer_.bias.size();
    add_part(rows_of(own_rows(), 0, rows), tables_, parts);
    add_part(
        rows_of({cell.hidden_weights, cell.hidden_bias, cell.hidden_rounded, cell.hidden_scales}, 0,
                rows),
        tables_, parts);
    const char* name = cell.is_lstm ? "Lstm" : "Gru";
    set_weights(
        fmt::format("eagerx::{}Weights<{}, {}{}>", name, layer_.inputs, layer_.outputs, storage()),
        "{", "}", std::move(parts));
    set_memory(name, layer_.outputs);
    lines_.push_back(fmt::format("eagerx::{}(kLayer{}, {}, memory.layer{}, {});",
                                 cell.is_lstm ? "lstm" : "gru", number_, x_, number_, y_));
  }

  void write(const Elementwise& form) {
    if (form.operation == Elementwise::Operation::none) {
      fused_ = !layer_.norm;
      lines_.push_back(fmt::format("eagerx::policy::apply<eagerx::Activation::{}>({}, {}{});",
                                   to_string(fused_ ? layer_.activation : Activation::identity), x_,
                                   y_, fused_ ? slope_argument(layer_) : ""));
      return;
    }
    tables_.add(layer_.bias);
    data constants{data::type::object};
    constants.set("count", std::to_string(layer_.bias.size()));
    constants.set("values", tables_.text([&] { return list_of(layer_.bias); }));
    set_table("constants", std::move(constants), "float", "kConstants",
              fmt::format("[{}]", layer_.bias.size()));
    lines_.push_back(fmt::format("eagerx::policy::{}(kConstants{}, {}, {});",
                                 to_string(form.operation), number_, x_, y_));
  }

  void write(const History& /*form*/) {
    set_memory("History", layer_.remembers());
    lines_.push_back(fmt::format("eagerx::history({}, memory.layer{}, {});", x_, number_, y_));
  }

  void write(const Combination& form) {
    lines_.push_back(fmt::format("eagerx::policy::{}({}, {});", to_string(form.operation), y_, x_));
  }
  void write(const Function& form) {
    lines_.push_back(fmt::format("eagerx::policy::{}({}, {});", to_string(form.kind), x_, y_));
  }
  void write(const Reduction& form) {
    lines_.push_back(fmt::format("eagerx::policy::row_{}({}, {});", to_string(form.kind), x_, y_));
  }

  void write(const Reorder& form) {
    if (branches_ && first_of_slice(layer_)) {
      if (y_ == "action") {
        lines_.push_back(
            fmt::format("eagerx::policy::join(action, {});", slice_expression(layer_, x_)));
      }
      return;
    }
    const bool are_wide = layer_.inputs > 0xffff;
    const char* type = are_wide ? "std::uint32_t" : "std::uint16_t";
    tables_.add(form.from, are_wide);
    data indices{data::type::object};
    indices.set("type", type);
    indices.set("count", std::to_string(form.from.size()));
    indices.set("values", tables_.text([&] { return fmt::format("{}", join(form.from, ", ")); }));
    set_table("indices", std::move(indices), type, "kFrom", fmt::format("[{}]", form.from.size()));
    lines_.push_back(fmt::format("eagerx::policy::reorder(kFrom{}, {}, {});", number_, x_, y_));
  }

  /// Norm and activation, where they are no part of the layer's own statement.
  void write_rest() {
    if (layer_.norm) lines_.push_back(fmt::format("eagerx::layer_norm(kNorm{}, {});", number_, y_));
    if (fused_ || layer_.activation == Activation::identity) return;
    lines_.push_back(fmt::format("eagerx::activate<eagerx::Activation::{}>({}{});",
                                 to_string(layer_.activation), y_, slope_argument(layer_)));
  }

  Rows own_rows() const { return {layer_.weights, layer_.bias, layer_.rounded, layer_.scales}; }
  /// The last argument of a type of weights.
  const char* storage() const { return layer_.rounded.empty() ? "" : ", eagerx::Int8Weights"; }

  void set_kernel(const KernelShape& kernel) {
    data item{data::type::object};
    item.set("literal", kernel_literal(kernel));
    view_["kernel"] = std::move(item);
  }
  /// A member of what the network remembers.
  void set_memory(const char* name, std::uint32_t size) {
    data item{data::type::object};
    item.set("member", fmt::format("eagerx::{}Memory<{}{}> layer{}", name, size,
                                   real_ == "float" ? "" : ", " + real_, number_));
    view_["memory"] = std::move(item);
  }
  void set_weights(const std::string& type, const char* open, const char* close, data parts) {
    data item{data::type::object};
    item.set("type", type);
    item.set("open", open);
    item.set("close", close);
    item["parts"] = std::move(parts);
    set_table("weighted", std::move(item), type, "kLayer", "");
  }
  /// The section `key`, which writes a table into the header; or its declaration.
  void set_table(const char* key, data item, const std::string& type, const char* constant,
                 const std::string& extent) {
    if (tables_.is_stored()) {
      view_["stored"] =
          tables_.declaration(begin_, type, fmt::format("{}{}", constant, number_), extent);
    } else {
      view_[key] = std::move(item);
    }
  }

  const Layer& layer_;
  PolicyTables& tables_;
  std::size_t begin_;  // of its table in them
  std::size_t number_;
  bool branches_;
  std::string real_, x_, y_;
  data& view_;
  std::vector<std::string> lines_;
  bool fused_ = false;  // the activation is a part of the layer's own statement
};

}  // namespace

std::string slice_expression(const Layer& layer, const std::string& input) {
  return fmt::format("eagerx::policy::slice<{}, {}>({})", first_of_slice(layer).value_or(0),
                     layer.outputs, input);
}

void add_form(const Layer& layer, const LayerText& text, PolicyTables& tables, data& view) {
  Form(layer, text, tables, view).write();
}

void add_headers(const Network& network, data& view) {
  bool kernels = false;
  bool elements = false;
  bool branches = false;
  for (const Layer& layer : network.layers) {
    kernels = kernels || std::holds_alternative<Convolution>(layer.form) ||
              std::holds_alternative<Pooling>(layer.form);
    branches = branches || !layer.takes.empty() ||
               std::holds_alternative<Combination>(layer.form) ||
               std::holds_alternative<Function>(layer.form) ||
               std::holds_alternative<Reduction>(layer.form);
    elements = elements || std::holds_alternative<Elementwise>(layer.form) ||
               std::holds_alternative<Reorder>(layer.form);
  }
  view.set("has_kernels", kernels);
  view.set("has_elements", elements);
  view.set("has_parts", branches);
}

}  // namespace eagerx::gen
