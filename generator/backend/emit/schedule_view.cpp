#include "generator/backend/emit/schedule_view.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "generator/support/diagnostics/join.hpp"
#include "generator/support/diagnostics/search.hpp"

namespace eagerx::gen {
namespace {

class ScheduleView {
 public:
  ScheduleView(const Plan& plan, const ProgramNames& names)
      : plan_(plan), schedule_(plan.schedule), names_(names) {}

  View make() {
    for (const char* form : {"constants", "kinds", "table", "countdown", "slots"})
      view_.set(form, false);
    const std::size_t slots = schedule_.masks.size();
    switch (schedule_.form) {
      case ScheduleForm::constants:
        view_.set("text", slots == 1 ? "a step is one slot"
                                     : fmt::format("a step is {} slots, written out", slots));
        view_["constants"] = constants();
        break;
      case ScheduleForm::kinds:
        view_.set("text", fmt::format("the {} slots of the hyperperiod are a table of which of "
                                      "them are alike",
                                      slots));
        view_["kinds"] = kinds();
        view_["slots"] = table_of_kinds();
        break;
      case ScheduleForm::table:
        view_.set("text",
                  fmt::format("the {} slots of the hyperperiod are a table of masks", slots));
        view_["slots"] = table_of_masks();
        view_["table"] = table_of_masks();
        break;
      case ScheduleForm::countdown:
        view_.set("text", "the next slot is found by a countdown of every rate");
        view_["countdown"] = countdown();
        break;
    }
    view_.set("has_state", schedule_.form != ScheduleForm::constants);
    view_.set("first", first());
    return std::move(view_);
  }

 private:
  std::string constant(std::uint64_t mask) const {
    std::vector<std::string> bits;
    for (std::size_t r = 0; r < plan_.rates.size(); ++r) {
      if ((mask >> r & 1U) != 0) bits.push_back(names_.rates[r].due);
    }
    return fmt::format("eagerx::Constant<{}>{{}}", join(bits, " | "));
  }

  /// The name of a kind of slot: the rates that are due.
  std::string kind_name(std::uint64_t mask) const {
    std::string name = "due";
    for (std::size_t r = 0; r < plan_.rates.size(); ++r) {
      if ((mask >> r & 1U) != 0) name += "_" + names_.rates[r].due.substr(1);
    }
    return name;
  }

  /// Rates that are due in the first slot or, where the compiler does not know it, in that of the
  /// last observation.
  std::string first() const {
    if (schedule_.form == ScheduleForm::countdown) return "due_";
    return schedule_.form == ScheduleForm::table ? "due_now()" : constant(schedule_.masks.front());
  }

  /// The slots after the environment's own, equal neighbours as one loop.
  View constants() const {
    View runs = list();
    for (std::size_t i = 1; i < schedule_.runs.size(); ++i) {
      const auto& [mask, slots] = schedule_.runs[i];
      View run = object();
      run.set("due", constant(mask));
      run.set("count", slots == 1 ? View(false) : View(fmt::format("{}", slots)));
      runs.push_back(std::move(run));
    }
    View view = object();
    view["runs"] = std::move(runs);
    return view;
  }

  View kinds() const {
    View cases = list(), observing = list();
    const std::uint64_t environment = std::uint64_t{1} << plan_.nodes[Graph::kEnvironment].rate;
    for (std::size_t i = 0; i < schedule_.kinds.size(); ++i) {
      View item = object();
      // The table has no others, so the last one is what is left.
      item.set("kind", "Slot::" + kind_name(schedule_.kinds[i]));
      item.set("is_last", i + 1 == schedule_.kinds.size());
      item.set("due", constant(schedule_.kinds[i]));
      item.set("observes", (schedule_.kinds[i] & environment) != 0);
      if (i > 0) cases.push_back(item);  // the first kind is that of the first slot alone
      const bool all = ranges::all_of(
          schedule_.kinds, [&](std::uint64_t mask) { return (mask & environment) != 0; });
      if (!all) item.set("is_last", false);
      if ((schedule_.kinds[i] & environment) != 0) observing.push_back(std::move(item));
    }
    View view = table_of_kinds();
    const std::size_t observed = observing.list_value().size();
    view.set("may_be_none", observed != schedule_.kinds.size());
    view["observing"] = std::move(observing);
    view["cases"] = std::move(cases);
    return view;
  }

  View table_of_kinds() const {
    std::vector<std::string> values;
    for (const std::uint64_t mask : schedule_.masks) {
      const auto kind = ranges::find(schedule_.kinds, mask) - schedule_.kinds.begin();
      values.push_back(fmt::format("{}", kind));
    }
    View view = table(values, "std::uint8_t");
    view.set("comment", "The kind of every slot, by its number in Slot");
    view.set("constant", "kSlotAt");
    view.set("is_table", false);
    View names = list();
    for (const std::uint64_t kind : schedule_.kinds) {
      View item = object();
      item.set("enumerator", kind_name(kind));
      names.push_back(std::move(item));
    }
    view.set("has_names", true);
    view["names"] = std::move(names);
    return view;
  }

  View table_of_masks() const {
    std::vector<std::string> values;
    // A step that begins near the end finds its next slots behind it.
    for (std::size_t i = 0; i < schedule_.masks.size() + most_slots(plan_); ++i)
      values.push_back(fmt::format("{}", schedule_.masks[i % schedule_.masks.size()]));
    const std::size_t bits = plan_.rates.size();
    View view = table(values, bits <= 8    ? "std::uint8_t"
                              : bits <= 16 ? "std::uint16_t"
                              : bits <= 32 ? "std::uint32_t"
                                           : "std::uint64_t");
    view.set("comment", "The rates that are due, slot by slot");
    view.set("constant", "kDueAt");
    view.set("is_table", true);
    view.set("has_names", false);
    view["names"] = list();
    return view;
  }

  View table(const std::vector<std::string>& values, const char* type) const {
    View view = object();
    view.set("type", type);
    view.set("count", fmt::format("{}", values.size()));
    view.set("most_slots", fmt::format("{}", most_slots(plan_)));
    view.set("slots", fmt::format("{}", schedule_.masks.size()));
    view.set("last", fmt::format("{}", schedule_.masks.size() - 1));
    view.set("values", braced(values));
    return view;
  }

  View countdown() const {
    std::vector<std::string> periods;
    for (const auto& rate : plan_.rates) periods.push_back(fmt::format("{}", rate.period));
    View view = object();
    view.set("rates", fmt::format("{}", periods.size()));
    view.set("most_slots", fmt::format("{}", most_slots(plan_)));
    view.set("periods", braced(periods));
    return view;
  }

  const Plan& plan_;
  const Schedule& schedule_;
  const ProgramNames& names_;
  View view_ = object();
};

}  // namespace

std::uint64_t most_slots(const Plan& plan) {
  const std::vector<std::uint64_t>& masks = plan.schedule.masks;
  const std::size_t own = plan.nodes[Graph::kEnvironment].rate;
  const auto observes = [&](std::uint64_t mask) { return (mask >> own & 1U) != 0; };
  std::uint64_t most = 0, since = 0;
  // Twice, because the last ones continue at the beginning.
  for (std::size_t i = 0; i < 2 * masks.size(); ++i) {
    ++since;
    if (!observes(masks[i % masks.size()])) continue;
    most = std::max(most, since);
    since = 0;
  }
  if (!masks.empty()) return most;
  // Every slot is a tick of some rate.
  for (const auto& rate : plan.rates)
    most += static_cast<std::uint64_t>((rate.rate_hz / plan.rates[own].rate_hz).ceil());
  return most;
}

View schedule_view(const Plan& plan, const ProgramNames& names) {
  return ScheduleView(plan, names).make();
}

}  // namespace eagerx::gen
