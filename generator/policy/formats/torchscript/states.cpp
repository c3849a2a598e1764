#include "generator/policy/formats/torchscript/states.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <set>
#include <utility>

#include "generator/policy/network/graph/ends.hpp"
#include "generator/support/diagnostics/search.hpp"

namespace eagerx::gen {
namespace {

/// Number `at` of the result of step `step`; -1: of the observation.
struct NumberOf {
  std::int32_t step = -1;
  std::uint32_t at = 0;
};

/// The part of a join in which number `at` lies.
NumberOf part_of_join(const NetStep& step, const Combination& join, std::uint32_t at) {
  std::size_t part = 0;
  while (at >= join.sizes[part]) at -= join.sizes[part++];
  return {part == 0 ? step.before : step.more[part - 1], at};
}

/// Where a number comes from that steps only move; `last` is not looked through. Nothing: the
/// budget is spent.
std::optional<NumberOf> origin_of(NetCall::State& state, NumberOf number, std::int32_t last) {
  while (number.step >= 0 && number.step != last) {
    if (!state.spend(1)) return std::nullopt;
    const NetStep& step = state.steps[static_cast<std::size_t>(number.step)];
    const auto* join = step.form<Combination>();
    if (const auto* order = step.form<Reorder>()) {
      number = {step.before, order->from[number.at]};
    } else if (join != nullptr && join->operation == Combination::Operation::join) {
      number = part_of_join(step, *join, number.at);
    } else {
      break;
    }
  }
  return number;
}

/// The steps in an order in which each comes after those that it takes; nothing if there is none.
std::optional<std::vector<std::int32_t>> order_of(const std::vector<NetStep>& steps) {
  std::vector<std::int32_t> order;
  std::vector<int> seen(steps.size(), 0);  // 1: begun, 2: in `order`
  std::vector<std::int32_t> open;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    open.push_back(static_cast<std::int32_t>(i));
    while (!open.empty()) {
      const std::int32_t index = open.back();
      const auto at = static_cast<std::size_t>(index);
      const int before = std::exchange(seen[at], seen[at] == 0 ? 1 : 2);
      if (before == 1) order.push_back(index);
      if (before != 0) {
        open.pop_back();
        continue;
      }
      std::vector<std::int32_t> taken = steps[at].more;
      taken.push_back(steps[at].before);
      for (const std::int32_t other : taken) {
        const int begun = other < 0 ? 2 : seen[static_cast<std::size_t>(other)];
        if (begun == 1) return std::nullopt;
        if (begun == 0) open.push_back(other);
      }
    }
  }
  return order;
}

void sort_steps(std::vector<NetStep>& steps, const std::vector<std::int32_t>& order,
                std::int32_t& action) {
  std::vector<std::int32_t> places(steps.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    places[static_cast<std::size_t>(order[i])] = static_cast<std::int32_t>(i);
  }
  const auto move = [&](std::int32_t& step) {
    if (step >= 0) step = places[static_cast<std::size_t>(step)];
  };
  std::vector<NetStep> sorted;
  sorted.reserve(steps.size());
  for (const std::int32_t index : order) {
    sorted.push_back(std::move(steps[static_cast<std::size_t>(index)]));
    move(sorted.back().before);
    for (std::int32_t& other : sorted.back().more) move(other);
  }
  steps = std::move(sorted);
  move(action);
}

/// A buffer whose new value is its former numbers in other places, and new ones.
class HistoryBuffer {
 public:
  HistoryBuffer(NetCall::State& state, std::int32_t step) : state_(state), step_(step) {}

  /// Makes `step` the layer of this history; false if the buffer is no history.
  bool resolve(const NetValue& now) {
    const std::int64_t count = state_.steps[static_cast<std::size_t>(step_)].count;
    const bool is_data = now.kind == NetValue::Kind::data && now.shape;
    return is_data && element_count(*now.shape) == count && find_origins(now, count) &&
           find_ages() && complete();
  }

 private:
  /// Of each number of the buffer the new one that it gets, or the former one.
  bool find_origins(const NetValue& now, std::int64_t count) {
    for (std::uint32_t i = 0; i < count; ++i) {
      const auto from = origin_of(state_, {now.step, i}, step_);
      if (!from) return false;
      origins_.push_back(*from);
      if (from->step == step_) continue;
      if (!taken_.empty() && from->step != source_) return false;
      source_ = from->step;
      taken_.insert(from->at);
    }
    return !taken_.empty();
  }

  /// How many observations ago each number of the buffer was new, and which one it was.
  bool find_ages() {
    constexpr std::uint32_t kOpen = 0xffffffffU;
    ages_.assign(origins_.size(), kOpen);
    news_.assign(origins_.size(), 0);
    for (std::uint32_t i = 0; i < origins_.size(); ++i) {
      std::vector<std::uint32_t> path;
      std::uint32_t at = i;
      while (ages_[at] == kOpen && origins_[at].step == step_) {
        if (path.size() > origins_.size()) return false;  // a number that stays
        path.push_back(at);
        at = origins_[at].at;
      }
      if (ages_[at] == kOpen) {
        ages_[at] = 0;
        news_[at] =
            static_cast<std::uint32_t>(std::distance(taken_.begin(), taken_.find(origins_[at].at)));
      }
      for (auto from = path.rbegin(); from != path.rend(); ++from) {
        ages_[*from] = ages_[at] + 1;
        news_[*from] = news_[at];
        at = *from;
      }
    }
    return true;
  }

  bool complete() {
    const auto width = static_cast<std::uint32_t>(taken_.size());
    const std::uint32_t length = *std::max_element(ages_.begin(), ages_.end()) + 2;
    if (std::int64_t{width} * length > kMaxValues) return false;
    Reorder order{{taken_.begin(), taken_.end()}};
    const std::string node = state_.steps[static_cast<std::size_t>(step_)].node;
    state_.steps.push_back({source_, NetLayer{std::move(order)}, node, width});
    NetStep& step = state_.steps[static_cast<std::size_t>(step_)];
    step.before = static_cast<std::int32_t>(state_.steps.size()) - 1;
    step.what = NetLayer{History{length}};
    step.count = std::int64_t{width} * length;
    for (NetStep& taker : state_.steps) {
      auto* layer = std::get_if<NetLayer>(&taker.what);
      auto* from = layer == nullptr ? nullptr : std::get_if<Reorder>(&layer->form);
      if (from == nullptr || taker.before != step_) continue;
      for (std::uint32_t& at : from->from) at = (length - 2 - ages_[at]) * width + news_[at];
    }
    return true;
  }

  NetCall::State& state_;
  std::int32_t step_;
  std::int32_t source_ = -1;
  std::set<std::uint32_t> taken_;  // numbers of the result of `source_`
  std::vector<NumberOf> origins_;
  std::vector<std::uint32_t> ages_, news_;
};

class TorchStates {
 public:
  TorchStates(TorchArchive& archive, const TorchInterpreter& interpreter, NetCall::State& state,
              PolicyProblem& problem)
      : archive_(archive), interpreter_(interpreter), state_(state), problem_(problem) {}

  bool check(std::int32_t& action) {
    for (const auto& [index, cell] : interpreter_.cells()) {
      if (cell->is_written && !check_recurrent(index, *cell)) return false;
    }
    if (!check_starts()) return false;
    for (const auto& [index, step] : interpreter_.former_values()) {
      const TorchTensor& cell = *interpreter_.cells().at(index);
      if (!HistoryBuffer(state_, step).resolve(cell.value)) {
        return fail(cell.buffer, kUnknownState, kHistoryAsInput);
      }
    }
    if (interpreter_.former_values().empty()) return true;
    const auto order = order_of(state_.steps);
    if (order) {
      sort_steps(state_.steps, *order, action);
      return true;
    }
    const auto index = interpreter_.former_values().begin()->first;
    return fail(interpreter_.cells().at(index)->buffer, kUnknownState, kHistoryAsInput);
  }

 private:
  bool fail(std::string_view buffer, const char* what, const char* help = kStateAsInput) {
    return refuse(problem_, "E0756", fmt::format("has a buffer `{}` {}", printable(buffer), what),
                  help);
  }

  /// The state of a layer comes back to it, and begins with zeros, as a history does.
  bool check_recurrent(std::uint32_t index, const TorchTensor& cell) {
    const bool is_history = interpreter_.former_values().contains(index);
    const std::vector<NetRemembered>& parts = cell.value.remembered;
    if (parts.empty() && !is_history) return fail(cell.buffer, kUnknownState, kHistoryAsInput);
    for (std::size_t slot = 0; slot < parts.size() && !is_history; ++slot) {
      const NetStateSource* from = state_before(state_.steps, parts[slot]);
      const bool is_own = from != nullptr && from->name.data() == cell.buffer.data() &&
                          from->slot == static_cast<std::int64_t>(slot);
      if (!is_own) return fail(cell.buffer, "that does not come back to the layer it is of");
    }
    PolicyProblem ignored;
    const NetValue* start = archive_.tensor(0, index, std::string(cell.buffer), ignored);
    const auto numbers = start != nullptr ? read_floats(start->constant, ignored) : std::nullopt;
    if (!numbers || ranges::any_of(*numbers, [](float x) { return x != 0.0F; })) {
      return fail(cell.buffer, "that does not begin with zeros: reset it before the export");
    }
    kept_.insert(cell.buffer.data());
    return true;
  }

  /// Every state that a layer starts from is kept.
  bool check_starts() {
    for (std::size_t i = 0; i < state_.steps.size(); ++i) {
      for (const bool is_cell : {false, true}) {
        const NetStateSource* from =
            state_before(state_.steps, {static_cast<std::int32_t>(i), is_cell});
        if (from == nullptr || kept_.contains(from->name.data())) continue;
        return fail(from->name, "that a GRU or LSTM starts from and that is not kept");
      }
    }
    return true;
  }

  TorchArchive& archive_;
  const TorchInterpreter& interpreter_;
  NetCall::State& state_;
  PolicyProblem& problem_;
  std::set<const char*> kept_;  // names of buffers, each its own text
};

}  // namespace

std::optional<Integers> places_of(NetCall::State& state, const NetValue& part,
                                  const NetValue& whole) {
  const bool are_data = part.kind == NetValue::Kind::data && whole.kind == NetValue::Kind::data;
  const auto count = part.shape ? element_count(*part.shape) : std::nullopt;
  if (!are_data || !count) return std::nullopt;
  Integers places;
  for (std::uint32_t i = 0; i < *count; ++i) {
    const auto from = origin_of(state, {part.step, i}, whole.step);
    if (!from || from->step != whole.step) return std::nullopt;
    places.push_back(from->at);
  }
  return places;
}

std::optional<NetValue> with_part(const TorchCall& call, const NetValue& whole,
                                  const Integers& places, const NetValue& part,
                                  const NetValue& values) {
  const auto count = static_cast<std::int64_t>(places.size());
  const std::int64_t size = element_count(whole.shape.value_or(Dims{})).value_or(0);
  const NetValue spread = call.node("Expand", {values}, {{"shape", {}, {}, *part.shape}});
  if (spread.shape != part.shape || !call.state().spend(size + count)) return std::nullopt;
  const auto row = [&](const NetValue& x, std::int64_t numbers) {
    return call.node("Reshape", {x}, {{"shape", {}, {}, Integers{1, numbers}}});
  };
  Integers from(static_cast<std::size_t>(size));
  std::iota(from.begin(), from.end(), std::int64_t{0});
  for (std::size_t i = 0; i < places.size(); ++i) {
    from[static_cast<std::size_t>(places[i])] = size + static_cast<std::int64_t>(i);
  }
  const NetValue both = call.node("Concat", {row(whole, size), row(spread, count)}, {{"axis", 1}});
  const NetValue picked =
      call.node("Gather", {both, integers_value(std::move(from), {size})}, {{"axis", 1}});
  return call.node("Reshape", {picked}, {{"shape", {}, {}, *whole.shape}});
}

bool check_torch_states(TorchArchive& archive, const TorchInterpreter& interpreter,
                        NetCall::State& state, std::int32_t& action, PolicyProblem& problem) {
  return TorchStates(archive, interpreter, state, problem).check(action);
}

}  // namespace eagerx::gen
