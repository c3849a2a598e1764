#include "generator/emit/schedule_view.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace eagerx::gen {
namespace {

class ScheduleView {
 public:
  ScheduleView(const Plan& plan, const ProgramNames& names)
      : plan_(plan), schedule_(plan.schedule), names_(names) {}

  View make() {
    for (const char* form : {"constants", "kinds", "countdown", "slots"}) view_.set(form, false);
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
        break;
      case ScheduleForm::countdown:
        view_.set("text", "the next slot is found by a countdown of every rate");
        view_["countdown"] = countdown();
        break;
    }
    const bool is_known = !schedule_.masks.empty() && schedule_.form != ScheduleForm::table;
    view_.set("at_run_time", !is_known);
    view_.set("first", is_known ? constant(schedule_.masks.front()) : "due_");
    return std::move(view_);
  }

 private:
  std::string constant(std::uint64_t mask) const {
    std::vector<std::string> bits;
    for (std::size_t r = 0; r < plan_.rates.size(); ++r) {
      if ((mask >> r & 1U) != 0) bits.push_back(names_.due[r]);
    }
    return fmt::format("eagerx::Constant<{}>{{}}", fmt::join(bits, " | "));
  }

  /// The slots after the environment's own, equal neighbours as one loop.
  View constants() const {
    View runs = list();
    for (std::size_t i = 1; i < schedule_.runs.size(); ++i) {
      const auto& [mask, slots] = schedule_.runs[i];
      View run = object();
      run.set("due", constant(mask));
      run.set("count", slots == 1 ? View(false) : View(fmt::format("{}", slots)));
      runs.push_back(run);
    }
    View view = object();
    view["runs"] = std::move(runs);
    return view;
  }

  View kinds() const {
    View cases = list();
    const std::uint64_t environment = std::uint64_t{1} << plan_.nodes[Graph::kEnvironment].rate;
    for (std::size_t i = 0; i < schedule_.kinds.size(); ++i) {
      View item = object();
      item.set("kind", fmt::format("{}", i));
      item.set("due", constant(schedule_.kinds[i]));
      item.set("observes", (schedule_.kinds[i] & environment) != 0);
      cases.push_back(item);
    }
    View view = object();
    view["cases"] = std::move(cases);
    return view;
  }

  View table_of_kinds() const {
    std::vector<std::string> values;
    for (const std::uint64_t mask : schedule_.masks) {
      const auto kind = std::ranges::find(schedule_.kinds, mask) - schedule_.kinds.begin();
      values.push_back(fmt::format("{}", kind));
    }
    View view = table(values, "std::uint8_t");
    view.set("comment", "The kind of every slot");
    view.set("constant", "kKindAt");
    view.set("function", "next_kind");
    view.set("found", "kind");
    return view;
  }

  View table_of_masks() const {
    std::vector<std::string> values;
    for (const std::uint64_t mask : schedule_.masks) values.push_back(fmt::format("{}", mask));
    const std::size_t bits = plan_.rates.size();
    View view = table(values, bits <= 8    ? "std::uint8_t"
                              : bits <= 16 ? "std::uint16_t"
                              : bits <= 32 ? "std::uint32_t"
                                           : "std::uint64_t");
    view.set("comment", "The rates that are due, slot by slot");
    view.set("constant", "kDueAt");
    view.set("function", "next");
    view.set("found", "due");
    return view;
  }

  static View table(const std::vector<std::string>& values, const char* type) {
    View view = object();
    view.set("type", type);
    view.set("count", fmt::format("{}", values.size()));
    view.set("values", braced(values));
    return view;
  }

  View countdown() const {
    std::vector<std::string> periods;
    for (const auto& rate : plan_.rates) periods.push_back(fmt::format("{}", rate.period));
    View view = object();
    view.set("rates", fmt::format("{}", periods.size()));
    view.set("periods", braced(periods));
    return view;
  }

  const Plan& plan_;
  const Schedule& schedule_;
  const ProgramNames& names_;
  View view_ = object();
};

}  // namespace

View schedule_view(const Plan& plan, const ProgramNames& names) {
  return ScheduleView(plan, names).make();
}

}  // namespace eagerx::gen
