#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <runtime/host/base/json.hpp>
#include <runtime/host/base/number.hpp>
#include <string>
#include <targets/environments/base/problem.hpp>
#include <targets/environments/base/state_rows.hpp>
#include <utility>

namespace eagerx::environments {
namespace {

bool is_meant(const std::uint8_t* mask, std::uint32_t k) {
  return mask == nullptr || mask[k] != 0;
}
std::string quoted(const StateField& field) {
  return "`" + std::string(field.name) + "`";
}
std::size_t count_given(const float* from, std::size_t size) {
  return size - static_cast<std::size_t>(
                    std::count_if(from, from + size, [](float x) { return std::isnan(x); }));
}

}  // namespace

void StateRows::add(StateField field) {
  columns.add(field.name, field.low.size());
  fields_.push_back(std::move(field));
}

void StateRows::check(std::uint32_t environments, const std::uint8_t* mask,
                      const float* rows) const {
  check_each(environments, mask, rows, &StateRows::problem_of);
}
void StateRows::check_tuning(std::uint32_t environments, const std::uint8_t* mask,
                             const float* rows) const {
  check_each(environments, mask, rows, &StateRows::problem_of_tuning);
}
void StateRows::check_each(std::uint32_t environments, const std::uint8_t* mask, const float* rows,
                           ProblemOf what_is_wrong) const {
  for (std::uint32_t k = 0; k < environments; ++k) {
    if (!is_meant(mask, k)) continue;
    const std::string problem = (this->*what_is_wrong)(rows + k * columns.numbers());
    if (!problem.empty()) refuse(problem + " (environment " + std::to_string(k) + ")");
  }
}

std::string StateRows::problem_of(const float* row) const {
  std::string problem;
  for (std::size_t f = 0; f < fields_.size(); ++f) {
    const StateField& field = fields_[f];
    const std::size_t size = field.low.size();
    const float* const from = row + columns.first(f);
    for (std::size_t i = 0; i < size; ++i) {
      if (from[i] < field.low[i] || from[i] > field.high[i]) {
        problem = quoted(field) + " is out of its space: element " + std::to_string(i) + " is " +
                  host::number_text(from[i]);
      }
    }
    const std::size_t given = count_given(from, size);
    if (!field.sampled && given != 0 && given != size)
      problem = quoted(field) + " is not sampled: set all of its elements, or none";
  }
  return problem;
}

std::string StateRows::problem_of_tuning(const float* row) const {
  std::string problem = problem_of(row);
  for (std::size_t f = 0; f < fields_.size() && problem.empty(); ++f) {
    const StateField& field = fields_[f];
    const std::size_t given = count_given(row + columns.first(f), field.low.size());
    if (given == 0) continue;
    if (!field.tunable) {
      std::string list;
      for (const StateField& each : fields_)
        if (each.tunable) list += (list.empty() ? "" : ", ") + std::string(each.name);
      problem = quoted(field) + " can be set at a reset, not while an episode runs; what can: " +
                (list.empty() ? "nothing of this graph" : list);
    } else if (given != field.low.size()) {
      problem = quoted(field) + ": set all of its elements, or none";
    }
  }
  return problem;
}

std::string StateRows::describe_tunable() const {
  host::Json json;
  json.begin_list();
  for (const StateField& field : fields_)
    if (field.tunable) json.text(field.name);
  return json.end_list().str();
}

void SetRows::set(std::uint32_t environments, const std::uint8_t* mask, const float* rows) {
  states_.check(environments, mask, rows);
  const std::size_t numbers = states_.columns.numbers();
  if (next_.empty()) {
    now_.resize(environments * numbers, std::numeric_limits<float>::quiet_NaN());
    next_ = now_;
  }
  for (std::uint32_t k = 0; k < environments; ++k) {
    if (is_meant(mask, k)) std::copy_n(rows + k * numbers, numbers, next_.data() + k * numbers);
  }
}

void SetRows::take_next(std::uint32_t k) {
  const std::size_t numbers = states_.columns.numbers();
  std::copy_n(next_.data() + k * numbers, numbers, now_.data() + k * numbers);
  std::fill_n(next_.data() + k * numbers, numbers, std::numeric_limits<float>::quiet_NaN());
}

}  // namespace eagerx::environments
