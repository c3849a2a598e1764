// Differences between the answers of two policies, layer by layer.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "generator/policy/network/golden.hpp"
#include "generator/policy/network/network.hpp"
#include "generator/support/diagnostics/diagnostics.hpp"

namespace eagerx::gen {

/// Over all rows; of an output, or of all results of a layer.
struct Difference {
  double largest = 0.0;
  double mean = 0.0;
  std::size_t row = 0;  // of the largest, from 0
};

struct OutputDifference : Difference {
  double range = 0.0;    // largest minus smallest answer of the first policy
  double allowed = 0.0;  // what it may be off
};

struct LayerDifference : Difference {
  double weights = 0.0;  // largest difference of a weight, bias or other constant
};

/// The answers of two policies to the same observations, as generated programs compute them.
struct PolicyDifference {
  std::size_t rows = 0;
  std::vector<OutputDifference> outputs;  // [outputs]
  std::size_t worst = 0;                  // output that is farthest off relative to its limit
  std::vector<double> observation;        // [inputs], where that is so
  std::vector<double> first, second;      // [outputs], the answers there
  std::optional<double> actions;          // largest difference, if both have bounds
  std::optional<std::size_t> choices;     // both choose: rows with another choice
  std::vector<LayerDifference> layers;    // empty: not compared
  std::string layers_differ;              // why not
  [[nodiscard]] bool within() const;
};

/// Why `a` and `b` have not the same layers, or "".
std::string other_structure(const Network& a, const Network& b);

/// Whether both take and give as many numbers. E0757.
bool check_sizes(const Network& a, const Network& b, Diagnostics& diagnostics);

/// Compares their answers to `rows`. `tolerance`: maximum difference of each output; nullopt: 1e-5
/// of its range, and at least 1e-5. Both must have the rows' sizes. E0759 if an answer is not
/// finite.
std::optional<PolicyDifference> difference_of(const Network& a, const Network& b,
                                              const GoldenRows& rows,
                                              std::optional<double> tolerance,
                                              Diagnostics& diagnostics);

}  // namespace eagerx::gen
