#include "generator/frontend/compose/port_pattern.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "generator/frontend/read/scalar.hpp"
#include "generator/frontend/spec/format.hpp"
#include "generator/support/diagnostics/search.hpp"

namespace eagerx::gen {
namespace {

using Values = std::map<std::string, std::int64_t>;

/// The values that a name of a pattern may have: from `low` up to, without, `high`.
struct Range {
  std::int64_t low = 0;
  std::optional<std::int64_t> high;
  std::string from;  // what set `high`: "`leg` has 4"
};

/// `3`, `i`, `i + 1`, `i-1`.
std::optional<PatternIndex> parse_index(std::string_view text) {
  text = trimmed(text);
  if (const auto number = parse_int(text)) return PatternIndex{{}, *number};
  const std::size_t sign = text.find_first_of("+-");
  const std::string name(trimmed(text.substr(0, sign)));
  if (!is_identifier(name)) return std::nullopt;
  if (sign == std::string_view::npos) return PatternIndex{name, 0};
  const auto offset = parse_int(trimmed(text.substr(sign + 1)));
  constexpr std::int64_t kMost = 1'000'000;
  if (!offset || *offset < 0 || *offset > kMost) return std::nullopt;
  return PatternIndex{name, text[sign] == '-' ? -*offset : *offset};
}

std::int64_t value_of(const PatternIndex& index, const Values& values) {
  return index.name.empty() ? index.offset : values.at(index.name) + index.offset;
}

/// The text up to index `k`, with values: the name of what has this index.
std::string text_before(const PortPattern& pattern, std::size_t k, const Values& values) {
  std::string text = pattern.texts[0];
  for (std::size_t i = 0; i < k; ++i)
    text += fmt::format("[{}]{}", value_of(pattern.indices[i], values), pattern.texts[i + 1]);
  return text;
}

bool is_element(const PortPattern& pattern, std::size_t k) {
  return k + 1 == pattern.indices.size() && pattern.has_element();
}

IndexedPort port_of(const PortPattern& pattern, const Values& values) {
  if (!pattern.has_element())
    return {text_before(pattern, pattern.indices.size(), values), std::nullopt};
  const std::size_t last = pattern.indices.size() - 1;
  return {text_before(pattern, last, values), value_of(pattern.indices[last], values)};
}

/// As a person would write it.
std::string shown(const PatternIndex& index) {
  if (index.name.starts_with('*')) return "*";
  if (index.name.empty() || index.offset == 0)
    return index.name.empty() ? std::to_string(index.offset) : index.name;
  return fmt::format("{}{:+}", index.name, index.offset);
}

class Ranges {
 public:
  Ranges(const CountOf& count_of, Diagnostics& diagnostics)
      : count_of_(count_of), diagnostics_(diagnostics) {}

  /// False after a problem.
  bool add(const PortPattern& pattern) {
    for (std::size_t k = 0; k < pattern.indices.size(); ++k) {
      const PatternIndex& index = pattern.indices[k];
      if (!index.name.empty()) ranges_[index.name];
      if (is_element(pattern, k)) {
        if (!add_element(pattern, index)) return false;
        continue;
      }
      // The names in front of it have their first values: all elements have the same arrays.
      const std::string array = text_before(pattern, k, first_values());
      const auto count = count_of_(array);
      if (!count) return report_no_array(pattern, array);
      if (!add(pattern, index, array, *count)) return false;
    }
    return true;
  }

  /// Calls f for all values; false and a problem where there are none.
  template <class F>
  bool for_each(const PortPattern& pattern, F&& f) {
    for (const auto& [name, range] : ranges_) {
      if (!range.high) return report_endless(pattern);
      if (range.low >= *range.high) return report_none(pattern, name);
    }
    Values values = first_values();
    do f(values);
    while (next(values));
    return true;
  }

  /// How many there are of what only one side has.
  [[nodiscard]] std::int64_t count(const std::string& name) const {
    const Range& range = ranges_.at(name);
    return range.high.value_or(range.low) - range.low;
  }

 private:
  [[nodiscard]] Values first_values() const {
    Values values;
    for (const auto& [name, range] : ranges_) values[name] = range.low;
    return values;
  }

  /// The next values, the last name first; false after the last.
  bool next(Values& values) const {
    for (auto range = ranges_.rbegin(); range != ranges_.rend(); ++range) {
      if (++values[range->first] < *range->second.high) return true;
      values[range->first] = range->second.low;
    }
    return false;
  }

  bool add(const PortPattern& pattern, const PatternIndex& index, const std::string& array,
           std::int64_t count) {
    if (count == 0) return false;  // what it is has been said to be wrong
    if (index.name.empty()) {
      if (index.offset >= 0 && index.offset < count) return true;
      diagnostics_
          .error("E0392", pattern.span, fmt::format("`{}` has no element {}", array, index.offset))
          .help = fmt::format("it has {}: 0 to {}", count, count - 1);
      return false;
    }
    Range& range = ranges_[index.name];
    const bool all = index.name.starts_with('*');
    if (all && range.high && *range.high != count) {
      diagnostics_
          .error("E0391", pattern.span,
                 fmt::format("the counts do not fit: {}, `{}` has {}", range.from, array, count))
          .help = "with `*` on both sides they are connected one by one";
      return false;
    }
    range.low = std::max(range.low, -index.offset);
    if (!range.high || count - index.offset < *range.high) {
      range.high = count - index.offset;
      range.from = fmt::format("`{}` has {}", array, count);
    }
    return true;
  }

  /// How many elements the messages have is not known here.
  bool add_element(const PortPattern& pattern, const PatternIndex& index) {
    if (!index.name.empty()) {
      ranges_[index.name].low = std::max(ranges_[index.name].low, -index.offset);
      return true;
    }
    if (index.offset >= 0) return true;
    diagnostics_.error("E0392", pattern.span, "elements are counted from 0");
    return false;
  }

  bool report_no_array(const PortPattern& pattern, const std::string& name) {
    diagnostics_.error("E0392", pattern.span, fmt::format("`{}` is not an array", name)).help =
        "an array is an object or node with a `count:`; an element of a message is written behind "
        "the port: `robot.torque[0]`";
    return false;
  }

  bool report_endless(const PortPattern& pattern) {
    diagnostics_.error("E0391", pattern.span, "these two ports do not say how many there are")
        .help = "one of them is of an array, whose `count:` says it: `leg[*].torque`";
    return false;
  }

  bool report_none(const PortPattern& pattern, const std::string& name) {
    diagnostics_.error(
        "E0391", pattern.span,
        fmt::format("no `{}` fits: {}", name.starts_with('*') ? "*" : name, ranges_[name].from));
    return false;
  }

  const CountOf& count_of_;
  Diagnostics& diagnostics_;
  std::map<std::string, Range> ranges_;
};

}  // namespace

bool PortPattern::has_element() const {
  return !indices.empty() && texts.back().empty() &&
         texts[texts.size() - 2].find('.') != std::string::npos;
}

std::optional<PortPattern> parse_pattern(const Spanned<std::string>& port,
                                         Diagnostics& diagnostics) {
  PortPattern pattern;
  pattern.span = port.span;
  std::string_view rest = port.value;
  int stars = 0;
  for (std::size_t open = rest.find('['); open != std::string_view::npos; open = rest.find('[')) {
    const std::size_t close = std::min(rest.find(']', open), rest.size());
    const std::string_view inside = rest.substr(open + 1, std::max(close, open + 1) - open - 1);
    const auto index =
        trimmed(inside) == "*" ? PatternIndex{fmt::format("*{}", stars++), 0} : parse_index(inside);
    if (!index || close == rest.size()) {
      diagnostics
          .error("E0392", port.span, fmt::format("`{}` has no index in its brackets", port.value))
          .help = "an index is a number, `*` for all, or a name: `leg[i].x` to `leg[i + 1].y`";
      return std::nullopt;
    }
    pattern.texts.emplace_back(rest.substr(0, open));
    pattern.indices.push_back(*index);
    rest.remove_prefix(close + 1);
  }
  pattern.texts.emplace_back(rest);
  return pattern;
}

std::vector<IndexedPort> indexed_ports(const PortPattern& pattern, const CountOf& count_of,
                                       Diagnostics& diagnostics) {
  std::vector<IndexedPort> result;
  Ranges ranges(count_of, diagnostics);
  if (ranges.add(pattern))
    ranges.for_each(pattern,
                    [&](const Values& values) { result.push_back(port_of(pattern, values)); });
  return result;
}

std::vector<IndexedConnection> indexed_connections(const PortPattern& from, const PortPattern& to,
                                                   const CountOf& count_of,
                                                   Diagnostics& diagnostics) {
  std::vector<IndexedConnection> result;
  Ranges ranges(count_of, diagnostics);
  if (!ranges.add(from) || !ranges.add(to)) return {};
  for (const PatternIndex& index : from.indices) {
    const bool shared =
        index.name.empty() || ranges::contains(to.indices, index.name, &PatternIndex::name);
    if (shared || ranges.count(index.name) == 1) continue;
    diagnostics
        .error("E0391", from.span,
               fmt::format("`[{}]` stands for {} messages, and one input takes one", shown(index),
                           ranges.count(index.name)))
        .help = "write the same index behind the other end, or add them with a node such as `Sum`";
    return {};
  }
  ranges.for_each(to, [&](const Values& values) {
    result.push_back({port_of(from, values), port_of(to, values)});
  });
  return result;
}

}  // namespace eagerx::gen
