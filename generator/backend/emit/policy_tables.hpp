// Tables of weights, and layers other than dense ones as generated code.
#pragma once

#include <kainjow/mustache.hpp>
#include <string>
#include <vector>

#include "generator/backend/emit/policy_view.hpp"
#include "generator/policy/network/network.hpp"

namespace eagerx::gen {

/// Weights in panels of outputs: in a full panel, a line holds the weights of one input.
std::string weight_table(const Layer& layer);
std::string bias_table(const Layer& layer);
/// Weights of eight bits, sixteen a line.
std::string int8_table(const Layer& layer);

/// "1.0F, 0.5F".
std::string list_of(const std::vector<float>& values);
/// "1.0, 0.5".
std::string list_of(const std::vector<double>& values);

/// Slope of elu and leaky relu as one more argument.
std::string slope_argument(const Layer& layer);

struct LayerText {
  std::size_t number = 1;
  bool branches = false;  // of a network with branches, where slices are no copies
  std::string real;       // the type of its numbers
};
/// Constants and statements of a layer, if it is not dense; "input" and "output" of the view are
/// their variables.
void add_form(const Layer& layer, const LayerText& text, PolicyTables& tables,
              kainjow::mustache::data& view);

/// A slice of `input` as an expression.
std::string slice_expression(const Layer& layer, const std::string& input);

/// Headers that the network's layers need.
void add_headers(const Network& network, kainjow::mustache::data& view);

}  // namespace eagerx::gen
