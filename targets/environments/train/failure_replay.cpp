#include "targets/environments/train/failure_replay.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <eagerx/random.hpp>
#include <limits>
#include <runtime/host/base/number.hpp>

#include "targets/environments/train/settings.hpp"

namespace eagerx::train {
namespace {

constexpr std::string_view kState = "state:";
constexpr const char* kOwnTable = "give the table that `eagerx-gen campaign --csv` has written";

/// The problem of the first line; empty: none.
std::string wrong_head(const std::vector<std::string_view>& head, const Description& description) {
  constexpr std::string_view kFirst[] = {"run",     "return",     "steps",
                                         "success", "terminated", "truncated"};
  if (head.size() < std::size(kFirst) ||
      !std::equal(std::begin(kFirst), std::end(kFirst), head.begin()))
    return "is not a table of a campaign";
  const std::vector<std::string> states = client::column_names(description.states);
  if (states.empty()) return "says nothing of starts: the graph has no states";
  const auto* column = head.data() + std::size(kFirst);
  const auto* const end = head.data() + head.size();
  for (const std::string& state : states) {
    if (column == end || !column->starts_with(kState) || column->substr(kState.size()) != state)
      return fmt::format("is of a graph with other states: `{}{}` is not where it should be",
                         kState, state);
    ++column;
  }
  if (column != end && column->starts_with("fault:"))
    return "is of a campaign with faults, which trainings do not have";
  return column == end ? "" : "is of a graph with more states";
}

bool read_cell(std::string_view cell, float& value) {
  constexpr float kMost = std::numeric_limits<float>::max();
  value = std::numeric_limits<float>::quiet_NaN();
  return cell.empty() || host::read_number(cell, -kMost, kMost, value);
}

}  // namespace

FailureReplay::FailureReplay(std::string_view text, const std::string& name,
                             const Description& description)
    : width_(client::column_names(description.states).size()) {
  const auto refuse = [&](const std::string& what) {
    throw Problem(kInputOutput, fmt::format("`{}` {}", name, what), kOwnTable);
  };
  if (!text.ends_with('\n')) refuse("is not a table of a campaign, or cut off");
  text.remove_suffix(1);
  constexpr std::size_t kSuccess = 3;  // column
  std::size_t number = 0, columns = 0;
  for (const std::string_view line : client::pieces_of(text, '\n')) {
    const std::vector<std::string_view> cells = client::pieces_of(line, ',');
    if (++number == 1) {
      const std::string wrong = wrong_head(cells, description);
      if (!wrong.empty()) refuse(wrong);
      columns = cells.size();
      continue;
    }
    const bool is_row =
        cells.size() == columns && (cells[kSuccess] == "0" || cells[kSuccess] == "1");
    if (!is_row) refuse(fmt::format("is damaged: line {} is not a run", number));
    for (std::size_t i = columns - width_; i < columns && cells[kSuccess] == "0"; ++i) {
      float value = 0.0F;
      if (!read_cell(cells[i], value))
        refuse(fmt::format("is damaged: line {}: `{}` is not a number", number, cells[i]));
      states_.push_back(value);
    }
  }
  if (states_.empty()) refuse("has no run that failed");
}

ReplayedEnvironments::ReplayedEnvironments(const Settings& settings, const Library& library,
                                           std::uint32_t first, std::uint32_t count)
    : starts_(settings.failure_replay), first_(first) {
  if (!starts_) return;
  set_states_ = library.find<decltype(&eagerx_set_states)>("eagerx_set_states");
  is_hard_.resize(count);
  is_noted_.resize(count);
  episode_.resize(count);
  states_.resize(count * starts_->width());
  for (std::uint32_t e = 0; e < count; ++e) {
    const double before = settings.failure_replay_fraction * static_cast<double>(first + e);
    is_hard_[e] =
        std::floor(before + settings.failure_replay_fraction) > std::floor(before) ? 1 : 0;
  }
}

void ReplayedEnvironments::reset(Environments& environments, std::uint64_t seed,
                                 float* observation) {
  seed_ = seed;
  std::ranges::fill(episode_, 0U);
  const auto set_all = [&] {
    for (std::size_t e = 0; e < is_hard_.size(); ++e) note(e);
    set(environments);
  };
  set_all();
  environments.reset(seed, observation);
  set_all();
}

void ReplayedEnvironments::note(std::size_t environment) {
  if (is_hard_.empty() || is_hard_[environment] == 0) return;
  is_noted_[environment] = 1;
  any_ = true;
  Random random({seed_, static_cast<std::uint32_t>(first_ + environment), episode_[environment]++},
                entity_id("train/start"));
  const auto last = starts_->size() - 1;
  const auto sampled =
      static_cast<std::size_t>(random.uniform(0.0F, 1.0F) * static_cast<float>(starts_->size()));
  std::copy_n(starts_->at(std::min(sampled, last)), starts_->width(),
              &states_[environment * starts_->width()]);
}

void ReplayedEnvironments::set(Environments& environments) {
  if (!any_) return;
  if (set_states_(environments.handle(), is_noted_.data(), states_.data()) != 0)
    throw Problem(kProblems, "a hard start is refused: " + environments.error());
  std::ranges::fill(is_noted_, std::uint8_t{0});
  any_ = false;
}

}  // namespace eagerx::train
