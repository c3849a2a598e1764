// What was designed, as text and JSON.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "generator/support/json/json.hpp"
#include "generator/tools/linear/modes.hpp"

namespace eagerx::gen {

/// A parameter of the node.
struct DesignedParameter {
  std::string name;
  std::vector<double> values;
  bool is_list = true;

  /// As a graph writes it: "[1, 2.5]", with the digits that make the same double.
  [[nodiscard]] std::string text() const;
};

/// The loop that is opened at a port, with the gains that the graph has and with the new ones.
struct DesignedLoop {
  std::string port;
  Margins before, after;
};

struct DesignReport {
  std::string method, node, type;
  double period_s = 0.0;  // of the node
  std::vector<DesignedParameter> parameters;
  std::vector<std::pair<std::string, std::string>> facts;  // what they are for, and what follows
  Json numbers;                                            // the same, for programs
  std::vector<DesignedLoop> loops;
  std::vector<std::string> losing, smoothing;
};
std::string design_text(const DesignReport& report);
Json design_json(const DesignReport& report);

}  // namespace eagerx::gen
