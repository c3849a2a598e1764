#include "generator/tools/linear/sampled_system.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "generator/support/json/json.hpp"
#include "generator/tools/linear/hyperperiod.hpp"
#include "generator/tools/page/units.hpp"

namespace eagerx::gen {
namespace {

Rows rows_of(const Json* list) {
  Rows rows;
  if (list == nullptr || !list->is<Json::List>()) return rows;
  for (const Json& row : *list->as<Json::List>()) {
    auto& to = rows.emplace_back();
    if (!row.is<Json::List>()) continue;
    for (const Json& item : *row.as<Json::List>())
      to.push_back(number_of(&item).value_or(std::nan("")));
  }
  return rows;
}

std::vector<StateWord> words_of(const Json* list) {
  std::vector<StateWord> words;
  for (const Json& item : *list->as<Json::List>()) {
    const auto& parts = *item.as<Json::List>();
    words.push_back({text_of(&parts[0]), number_of(&parts[1]).value_or(0.0),
                     number_of(&parts[2]).value_or(0.0) != 0.0});
  }
  return words;
}

SampledPort port_of(const Json& item, const Plan& plan) {
  const auto numbers = integers_of(&item).value_or(std::vector<std::int64_t>(3));
  const auto channel = static_cast<std::size_t>(numbers[0]);
  const auto element = static_cast<std::size_t>(numbers[1]);
  const Channel& sent = plan.channels[channel];
  const GraphNode& node = plan.graph->nodes[sent.node];
  const Output& output = node.outputs[sent.output];
  std::string name = sent.port;
  if (!output.space.shape.empty() && output.space.size() > 1) name += fmt::format("[{}]", element);
  return {name, unit_of(*plan.graph, node, output), channel, element};
}

std::vector<std::string> ports_of(const Json* channels, const Plan& plan) {
  std::vector<std::string> ports;
  const auto numbers = integers_of(channels);
  for (std::size_t i = 0; numbers && i < numbers->size(); ++i)
    ports.push_back(plan.channels[static_cast<std::size_t>((*numbers)[i])].port);
  return ports;
}

/// Leaves out numbers of the state.
class StateReduction {
 public:
  explicit StateReduction(SampledSystem& system) : s_(system), keeps_(system.state.size(), true) {}

  void run() {
    while (leave_out_unchanging() || leave_out_one_round()) {
    }
    compact();
  }

 private:
  /// x[i]' = x[i], whatever else there is: a parameter.
  bool leave_out_unchanging() {
    bool any = false;
    for (std::size_t i = 0; i < keeps_.size(); ++i) {
      bool stays = keeps_[i] && s_.a[i][i] == 1.0 && is_zero(s_.b[i]);
      for (std::size_t k = 0; stays && k < keeps_.size(); ++k)
        stays = k == i || !keeps_[k] || s_.a[i][k] == 0.0;
      if (!stays) continue;
      keeps_[i] = false;
      any = true;
      s_.unchanging.push_back(s_.state[i].name);
    }
    return any;
  }
  /// What nothing of the last hyperperiod is in, and what nothing reads.
  bool leave_out_one_round() {
    bool any = false;
    for (std::size_t i = 0; i < keeps_.size(); ++i) {
      if (!keeps_[i]) continue;
      bool is_set = !is_zero(s_.b[i]), is_read = false;
      for (std::size_t k = 0; k < keeps_.size(); ++k) {
        is_set = is_set || (keeps_[k] && s_.a[i][k] != 0.0);
        is_read = is_read || (keeps_[k] && s_.a[k][i] != 0.0);
      }
      for (const auto& row : s_.c) is_read = is_read || row[i] != 0.0;
      if (is_set && is_read) continue;
      keeps_[i] = false;
      any = true;
    }
    return any;
  }
  static bool is_zero(const std::vector<double>& row) {
    return std::ranges::all_of(row, [](double x) { return x == 0.0; });
  }

  template <class List>
  List kept(const List& all) const {
    List result;
    for (std::size_t i = 0; i < keeps_.size(); ++i) {
      if (keeps_[i]) result.push_back(all[i]);
    }
    return result;
  }
  void compact() {
    s_.state = kept(s_.state);
    s_.a = kept(s_.a);
    s_.b = kept(s_.b);
    for (auto& row : s_.a) row = kept(row);
    for (auto& row : s_.c) row = kept(row);
  }

  SampledSystem& s_;
  std::vector<bool> keeps_;
};

/// The largest change of an element of A, of the largest element; without columns of parameters,
/// whose effect may grow with the time.
double drift_of(const SampledSystem& system, const Rows& later) {
  double change = 0.0, largest = 0.0;
  const Rows& a = system.a;
  for (std::size_t k = 0; k < a.size() && later.size() == a.size(); ++k) {
    if (is_constant(system, k)) continue;
    for (std::size_t i = 0; i < a.size(); ++i) {
      change = std::max(change, std::abs(later[i][k] - a[i][k]));
      largest = std::max(largest, std::abs(a[i][k]));
    }
  }
  return largest > 0.0 ? change / largest : 0.0;
}

}  // namespace

std::optional<SampledSystem> read_whole_system(const Json& printed, const Plan& plan) {
  const Json* const json = &printed;
  const Json* const state = member(json, "state");
  if (state == nullptr) return std::nullopt;
  SampledSystem system;
  system.period_s = number_of(member(json, "period_s")).value_or(0.0);
  system.steps = static_cast<std::uint64_t>(number_of(member(json, "steps")).value_or(1.0));
  system.state = words_of(state);
  for (const Json& item : *member(json, "inputs")->as<Json::List>())
    system.inputs.push_back(port_of(item, plan));
  for (const Json& item : *member(json, "outputs")->as<Json::List>())
    system.outputs.push_back(port_of(item, plan));
  const auto opened = number_of(member(json, "opened")).value_or(0.0);
  system.opened = system.outputs.size() - static_cast<std::size_t>(opened);
  system.losing = ports_of(member(json, "losing"), plan);
  system.smoothing = ports_of(member(json, "smoothing"), plan);
  system.a = rows_of(member(json, "A"));
  system.b = rows_of(member(json, "B"));
  system.c = rows_of(member(json, "C"));
  system.d = rows_of(member(json, "D"));
  system.drift = drift_of(system, rows_of(member(json, "later")));
  return system;
}

std::optional<SampledSystem> read_system(std::string_view text, const Plan& plan) {
  const auto json = parse_json(text);
  auto system = json ? read_whole_system(*json, plan) : std::nullopt;
  if (system) StateReduction(*system).run();
  return system;
}

}  // namespace eagerx::gen
