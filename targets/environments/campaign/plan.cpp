#include "targets/environments/campaign/plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <eagerx/random.hpp>
#include <limits>
#include <runtime/host/base/nearest.hpp>
#include <set>
#include <utility>

#include "targets/environments/client/problem.hpp"

namespace eagerx::campaign {
namespace {

using client::Description;
using client::kProblems;
using client::Problem;
using client::Space;

[[noreturn]] void refuse_name(const std::string& name, const Description& description) {
  std::vector<std::string> names;
  for (const Space& state : description.states) names.push_back(state.name);
  const std::string write =
      "a state that can be varied is under `states:` of the graph, a delay has "
      "a range in the graph: what is only in `config:` is compiled in";
  const std::string near = host::did_you_mean(name, names);
  const std::string help = !near.empty() ? near
                           : names.empty()
                               ? "this graph has nothing to vary; " + write
                               : fmt::format("available: {}; {}", fmt::join(names, ", "), write);
  throw Problem(kProblems, fmt::format("`{}` cannot be varied", name), help);
}

/// The name as the graph spells it; the element, if there is one, stays.
std::string known_name(const std::string& name, const Description& description) {
  std::vector<std::string> names;
  for (const Space& state : description.states) names.push_back(state.name);
  // Names of arrays have brackets themselves.
  for (const std::size_t end : {name.size(), name.rfind('[')}) {
    const std::string whole = name.substr(0, end);
    if (std::ranges::find(names, whole) != names.end()) return name;
    const std::string* const spelled = host::name_meant(whole, names);
    if (spelled == nullptr) continue;
    fmt::print(stderr, "note: `{}` is `{}` here\n", whole, *spelled);
    return *spelled + name.substr(whole.size());
  }
  return name;
}

/// The columns of a name, which may be an element.
struct Place {
  const Space& space;
  std::size_t first = 0, size = 0, element = 0;
};
Place place_of(const std::string& name, const Description& description) {
  const std::string whole = name.substr(0, name.find('['));
  std::size_t column = 0;
  for (const Space& state : description.states) {
    if (name == state.name) return {state, column, state.size, 0};
    for (std::size_t i = 0; !state.is_scalar && i < state.size; ++i) {
      if (name == fmt::format("{}[{}]", state.name, i)) return {state, column + i, 1, i};
    }
    if (whole == state.name) {
      throw Problem(kProblems, fmt::format("there is no `{}`", name),
                    state.is_scalar
                        ? fmt::format("`{}` is one number", whole)
                        : fmt::format("write `{}[0]` to `{}[{}]`", whole, whole, state.size - 1));
    }
    column += state.size;
  }
  refuse_name(whole, description);
}

void check_range(const Variation& variation, const Place& place) {
  for (std::size_t i = 0; i < place.size; ++i) {
    const double low = place.space.low[place.element + i],
                 high = place.space.high[place.element + i];
    // Bounds are those of float32, ours are decimals.
    const bool fits = static_cast<float>(variation.low) >= static_cast<float>(low) &&
                      static_cast<float>(variation.high) <= static_cast<float>(high);
    if (fits) continue;
    throw Problem(kProblems,
                  fmt::format("`{}` cannot be from {} to {}: its space is from {} to {}",
                              variation.name, variation.low, variation.high, low, high),
                  "choose a range within it, or give the state another `space` in the graph");
  }
}

bool is_double(const Space& space) {
  return space.dtype == "float64";
}

void check_graph(const Description& description) {
  if (!description.has_success) {
    throw Problem(kProblems, "the graph has no success to count",
                  "write into its `task:` what success is, such as "
                  "`success: {upright: abs(th) < 0.15, over_last: 2.0}`");
  }
  for (const auto& [kind, spaces] :
       {std::pair("observation", &description.observations), {"action", &description.actions}}) {
    for (const Space& space : *spaces) {
      if (!is_double(space)) continue;
      throw Problem(kProblems,
                    fmt::format("the {} `{}` is float64, but a campaign's rows are float32", kind,
                                space.name),
                    "leave out `real: double`, or give it a space with `dtype: float32`");
    }
  }
}

/// Of a state in double, an element that is not varied would be repeated with its float32 only.
void check_element(const Variation& variation, const Place& place) {
  if (!is_double(place.space) || place.size == place.space.size) return;
  throw Problem(
      kProblems, fmt::format("`{}` is float64: its elements are varied together", place.space.name),
      fmt::format("write `--vary {}={}:{}`", place.space.name, variation.low, variation.high));
}

std::vector<target::FaultPlace> fault_places(const Description& description) {
  std::vector<target::FaultPlace> places;
  const auto add = [&](const std::vector<Space>& spaces, bool is_action) {
    for (const Space& space : spaces)
      places.push_back({space.name, is_action, space.size, space.dtype.starts_with("float")});
  };
  add(description.observations, false);
  add(description.actions, true);
  return places;
}

/// With the numbers counted from the first of the row.
target::PlacedFault in_row(target::PlacedFault placed,
                           const std::vector<target::FaultPlace>& places) {
  const bool is_action = places[placed.place].is_action;
  for (std::size_t i = 0; i < placed.place; ++i)
    placed.first += places[i].is_action == is_action ? places[i].size : 0;
  placed.place = static_cast<std::size_t>(is_action ? FaultRow::action : FaultRow::observation);
  return placed;
}

void add_faults(Plan& plan, const Description& description, std::vector<target::Fault> faults) {
  const std::vector<target::FaultPlace> places = fault_places(description);
  std::set<std::string> given;
  for (target::Fault& fault : faults) {
    if (!given.insert(text_of(fault)).second)
      throw Problem(client::kUsage, fmt::format("`{}` is given twice", text_of(fault)));
    target::FaultProblem problem;
    auto placed = target::place_fault(std::move(fault), places, problem);
    if (!problem.note.empty()) fmt::print(stderr, "note: {}\n", problem.note);
    if (!placed) throw Problem(kProblems, problem.what, problem.help);
    plan.faults.push_back(in_row(std::move(*placed), places));
  }
}

}  // namespace

std::string text_of(const target::Fault& fault) {
  if (!fault.begins) return fault.written;
  const std::size_t steps = fault.written.rfind('+');
  const bool lasts = fault.steps == std::numeric_limits<Seq>::max();
  const std::size_t end = lasts ? fault.written.size() : steps;
  return fmt::format("{}@{}{}", fault.written.substr(0, end), *fault.begins,
                     fault.written.substr(end));
}

std::string Plan::name_of(std::size_t number) const {
  if (number < columns.size()) return columns[number];
  return text_of(faults[number - columns.size()].fault);
}

std::vector<target::PlacedFault> Plan::faults_of(std::uint32_t run) const {
  std::vector<target::PlacedFault> result = faults;
  for (target::PlacedFault& one : result) {
    if (one.fault.begins) continue;
    Random random({seed, run, 0}, entity_id(("campaign/fault/" + one.fault.written).c_str()));
    one.fault.begins = random.below(longest);
  }
  return result;
}

std::vector<float> Plan::states_of(std::uint32_t run) const {
  std::vector<float> row(columns.size(), std::numeric_limits<float>::quiet_NaN());
  for (const Sampled& one : sampled) {
    Random random({seed, run, 0}, entity_id(one.stream.c_str()));
    row[one.column] =
        one.is_real ? random.uniform(static_cast<float>(one.low), static_cast<float>(one.high))
                    : static_cast<float>(random.uniform(static_cast<std::int64_t>(one.low),
                                                        static_cast<std::int64_t>(one.high)));
  }
  return row;
}

Plan make_plan(const Description& description, std::uint64_t seed, std::uint32_t runs,
               std::uint32_t steps, std::vector<Variation> variations,
               std::vector<target::Fault> faults) {
  check_graph(description);
  Plan plan;
  plan.seed = seed;
  plan.runs = runs;
  plan.longest = steps != 0                       ? steps
                 : description.episode_steps != 0 ? description.episode_steps
                                                  : kDefaultSteps;
  plan.columns = client::column_names(description.states);
  std::set<std::size_t> taken;
  for (Variation& variation : variations) {
    variation.name = known_name(variation.name, description);
    const Place place = place_of(variation.name, description);
    check_range(variation, place);
    check_element(variation, place);
    for (std::size_t i = 0; i < place.size; ++i) {
      const std::size_t column = place.first + i;
      if (!taken.insert(column).second)
        throw Problem(client::kUsage, fmt::format("`{}` is varied twice", plan.columns[column]));
      plan.sampled.push_back({column, "campaign/" + plan.columns[column],
                              place.space.dtype.starts_with("float"), variation.low,
                              variation.high});
    }
  }
  plan.variations = std::move(variations);
  add_faults(plan, description, std::move(faults));
  return plan;
}

}  // namespace eagerx::campaign
