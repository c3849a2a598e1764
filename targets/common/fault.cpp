#include <algorithm>
#include <cmath>
#include <runtime/host/base/nearest.hpp>
#include <runtime/host/base/number.hpp>
#include <targets/common/fault.hpp>
#include <utility>

namespace eagerx::target {
namespace {

bool read_kind(std::string_view text, Fault& fault) {
  if (text == "silent") return fault.kind = Fault::Kind::silent, true;
  if (text == "nan") return fault.kind = Fault::Kind::nan, true;
  constexpr std::string_view kOffset = "offset:", kValue = "value:";
  const bool is_offset = text.starts_with(kOffset);
  if (!is_offset && !text.starts_with(kValue)) return false;
  fault.kind = is_offset ? Fault::Kind::offset : Fault::Kind::value;
  return host::read_number(text.substr(is_offset ? kOffset.size() : kValue.size()), fault.number) &&
         std::isfinite(static_cast<float>(fault.number));
}

/// `@STEP`, `+STEPS`, both or nothing.
bool read_time(std::string_view text, Fault& fault) {
  if (text.starts_with('@')) {
    const std::string_view step = text.substr(1, text.find('+') - 1);
    Seq begins = 0;
    if (!host::read_number(step, begins)) return false;
    fault.begins = begins;
    text.remove_prefix(1 + step.size());
  }
  if (text.empty()) return true;
  return text.front() == '+' && host::read_number(text.substr(1), fault.steps) && fault.steps > 0;
}

/// Where the time begins: the + of 1e+5 is not that of the steps.
std::size_t time_of(std::string_view what) {
  if (const std::size_t at = what.find('@'); at != std::string_view::npos) return at;
  const std::size_t plus = what.rfind('+');
  if (plus == std::string_view::npos) return what.size();
  const bool is_exponent = plus > 0 && (what[plus - 1] == 'e' || what[plus - 1] == 'E');
  return is_exponent ? what.size() : plus;
}

std::string full_name(const FaultPlace& place) {
  return (place.is_action ? "actions." : "observations.") + place.name;
}

/// Whether `written` names the place or one of its numbers, which it puts into `placed`.
bool names(std::string_view written, const FaultPlace& place, PlacedFault& placed) {
  const std::string full = full_name(place);
  std::string_view rest = written;
  if (rest.starts_with(full)) {
    rest.remove_prefix(full.size());
  } else if (rest.starts_with(place.name)) {
    rest.remove_prefix(place.name.size());
  } else {
    return false;
  }
  placed.first = 0;
  placed.size = place.size;
  if (rest.empty()) return true;
  if (rest.size() < 3 || rest.front() != '[' || rest.back() != ']') return false;
  placed.size = 1;
  return host::read_number(rest.substr(1, rest.size() - 2), placed.first) &&
         placed.first < place.size;
}

std::string list_of(const std::vector<FaultPlace>& places) {
  std::string text = "available: ";
  for (const FaultPlace& place : places) {
    if (&place != places.data()) text += ", ";
    text += full_name(place);
    if (place.size > 1) text += " (" + std::to_string(place.size) + " numbers)";
  }
  return places.empty() ? "this graph has neither observations nor actions" : text;
}

/// `observations/angle` is `observations.angle`.
std::string spelled(const std::string& name, const std::vector<FaultPlace>& places) {
  std::vector<std::string> known;
  for (const FaultPlace& place : places) known.push_back(full_name(place));
  const std::size_t end = name.find('[');
  const std::string* const other = host::spelled_otherwise(name.substr(0, end), known);
  return other == nullptr ? name : *other + name.substr(std::min(end, name.size()));
}

std::string near(const std::string& name, const std::vector<FaultPlace>& places) {
  std::vector<std::string> known;
  for (const FaultPlace& place : places) known.push_back(place.name);
  for (const FaultPlace& place : places) known.push_back(full_name(place));
  const std::string whole = name.substr(0, name.find('['));
  const bool is_known = std::find(known.begin(), known.end(), whole) != known.end();
  const std::string meant = is_known ? "" : host::did_you_mean(whole, known);
  return meant.empty() ? list_of(places) : meant;
}

}  // namespace

std::optional<Fault> parse_fault(std::string_view text) {
  const std::size_t equals = text.find('=');
  if (equals == 0 || equals == std::string_view::npos) return std::nullopt;
  Fault fault;
  fault.name = text.substr(0, equals);
  const std::string_view what = text.substr(equals + 1);
  const std::size_t time = time_of(what);
  if (!read_kind(what.substr(0, time), fault) || !read_time(what.substr(time), fault))
    return std::nullopt;
  fault.written = text.substr(0, equals + 1 + time);
  if (fault.steps != std::numeric_limits<Seq>::max())
    fault.written += "+" + std::to_string(fault.steps);
  return fault;
}

std::optional<PlacedFault> place_fault(Fault fault, const std::vector<FaultPlace>& places,
                                       FaultProblem& problem) {
  const std::string written = std::exchange(fault.name, spelled(fault.name, places));
  if (written != fault.name) {
    problem.note = "`" + written + "` is `" + fault.name + "` here";
    fault.written.replace(0, written.size(), fault.name);  // what a campaign samples by
  }
  std::optional<PlacedFault> found;
  for (std::size_t i = 0; i < places.size(); ++i) {
    PlacedFault placed;
    placed.place = i;
    if (!names(fault.name, places[i], placed)) continue;
    if (found) {
      problem = {
          "`" + fault.name + "` is an observation and an action",
          "write `" + full_name(places[found->place]) + "` or `" + full_name(places[i]) + "`"};
      return std::nullopt;
    }
    found = placed;
  }
  if (!found) {
    problem = {"there is no observation and no action `" + fault.name + "`",
               near(fault.name, places)};
    return std::nullopt;
  }
  if (fault.kind != Fault::Kind::silent && !places[found->place].is_real) {
    problem = {"`" + fault.name + "` has whole numbers", "such a message can only be `silent`"};
    return std::nullopt;
  }
  found->fault = std::move(fault);
  return found;
}

}  // namespace eagerx::target
