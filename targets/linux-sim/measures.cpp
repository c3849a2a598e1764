#include <algorithm>
#include <cmath>
#include <limits>
#include <runtime/host/base/number.hpp>
#include <targets/linux-sim/channel_names.hpp>
#include <targets/linux-sim/describe.hpp>
#include <targets/linux-sim/elements.hpp>
#include <targets/linux-sim/measures.hpp>
#include <targets/linux-sim/say.hpp>

namespace eagerx::linux_sim {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// Six digits are enough for people.
std::string shown(double value) {
  constexpr double kDigits = 1e6;
  if (!std::isfinite(value) || value == 0.0) return host::number_text(value);
  const double scale = kDigits / std::pow(10.0, std::floor(std::log10(std::fabs(value))) + 1.0);
  return host::number_text(static_cast<float>(std::round(value * scale) / scale));
}

/// With what is near them when they are mistyped.
std::vector<host::Named> names_of(const std::vector<Readable>& readables) {
  std::vector<host::Named> known;
  for (const Readable& each : readables) {
    known.push_back({each.name, each.name});
    for (const std::string& other : each.also) {
      known.push_back({other, each.name});
      known.push_back({other.substr(0, other.rfind('/')), each.name, false});
    }
  }
  for (const char* word : {"time", "pi"}) known.push_back({word, word});
  return known;
}

}  // namespace

void Statistic::add(double value, std::uint64_t episode) {
  ++count_;
  const double before = value - mean_;
  mean_ += before / static_cast<double>(count_);
  squares_ += before * (value - mean_);
  if (count_ == 1 || value < least_) {
    least_ = value;
    least_episode_ = episode;
  }
  if (count_ == 1 || value > most_) {
    most_ = value;
    most_episode_ = episode;
  }
}

std::string Statistic::mean_text(std::string_view unit) const {
  const double deviation = count_ > 1 ? std::sqrt(squares_ / static_cast<double>(count_ - 1)) : 0.0;
  const std::string of_unit(unit);
  return "mean " + shown(mean_) + of_unit + ", deviation " + shown(deviation) + of_unit;
}

std::string Statistic::text(std::string_view unit) const {
  const auto of = [&](double value, std::uint64_t episode) {
    return shown(value) + std::string(unit) + " (episode " + std::to_string(episode) + ")";
  };
  return mean_text(unit) + ", least " + of(least_, least_episode_) + ", most " +
         of(most_, most_episode_);
}

std::optional<std::size_t> Measures::place_of(const Variable& variable) {
  for (std::size_t i = 0; i < variables_used_; ++i) {
    if (variables_[i] == variable) return i;
  }
  if (variables_used_ == kMostVariables) return std::nullopt;
  variables_[variables_used_] = variable;
  return variables_used_++;
}

std::string Measures::read(const char* option, const std::string& written, expression::Type type,
                           const std::vector<Readable>& readables, Formula& formula) {
  std::vector<expression::Variable> names;
  names.reserve(readables.size());
  const std::vector<host::Named> known = names_of(readables);
  const auto meant = [&](const std::string& name) {
    const std::string* const found = host::name_meant(name, known);
    if (found != nullptr) say_other_spelling(name, *found);
    return found == nullptr ? std::string() : *found;
  };
  const auto suggest = [&](const std::string& name) { return host::suggestion(name, known); };
  for (const Readable& each : readables) names.push_back({each.name, false, {each.size}});
  const auto place_of = [&](const expression::Read& read) {
    Variable variable;
    if (read.variable != expression::Read::kTime) {
      const Readable& from = readables[read.variable];
      variable = {from.kind, from.number, static_cast<std::size_t>(read.element)};
      reads_messages_ = reads_messages_ || from.kind == Variable::Kind::message;
    }
    if (read.is_before) variable.now = this->place_of(variable);
    return read.is_before && !variable.now ? std::nullopt : this->place_of(variable);
  };
  formula.text = written;
  expression::Text text(formula.text);
  const auto typed =
      expression::read_typed(text, {names, expression::NameForm::port, suggest, meant}, type);
  const std::string problem = "error: `" + std::string(option) + " \"" + written + "\"`, ";
  if (typed) {
    const std::string what = formula.calculation.prepare(*typed, place_of);
    return what.empty() ? what : problem + what;
  }
  const auto& [place, message, help, mistyped] = *text.problem();
  return problem + "column " + std::to_string(place + 1) + ": " + message +
         (help.empty() ? "" : "\nhelp: " + help);
}

std::string Measures::prepare(const std::string& until, const std::vector<std::string>& measures,
                              bool summary, const std::vector<Readable>& readables) {
  summary_ = summary;
  has_until_ = !until.empty();
  std::string problem;
  if (has_until_) problem = read("--until", until, expression::Type::condition, readables, until_);
  for (const std::string& text : measures) {
    if (!problem.empty()) break;
    problem = read("--measure", text, expression::Type::number, readables,
                   quantities_.emplace_back().formula);
  }
  return problem;
}

void Measures::set_message(Variable::Kind kind, std::uint32_t number, MessageView message) {
  for (std::size_t i = 0; i < variables_used_; ++i) {
    const Variable& variable = variables_[i];
    if (variable.kind != kind || variable.number != number || variable.now) continue;
    values_[i] = number_of(message.scalar, message.data, variable.element);
  }
}

void Measures::begin_episode() {
  ++episodes_;
  is_over_ = false;
  for (std::size_t i = 0; i < variables_used_; ++i) {
    // A state that nothing set keeps its value; of messages there is none yet.
    if (variables_[i].kind != Variable::Kind::state || episodes_ == 1) values_[i] = kNaN;
  }
  for (Quantity& quantity : quantities_) {
    quantity.sum = 0.0;
    quantity.samples = 0;
    quantity.most = -std::numeric_limits<double>::infinity();
  }
}

void Measures::keep_before() {
  for (std::size_t i = 0; i < variables_used_; ++i) {
    if (variables_[i].now) values_[i] = values_[*variables_[i].now];
  }
}

void Measures::step(std::uint64_t step, double time_s) {
  set(Variable::Kind::time, 0, 0, time_s);
  if (step == 0) keep_before();
  last_step_ = static_cast<double>(step);
  last_time_s_ = time_s;
  has_begun_ = true;
  for (Quantity& quantity : quantities_) {
    const double value = quantity.formula.calculation.value(values_.data());
    if (std::isnan(value)) continue;  // before the first message of something
    ++quantity.samples;
    quantity.sum += value;
    quantity.most = std::max(quantity.most, value);
  }
  is_over_ = has_until_ && until_.calculation.value(values_.data()) != 0.0;
  keep_before();
}

void Measures::end_episode() {
  if (!has_begun_) return;
  has_begun_ = false;
  lengths_.add(last_step_, episodes_);
  if (is_over_) times_.add(last_time_s_, episodes_);
  for (Quantity& quantity : quantities_) {
    if (quantity.samples == 0) continue;
    quantity.means.add(quantity.sum / static_cast<double>(quantity.samples), episodes_);
    quantity.worst.add(quantity.most, episodes_);
  }
}

void Measures::describe(Summary& summary) const {
  const auto add = [&](const std::string& name, const std::string& value) {
    summary.more.emplace_back(name, value);
  };
  if (has_until_) {
    add("until `" + until_.text + "`:",
        std::to_string(times_.count()) + " of " + std::to_string(lengths_.count()) + " episodes");
    if (summary_ && times_.count() > 0) add("time until then:", times_.text(" s"));
  }
  for (const Quantity& quantity : quantities_) {
    if (quantity.means.count() == 0) continue;
    add("measure `" + quantity.formula.text + "`:",
        quantity.means.mean_text("") + ", worst " + shown(quantity.worst.most()) + " (episode " +
            std::to_string(quantity.worst.most_episode()) + ")");
  }
  if (summary_ && lengths_.count() > 0) add("steps of an episode:", lengths_.text(""));
}

std::vector<Readable> readables_of(const GraphFacts& facts, const std::vector<Field>& states) {
  std::vector<Readable> result;
  for (std::uint32_t i = 0; i < facts.channel_count; ++i) {
    std::vector<std::string> also = aliases_of(facts, i);
    also.emplace_back(facts.channels[i].name);
    for (const std::string& name : ports_of(facts.channels[i]))
      result.push_back({name, Variable::Kind::message, i, facts.channels[i].size, also});
  }
  for (std::uint32_t i = 0; i < states.size(); ++i)
    result.push_back({states[i].name, Variable::Kind::state, i, states[i].type.size});
  return result;
}

}  // namespace eagerx::linux_sim
