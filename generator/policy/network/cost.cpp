#include "generator/policy/network/cost.hpp"

#include <fmt/core.h>

#include "generator/policy/network/buffers.hpp"
#include "generator/policy/network/panels.hpp"
#include "generator/support/diagnostics/join.hpp"

namespace eagerx::gen {
namespace {

/// A dense layer's floats in flash.
std::size_t floats_of(std::size_t inputs, std::size_t outputs) {
  return padded_outputs(outputs) * (inputs + 1);
}

std::string kernel_note(const char* what, const KernelShape& kernel) {
  if (kernel.height == 1 && kernel.rows == 1) return fmt::format(" {} {}", what, kernel.columns);
  return fmt::format(" {} {}x{}", what, kernel.rows, kernel.columns);
}

std::string form_note(const Layer& layer) {
  if (const auto* form = std::get_if<Convolution>(&layer.form)) {
    return kernel_note("convolution", form->kernel);
  }
  if (const auto* form = std::get_if<Pooling>(&layer.form)) {
    return kernel_note(form->kind == Pooling::Kind::max ? "max pool" : "average pool",
                       form->kernel);
  }
  if (const Recurrence* cell = layer.recurrence()) return cell->is_lstm ? " lstm" : " gru";
  if (const auto* form = std::get_if<Elementwise>(&layer.form)) {
    return form->operation == Elementwise::Operation::none
               ? std::string()
               : fmt::format(" {}", to_string(form->operation));
  }
  if (const auto* form = std::get_if<Combination>(&layer.form)) {
    return fmt::format(" {} of {}", to_string(form->operation), join(form->sizes, ", "));
  }
  if (const auto* form = std::get_if<Function>(&layer.form)) {
    return fmt::format(" {}", to_string(form->kind));
  }
  if (const auto* form = std::get_if<Reduction>(&layer.form)) {
    return fmt::format(" {}", to_string(form->kind));
  }
  if (const auto* form = std::get_if<History>(&layer.form)) {
    return fmt::format(" history of {}", form->length);
  }
  if (const auto first = first_of_slice(layer); first && !layer.takes.empty()) {
    return fmt::format(" slice from {}", *first);
  }
  return std::holds_alternative<Reorder>(layer.form) ? " reorder" : "";
}

}  // namespace

std::string note_of(const Layer& layer) {
  std::string note = form_note(layer);
  if (layer.norm) note += " layer norm";
  if (layer.activation != Activation::identity) {
    note += fmt::format(" {}", to_string(layer.activation));
  }
  return note;
}

LayerCost cost_of(const Layer& layer) {
  const std::size_t norm = layer.norm ? 2 * std::size_t{layer.outputs} : 0;
  LayerCost cost{layer.weights.size() + layer.bias.size() + norm, 0, layer.weights.size()};
  std::size_t floats = norm;
  if (const auto* form = std::get_if<Convolution>(&layer.form)) {
    const std::size_t patch = layer.weights.size() / form->channels;
    floats += form->groups * floats_of(patch, form->channels / form->groups);
    cost.multiply_adds *= form->kernel.places();
  } else if (const Recurrence* cell = layer.recurrence()) {
    const std::size_t rows = std::size_t{cell->gates()} * layer.outputs;
    floats += floats_of(layer.inputs, rows) + floats_of(layer.outputs, rows);
    cost.parameters += cell->hidden_weights.size() + cell->hidden_bias.size();
    cost.multiply_adds += cell->hidden_weights.size();
  } else if (layer.is_dense()) {
    floats += floats_of(layer.inputs, layer.outputs);
  } else {
    floats += layer.bias.size();
  }
  cost.bytes = floats * sizeof(float);
  const bool is_view = !layer.takes.empty() && first_of_slice(layer);  // of a network with branches
  if (const auto* form = std::get_if<Reorder>(&layer.form); form != nullptr && !is_view) {
    cost.bytes += form->from.size() * (layer.inputs > 0xffff ? 4 : 2);
  }
  return cost;
}

}  // namespace eagerx::gen
