#include "generator/driver/commands/train_sweep.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <random>
#include <runtime/host/base/renamed.hpp>

#include "generator/driver/commands/train_settings.hpp"
#include "generator/frontend/library/schema.hpp"
#include "generator/frontend/read/scalar.hpp"
#include "generator/frontend/read/tree.hpp"
#include "generator/frontend/spec/format.hpp"
#include "generator/frontend/spec/schema.hpp"
#include "generator/support/diagnostics/search.hpp"

namespace eagerx::gen {
namespace {

using SettingRow = eagerx::options::Setting;
using eagerx::options::SettingKind;

constexpr std::size_t kMostCases = 10'000;
constexpr double kMostSeeds = 1000;
constexpr double kMostPoints = 1000;  // of a range

/// One setting of the file.
struct Swept {
  const SettingRow* row = nullptr;
  std::vector<std::string> values;  // as the trainer reads them; of a range without `count` none
  double from = 0.0, to = 0.0;      // of a range
  bool logarithmic = false;
};

bool has_range(const SettingRow& row) {
  return row.kind == SettingKind::whole || row.kind == SettingKind::number;
}

FormatPtr range_format(const FormatPtr& value) {
  return format::record(
      "a range",
      {{.name = "from", .format = value, .required = true, .about = "the least value"},
       {.name = "to", .format = value, .required = true, .about = "the greatest value"},
       {.name = "count",
        .format = format::integer("a number of values", 2, kMostPoints),
        .about = "number of values, at equal distances; not with `random`, where any is sampled"},
       {.name = "logarithmic",
        .format = format::boolean(),
        .about = "equal quotients instead of equal distances (default: false)"}});
}

FormatPtr swept_format(const SettingRow& row) {
  const FormatPtr value = setting_format(row);
  if (row.kind == SettingKind::layers) {
    return format::list("a list of widths, or a list of such lists",
                        format::one_of("a width or a list of widths", {value->item, value}), 1);
  }
  std::vector<FormatPtr> options = {value, format::list("a list of values", value, 1)};
  std::string what = value->what + ", a list of them";
  if (has_range(row)) {
    options.push_back(range_format(value));
    what += " or a range";
  }
  return format::one_of(std::move(what), std::move(options));
}

}  // namespace

const Format& train_sweep_format() {
  static const FormatPtr whole = [] {
    std::vector<Field> settings;
    for (const SettingRow& row : eagerx::options::kTrainSettings)
      settings.push_back({.name = row.name, .format = swept_format(row), .about = row.about});
    constexpr double kMostSeed = 9007199254740992.0;  // exact as a double
    return format::record(
        "a sweep",
        {{.name = "settings",
          .format = format::record(std::string(host::kTrainSettings), std::move(settings)),
          .required = true,
          .about = "one value, a list of values, or a range of each"},
         {.name = "seeds",
          .format = format::integer("a number of seeds", 1, kMostSeeds),
          .about = "trainings with each (default: 1)"},
         {.name = "random",
          .format = format::integer("how many are sampled", 1, static_cast<double>(kMostCases)),
          .about = "number of combinations to sample (default: all)"},
         {.name = "seed",
          .format = format::integer("a seed", 0, kMostSeed),
          .about = "of these samples (default: 1)"}});
  }();
  return *whole;
}

namespace {

class Reader {
 public:
  Reader(const YamlValue& yaml, Diagnostics& diagnostics, SettingPlaces& places)
      : yaml_(yaml),
        diagnostics_(diagnostics),
        places_(places),
        is_random_(yaml.find("random") != nullptr) {
    for (const auto& entry : yaml.find("settings")->entries) read(entry);
    if (swept_.empty())
      diagnostics_.error("E0204", yaml.find("settings")->span, "there is nothing to sweep over");
  }

  /// The settings of each case; nothing after an error.
  std::vector<std::string> cases() {
    if (diagnostics_.has_errors()) return {};
    return is_random_ ? sampled() : combined();
  }

 private:
  void read(const YamlValue::Entry& entry) {
    Swept one;
    one.row = ranges::find(eagerx::options::kTrainSettings, entry.key, &SettingRow::name);
    const YamlValue& value = entry.value;
    if (value.is_map()) {
      read_range(value, one);
      places_.add(entry.key, value.span);
    } else if (one.row->kind == SettingKind::layers) {
      read_layers(value, one);
    } else if (value.is_sequence()) {
      for (const YamlValue& item : value.items) add_value(one, item);
    } else {
      add_value(one, value);
    }
    swept_.push_back(std::move(one));
  }

  void read_layers(const YamlValue& value, Swept& one) {
    const auto is_list = [](const YamlValue& item) { return item.is_sequence(); };
    if (ranges::none_of(value.items, is_list)) {
      check_layers(value, diagnostics_);
      return add_value(one, value);
    }
    for (const YamlValue& item : value.items) {
      if (!item.is_sequence()) {
        auto& problem = diagnostics_.error("E0203", item.span, "a width among lists of widths");
        problem.help = fmt::format("write [{}]", item.text);
        return;
      }
      check_layers(item, diagnostics_);
      add_value(one, item);
    }
  }

  void add_value(Swept& one, const YamlValue& value) {
    one.values.push_back(setting_word(value));
    places_.add(fmt::format("{}={}", one.row->name, one.values.back()), value.span);
  }

  void read_range(const YamlValue& value, Swept& one) {
    one.from = parse_number(value.find("from")->text).value_or(0.0);
    one.to = parse_number(value.find("to")->text).value_or(0.0);
    const YamlValue* logarithmic = value.find("logarithmic");
    one.logarithmic = logarithmic != nullptr && logarithmic->text == "true";
    const YamlValue* count = value.find("count");
    if (one.from >= one.to) {
      diagnostics_.error("E0204", value.find("to")->span,
                         fmt::format("the range ends at {} and begins at {}", one.to, one.from));
    } else if (one.logarithmic && one.from <= 0.0) {
      diagnostics_.error("E0204", value.find("from")->span, "a logarithmic range begins above 0");
    } else if (is_random_ && count != nullptr) {
      auto& problem =
          diagnostics_.error("E0204", count->span, "with `random` any value of a range is sampled");
      problem.help = "leave `count` out, or write a list of values";
    } else if (!is_random_ && count == nullptr) {
      auto& problem = diagnostics_.error("E0202", value.span, "missing key `count` in a range");
      problem.help = "say how many values, or sample some: `random: 20` next to `settings:`";
    } else if (count != nullptr) {
      const std::int64_t points = parse_int(count->text).value_or(2);
      for (std::int64_t i = 0; i < points; ++i)
        one.values.push_back(at(one, static_cast<double>(i) / static_cast<double>(points - 1)));
    }
  }

  /// The value at a share of the range: four digits, whole where it has to be.
  static std::string at(const Swept& one, double share) {
    if (share <= 0.0) return fmt::format("{}", one.from);
    if (share >= 1.0) return fmt::format("{}", one.to);
    const double exact = one.logarithmic ? one.from * std::pow(one.to / one.from, share)
                                         : one.from + share * (one.to - one.from);
    const std::string text = one.row->kind == SettingKind::whole ? fmt::format("{:.0f}", exact)
                                                                 : fmt::format("{:.4g}", exact);
    // Rounding may leave the range.
    const double rounded = parse_number(text).value_or(exact);
    return rounded < one.from || rounded > one.to ? fmt::format("{}", exact) : text;
  }

  std::vector<std::string> combined() {
    std::size_t count = 1;
    for (const Swept& one : swept_) {
      count *= one.values.size();
      if (count <= kMostCases) continue;
      auto& problem = diagnostics_.error("E0204", yaml_.find("settings")->span,
                                         fmt::format("more than {} combinations", kMostCases));
      problem.help = "sample some of them: `random: 20` next to `settings:`";
      return {};
    }
    std::vector<std::string> all;
    for (std::size_t i = 0; i < count; ++i) {
      std::size_t left = i, block = count;
      std::string words;
      for (const Swept& one : swept_) {
        block /= one.values.size();
        add(words, one, one.values[left / block]);
        left %= block;
      }
      add(all, words);
    }
    return all;
  }

  std::vector<std::string> sampled() {
    const auto count = parse_int(yaml_.find("random")->text).value_or(1);
    const YamlValue* const seed = yaml_.find("seed");
    const auto start =
        static_cast<std::uint64_t>(seed == nullptr ? 1 : parse_int(seed->text).value_or(1));
    std::vector<std::string> all;
    for (std::int64_t k = 0; k < count; ++k) {
      std::string words;
      for (const Swept& one : swept_) {
        const double share = share_of(one, start, k);
        const auto last = static_cast<double>(one.values.size()) - 1.0;
        const double place = std::floor(share * static_cast<double>(one.values.size()));
        add(words, one,
            one.values.empty() ? at(one, share)
                               : one.values[static_cast<std::size_t>(std::min(place, last))]);
      }
      add(all, words);
    }
    return all;
  }

  /// From 0 to 1: a setting's samples do not depend on the others, and are the same everywhere,
  /// which the distributions of <random> are not.
  static double share_of(const Swept& one, std::uint64_t seed, std::int64_t k) {
    std::vector<std::uint64_t> words(one.row->name, one.row->name + std::strlen(one.row->name));
    words.push_back(static_cast<std::uint64_t>(k));
    words.push_back(seed);
    words.push_back(seed >> 32U);
    std::seed_seq mixed(words.begin(), words.end());
    std::mt19937_64 random(mixed);
    return std::ldexp(static_cast<double>(random() >> 11U), -53);
  }

  static void add(std::string& words, const Swept& one, const std::string& value) {
    words += fmt::format("{}{}={}", words.empty() ? "" : " ", one.row->name, value);
  }

  /// Skips what is already there, which would be trained twice.
  static void add(std::vector<std::string>& all, std::string& words) {
    if (!ranges::contains(all, words)) all.push_back(std::move(words));
  }

  const YamlValue& yaml_;
  Diagnostics& diagnostics_;
  SettingPlaces& places_;
  const bool is_random_;
  std::vector<Swept> swept_;
};

}  // namespace

std::optional<std::vector<std::string>> read_train_sweep(const std::string& path,
                                                         SourceMap& sources,
                                                         Diagnostics& diagnostics,
                                                         SettingPlaces& places) {
  const YamlValue yaml = read_yaml_file(path, sources, diagnostics);
  if (diagnostics.has_errors() || !check(yaml, train_sweep_format(), diagnostics))
    return std::nullopt;
  std::vector<std::string> words;
  for (std::string& one : Reader(yaml, diagnostics, places).cases()) {
    words.emplace_back("--case");
    words.push_back(std::move(one));
  }
  if (diagnostics.has_errors()) return std::nullopt;
  if (const YamlValue* seeds = yaml.find("seeds")) {
    words.emplace_back("--seeds");
    words.push_back(seeds->text);
  }
  return words;
}

std::string train_sweep_schema() {
  return schema_text(schema_of(train_sweep_format()), "eagerx-gen train sweep",
                     "eagerx-gen/train-sweep.schema.json");
}

}  // namespace eagerx::gen
