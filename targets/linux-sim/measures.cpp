#include <algorithm>
#include <cmath>
#include <limits>
#include <runtime/host/base/number.hpp>
#include <targets/linux-sim/describe.hpp>
#include <targets/linux-sim/elements.hpp>
#include <targets/linux-sim/measures.hpp>
#include <runtime/host/base/nearest.hpp>

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

int Measures::variable_of(const std::string& name, std::size_t index, bool indexed,
                          const std::vector<Readable>& readables, std::string& problem) {
  Variable variable;
  if (name != "time") {
    const auto found = std::find_if(readables.begin(), readables.end(),
                                    [&](const Readable& each) { return each.name == name; });
    if (found == readables.end()) {
      std::vector<std::string> names;
      names.reserve(readables.size());
      for (const Readable& each : readables) names.push_back(each.name);
      const std::string near = host::nearest_name(name, names);
      std::string list = "time";
      for (const std::string& each : names) list += ", " + each;
      problem = "there is no `" + name + "`" +
                (near.empty() ? "; there is " + list : "; did you mean `" + near + "`?");
      return -1;
    }
    if (index >= found->size || (!indexed && found->size > 1)) {
      problem = "`" + name + "` has " + std::to_string(found->size) + " elements: write `" + name +
                "[0]` to `" + name + "[" + std::to_string(found->size - 1) + "]`";
      return -1;
    }
    variable = {found->kind, found->number, index};
    reads_messages_ = reads_messages_ || found->kind == Variable::Kind::message;
  }
  for (std::size_t i = 0; i < variables_used_; ++i) {
    if (variables_[i] == variable) return static_cast<int>(i);
  }
  if (variables_used_ == kMostVariables) {
    problem = "more than " + std::to_string(kMostVariables) + " different names";
    return -1;
  }
  variables_[variables_used_] = variable;
  return static_cast<int>(variables_used_++);
}

std::string Measures::prepare(const std::string& until, const std::vector<std::string>& measures,
                              bool summary, const std::vector<Readable>& readables) {
  summary_ = summary;
  const auto lookup = [&](const std::string& name, std::size_t index, bool indexed,
                          std::string& problem) {
    return variable_of(name, index, indexed, readables, problem);
  };
  const auto read = [&](const char* option, const std::string& text, Expression& expression,
                        bool condition) -> std::string {
    const std::string problem = expression.parse(text, lookup);
    const std::string place = "error: `" + std::string(option) + " \"" + text + "\"`";
    if (!problem.empty()) return place + ", " + problem;
    if (expression.is_condition() == condition) return {};
    return condition
               ? place + " is a number\nhelp: an end is a condition, such as `" + text + " > 1`"
               : place + " is a condition\nhelp: what is measured is a number";
  };
  if (!until.empty()) {
    has_until_ = true;
    std::string problem = read("--until", until, until_, true);
    if (!problem.empty()) return problem;
  }
  for (const std::string& text : measures) {
    std::string problem = read("--measure", text, quantities_.emplace_back().expression, false);
    if (!problem.empty()) return problem;
  }
  return {};
}

void Measures::set_message(Variable::Kind kind, std::uint32_t number, MessageView message) {
  for (std::size_t i = 0; i < variables_used_; ++i) {
    const Variable& variable = variables_[i];
    if (variable.kind != kind || variable.number != number) continue;
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

void Measures::step(std::uint64_t step, double time_s) {
  set(Variable::Kind::time, 0, 0, time_s);
  last_step_ = static_cast<double>(step);
  last_time_s_ = time_s;
  has_begun_ = true;
  for (Quantity& quantity : quantities_) {
    const double value = quantity.expression.value(values_.data());
    if (std::isnan(value)) continue;  // before the first message of something
    ++quantity.samples;
    quantity.sum += value;
    quantity.most = std::max(quantity.most, value);
  }
  is_over_ = has_until_ && until_.value(values_.data()) != 0.0;
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
    add("until `" + until_.text() + "`:",
        std::to_string(times_.count()) + " of " + std::to_string(lengths_.count()) + " episodes");
    if (summary_ && times_.count() > 0) add("time until then:", times_.text(" s"));
  }
  for (const Quantity& quantity : quantities_) {
    if (quantity.means.count() == 0) continue;
    add("measure `" + quantity.expression.text() + "`:",
        quantity.means.mean_text("") + ", worst " + shown(quantity.worst.most()) + " (episode " +
            std::to_string(quantity.worst.most_episode()) + ")");
  }
  if (summary_ && lengths_.count() > 0) add("steps of an episode:", lengths_.text(""));
}

std::vector<Readable> readables_of(const GraphFacts& facts, const std::vector<Field>& states) {
  std::vector<Readable> result;
  for (std::uint32_t i = 0; i < facts.channel_count; ++i)
    result.push_back({facts.channels[i].port, Variable::Kind::message, i, facts.channels[i].size});
  for (std::uint32_t i = 0; i < states.size(); ++i)
    result.push_back({states[i].name, Variable::Kind::state, i, states[i].type.size});
  return result;
}

}  // namespace eagerx::linux_sim
