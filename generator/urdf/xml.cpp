#include "generator/urdf/xml.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "generator/frontend/read/scalar.hpp"

namespace eagerx::urdf {
namespace {

/// The number that is read where there is an error: no comparison holds, so that it is reported
/// once.
constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();

constexpr std::string_view kBlanks = " \t\n\r";
constexpr std::string_view kBetweenNumbers = " \t\n\r,";

bool contains(Names names, std::string_view name) {
  return std::ranges::find(names, name) != names.end();
}

std::vector<std::string_view> words(std::string_view text) {
  std::vector<std::string_view> result;
  for (std::size_t at = text.find_first_not_of(kBetweenNumbers); at != std::string_view::npos;) {
    const std::size_t end = std::min(text.find_first_of(kBetweenNumbers, at), text.size());
    result.push_back(text.substr(at, end - at));
    at = text.find_first_not_of(kBetweenNumbers, end);
  }
  return result;
}

std::optional<double> finite_number(std::string_view text) {
  const auto value = gen::parse_number(text);
  // -0 is 0: the sign has no meaning.
  return value && std::isfinite(*value) ? std::optional(*value + 0.0) : std::nullopt;
}

/// Elements of other tools that do not change what is simulated here: pictures, controllers,
/// simulators' own parameters.
constexpr std::string_view kHarmless[] = {"actuator",
                                          "audio_source",
                                          "bullet",
                                          "calibration",
                                          "capability",
                                          "collision_checking",
                                          "contact",
                                          "gazebo",
                                          "kinematic",
                                          "material",
                                          "mujoco",
                                          "ros2_control",
                                          "self_collision_checking",
                                          "safety_controller",
                                          "self_filter",
                                          "sensor",
                                          "surface",
                                          "transmission",
                                          "user-data",
                                          "velocity",
                                          "verbose",
                                          "visual"};
/// Prefixes of other tools' elements.
constexpr std::string_view kForeign[] = {"drake:", "sensor:", "interface:", "controller:"};

bool is_harmless(std::string_view name) {
  const auto begins = [name](std::string_view prefix) { return name.starts_with(prefix); };
  return std::ranges::find(kHarmless, name) != std::end(kHarmless) ||
         std::ranges::any_of(kForeign, begins);
}

/// Elements that would change the motion.
constexpr std::string_view kRefused[] = {"deformable", "reduced_deformable", "loop_joint",
                                         "drake:loop_joint", "drake:linear_bushing_rpy"};

std::string choices(const Contents& contents) {
  std::string result;
  for (const Names names : {contents.once, contents.many}) {
    for (const std::string_view name : names)
      result += fmt::format("{}`{}`", result.empty() ? "" : ", ", name);
  }
  return result;
}

gen::Help help_for(std::string_view name, const Contents& contents) {
  if (name.starts_with("xacro:")) return "name the file `….urdf.xacro`: then `xacro` expands it";
  if (name.ends_with("deformable")) return "only rigid bodies can be simulated";
  if (name.find("loop") != std::string_view::npos) return "joints must make a tree";
  std::vector<std::string> candidates;
  for (const Names names : {contents.once, contents.many})
    candidates.insert(candidates.end(), names.begin(), names.end());
  const std::string all = choices(contents);
  return gen::did_you_mean(
      name, candidates,
      all.empty() ? "nothing is read inside of it" : "elements that are read here: " + all);
}

}  // namespace

pugi::xml_node Xml::parse(pugi::xml_document& document, Names names) {
  const std::string_view text = locator_.text();
  const auto result =
      document.load_buffer(text.data(), text.size(), pugi::parse_default, pugi::encoding_utf8);
  if (!result) {
    const auto at = std::min(static_cast<std::size_t>(result.offset), text.size());
    std::string why = result.description();
    if (!why.empty() && why[0] >= 'A' && why[0] <= 'Z') why[0] += 'a' - 'A';
    error("E0850", locator_.span({at, at + 1}), fmt::format("not well-formed XML: {}", why));
    return {};
  }
  const pugi::xml_node root = document.document_element();
  if (!contains(names, root.name())) {
    error("E0850", root ? span(root) : locator_.whole(), "this is not a URDF or MJCF file").help =
        "its first element is `robot` or `mujoco`";
    return {};
  }
  for (pugi::xml_node other = root.next_sibling(); other; other = other.next_sibling()) {
    if (other.type() == pugi::node_element)
      error("E0850", span(other), "there is a second element at the top of the file");
  }
  return root;
}

std::size_t Xml::offset_of(pugi::xml_node element) const {
  const std::ptrdiff_t offset = element.offset_debug();
  return offset < 0 ? 0 : std::min(static_cast<std::size_t>(offset), locator_.text().size());
}

gen::Span Xml::span(pugi::xml_node element) const {
  const std::size_t begin = offset_of(element);
  return locator_.span({begin, begin + std::string_view(element.name()).size()});
}

gen::Span Xml::span(pugi::xml_node element, const char* attribute) const {
  const std::string_view text = locator_.text(), name = attribute;
  const std::size_t end = text.find('>', offset_of(element));
  for (std::size_t at = text.find(name, offset_of(element)); at < end;
       at = text.find(name, at + 1)) {
    const std::size_t after = text.find_first_not_of(kBlanks, at + name.size());
    if (after >= text.size() || text[after] != '=') continue;
    if (kBlanks.find(text[at - 1]) == std::string_view::npos) continue;
    const std::size_t quote = text.find_first_not_of(kBlanks, after + 1);
    if (quote >= text.size()) break;
    const std::size_t close = text.find(text[quote], quote + 1);
    return locator_.span({at, std::min(close, text.size() - 1) + 1});
  }
  return span(element);
}

void Xml::check(pugi::xml_node element, const Contents& contents) {
  check_attributes(element, contents);
  for (const pugi::xml_node child : element.children()) {
    if (child.type() == pugi::node_element) check_child(element, child, contents);
  }
}

void Xml::check_attributes(pugi::xml_node element, const Contents& contents) {
  std::vector<std::string_view> seen;
  for (const pugi::xml_attribute attribute : element.attributes()) {
    const std::string_view name = attribute.name();
    if (name.starts_with("xmlns")) continue;
    if (contains(contents.ignored_attributes, name)) {
      leave_out(fmt::format("`{}` of `{}`", name, element.name()), span(element, attribute.name()),
                true);
    } else if (!contains(contents.attributes, name)) {
      const std::vector<std::string> known{contents.attributes.begin(), contents.attributes.end()};
      if (gen::nearest(name, known).empty()) {
        leave_out(fmt::format("`{}` of `{}`", name, element.name()),
                  span(element, attribute.name()), false);
      } else {
        error("E0851", span(element, attribute.name()),
              fmt::format("`{}` has no attribute `{}`", element.name(), name))
            .help = gen::did_you_mean(name, known);
      }
    } else if (std::ranges::find(seen, name) != seen.end()) {
      error("E0854", span(element, attribute.name()),
            fmt::format("`{}` has `{}` twice", element.name(), name));
    }
    seen.push_back(name);
  }
}

void Xml::check_child(pugi::xml_node element, pugi::xml_node child, const Contents& contents) {
  const std::string_view name = child.name();
  if (contains(contents.many, name) || contains(contents.unseen, name)) return;
  if (contains(contents.once, name)) {
    if (element.child(child.name()) != child)
      error("E0854", span(child), fmt::format("`{}` has `{}` twice", element.name(), name));
    return;
  }
  if (contains(contents.ignored, name))
    return leave_out(fmt::format("`{}`", name), span(child), true);
  std::vector<std::string> known;
  for (const Names names : {contents.once, contents.many})
    known.insert(known.end(), names.begin(), names.end());
  const bool is_refused =
      name.starts_with("xacro:") || std::ranges::find(kRefused, name) != std::end(kRefused);
  if (!is_refused && (is_harmless(name) || gen::nearest(name, known).empty())) {
    leave_out(is_harmless(name) ? fmt::format("`{}`", name)
                                : fmt::format("`{}` in `{}`", name, element.name()),
              span(child), is_harmless(name));
    return;
  }
  error("E0851", span(child), fmt::format("`{}` in `{}` is not supported", name, element.name()))
      .help = help_for(name, contents);
}

void Xml::leave_out(std::string name, gen::Span place, bool is_harmless) {
  LeftOut& item = (is_harmless ? harmless_ : unknown_)[std::move(name)];
  if (item.count++ == 0) item.first = place;
}

std::string Xml::list(const LeftOutItems& items) {
  std::string text;
  for (const auto& [name, item] : items) {
    text += (text.empty() ? "" : ", ") + name;
    if (item.count > 1) text += fmt::format(" ({} times)", item.count);
  }
  return text;
}

void Xml::report_left_out() {
  if (!harmless_.empty())
    diagnostics_.note(harmless_.begin()->second.first,
                      "left out, as it does not change the motion: " + list(harmless_));
  if (!unknown_.empty())
    diagnostics_.warning("E0851", unknown_.begin()->second.first,
                         "unknown, and left out: " + list(unknown_));
}

void Xml::report_with(const Xml& other) {
  for (const bool harmless : {true, false}) {
    for (const auto& [name, item] : harmless ? other.harmless_ : other.unknown_) {
      LeftOut& mine = (harmless ? harmless_ : unknown_)[name];
      if (mine.count == 0) mine.first = item.first;
      mine.count += item.count;
    }
  }
}

pugi::xml_node Xml::child(pugi::xml_node element, const char* name) {
  const pugi::xml_node result = element.child(name);
  if (!result) error("E0852", span(element), fmt::format("`{}` has no `{}`", element.name(), name));
  return result;
}

bool Xml::is_missing(pugi::xml_node element, const char* attribute, bool optional) {
  if (element.attribute(attribute)) return false;
  // A missing element has been reported already.
  if (element && !optional)
    error("E0852", span(element),
          fmt::format("`{}` has no attribute `{}`", element.name(), attribute));
  return true;
}

std::string Xml::text(pugi::xml_node element, const char* attribute) {
  if (is_missing(element, attribute, false)) return {};
  std::string result = element.attribute(attribute).value();
  if (result.empty())
    error("E0852", span(element, attribute), fmt::format("`{}` is empty", attribute));
  return result;
}

double Xml::number(pugi::xml_node element, const char* attribute, std::optional<double> fallback) {
  if (is_missing(element, attribute, fallback.has_value())) return fallback.value_or(kNoNumber);
  const std::string_view written = element.attribute(attribute).value();
  const auto list = words(written);
  const auto value = list.size() == 1 ? finite_number(list[0]) : std::nullopt;
  if (!value)
    error("E0853", span(element, attribute),
          fmt::format("`{}` has to be a number, not `{}`", attribute, written));
  return value.value_or(kNoNumber);
}

models::Vector3 Xml::vector(pugi::xml_node element, const char* attribute,
                            std::optional<models::Vector3> fallback) {
  if (is_missing(element, attribute, fallback.has_value()))
    return fallback.value_or(models::Vector3{{kNoNumber, kNoNumber, kNoNumber}});
  const std::string_view written = element.attribute(attribute).value();
  const auto list = words(written);
  models::Vector3 result{{kNoNumber, kNoNumber, kNoNumber}};
  bool is_right = list.size() >= 3;
  for (std::size_t i = 0; is_right && i < 3; ++i) {
    const auto value = finite_number(list[i]);
    is_right = value.has_value();
    result[i] = value.value_or(kNoNumber);
  }
  if (is_right && list.size() > 3)
    warning("E0853", span(element, attribute),
            fmt::format("`{}` has {} numbers: the first three are read", attribute, list.size()));
  if (!is_right)
    error("E0853", span(element, attribute),
          fmt::format("`{}` has to be three numbers, not `{}`", attribute, written));
  return result;
}

std::vector<double> Xml::numbers(pugi::xml_node element, const char* attribute, std::size_t most) {
  std::vector<double> result;
  const std::string_view written = element.attribute(attribute).value();
  const auto list = words(written);
  for (const std::string_view word : list) {
    const auto value = finite_number(word);
    if (!value || result.size() == most) break;
    result.push_back(*value);
  }
  if (result.size() == list.size()) return result;
  error("E0853", span(element, attribute),
        most == 1
            ? fmt::format("`{}` has to be a number, not `{}`", attribute, written)
            : fmt::format("`{}` has to be at most {} numbers, not `{}`", attribute, most, written));
  return {};
}

models::Vector3 Xml::direction(pugi::xml_node element, const char* attribute) {
  const models::Vector3 v = vector(element, attribute);
  const double square = dot(v, v);
  if (square == 1.0) return v;
  if (square > 1e-12 && std::isfinite(square)) return (1.0 / std::sqrt(square)) * v;
  if (!std::isnan(square))
    error("E0853", span(element, attribute),
          fmt::format("`{}` has to have a direction", attribute));
  return {{kNoNumber, kNoNumber, kNoNumber}};
}

models::Vector3 Xml::scale(pugi::xml_node element, const char* attribute) {
  if (words(element.attribute(attribute).value()).size() != 1)
    return vector(element, attribute, models::Vector3{{1.0, 1.0, 1.0}});
  const double all = number(element, attribute);
  return {{all, all, all}};
}

double Xml::positive(pugi::xml_node element, const char* attribute) {
  const double value = number(element, attribute);
  if (value <= 0.0)
    error("E0853", span(element, attribute),
          fmt::format("`{}` has to be larger than 0", attribute));
  return value;
}

double Xml::not_negative(pugi::xml_node element, const char* attribute, double fallback) {
  const double value = number(element, attribute, fallback);
  if (value < 0.0)
    error("E0853", span(element, attribute), fmt::format("`{}` cannot be negative", attribute));
  return value;
}

}  // namespace eagerx::urdf
