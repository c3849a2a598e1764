#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <runtime/host/base/json.hpp>
#include <runtime/host/base/number.hpp>
#include <string_view>
#include <targets/common/from_number.hpp>
#include <targets/linux-sim/describe.hpp>
#include <targets/linux-sim/elements.hpp>
#include <targets/linux-sim/external/external_rows.hpp>
#include <type_traits>

namespace eagerx::linux_sim {
namespace {

std::size_t numbers_of(const Field& field) {
  return field.type.size * field.most;
}

template <class T>
T state_from_row(float x) {
  if constexpr (std::is_same_v<T, double>) return host::same_decimal(x);
  return target::from_number<T>(x);
}

void write_bounds(host::Json& json, const Field& field, const void* bounds) {
  json.begin_list();
  for (std::size_t i = 0; i < numbers_of(field); ++i) {
    const std::size_t element = i % field.type.size;
    if (bounds == nullptr) {
      json.null();
    } else if (const double bound = number_of(field.type.scalar, bounds, element);
               field.type.scalar == Scalar::f32) {
      json.number(static_cast<float>(bound));
    } else {
      json.number(bound);
    }
  }
  json.end_list();
}

void write_field(host::Json& json, const Field& field, std::size_t first) {
  json.begin_object().key("name").text(field.name).key("shape").begin_list();
  if (field.most > 1) json.whole(field.most);
  for (std::size_t i = 0; i < field.type.dimensions; ++i) json.whole(field.type.shape[i]);
  json.end_list().key("dtype").text(dtype_name(field.type.scalar));
  json.key("window").whole(field.most);
  write_bounds(json.key("low"), field, field.low);
  write_bounds(json.key("high"), field, field.high);
  json.key("first").whole(first).end_object();
}

}  // namespace

ExternalColumns::ExternalColumns(const std::vector<Field>& fields)
    : first_(fields.size()), order_(fields.size()) {
  std::iota(order_.begin(), order_.end(), std::size_t{0});
  std::ranges::sort(order_, {}, [&](std::size_t i) { return std::string_view(fields[i].name); });
  for (const std::size_t field : order_) {
    first_[field] = numbers_;
    numbers_ += numbers_of(fields[field]);
  }
}

ExternalRows::ExternalRows(const Fields& fields)
    : fields_(fields),
      actions_(fields.actions),
      observations_(fields.observations),
      states_(fields.states) {}

void ExternalRows::read_action(const float* row, void* action) const {
  for (std::size_t f = 0; f < fields_.actions.size(); ++f) {
    const Field& field = fields_.actions[f];
    const float* const from = row + actions_.first(f);
    with_elements(field.type.scalar, static_cast<std::byte*>(action) + field.offset,
                  [&](auto* elements) {
                    using T = std::remove_cvref_t<decltype(*elements)>;
                    for (std::size_t i = 0; i < field.type.size; ++i)
                      elements[i] = target::from_number<T>(from[i]);
                  });
  }
}

void ExternalRows::write_action(const void* action, float* row) const {
  for (std::size_t f = 0; f < fields_.actions.size(); ++f) {
    const Field& field = fields_.actions[f];
    float* const to = row + actions_.first(f);
    with_elements(field.type.scalar, static_cast<const std::byte*>(action) + field.offset,
                  [&](const auto* elements) {
                    for (std::size_t i = 0; i < field.type.size; ++i)
                      to[i] = static_cast<float>(elements[i]);
                  });
  }
}

void ExternalRows::write_observation(ObservationRow observation, float* row) const {
  for (std::size_t f = 0; f < fields_.observations.size(); ++f) {
    const Field& field = fields_.observations[f];
    float* const to = row + observations_.first(f);
    const std::size_t received = observation.sizes[f] * field.type.size;
    const void* const messages = observation.messages[f];
    with_elements(field.type.scalar, messages, [&](const auto* elements) {
      using T = std::remove_cvref_t<decltype(*elements)>;
      for (std::size_t i = 0; i < received; ++i) to[i] = static_cast<float>(elements[i]);
      std::fill(to + received, to + numbers_of(field),
                static_cast<float>(std::numeric_limits<T>::quiet_NaN()));
    });
  }
}

std::string ExternalRows::problem_of_states(const float* row, const bool* sampled) const {
  for (std::size_t f = 0; f < fields_.states.size(); ++f) {
    const Field& field = fields_.states[f];
    const float* const from = row + states_.first(f);
    std::size_t missing = 0;
    for (std::size_t i = 0; i < field.type.size; ++i) {
      missing += std::isnan(from[i]) ? 1 : 0;
      const auto bound = [&](const void* bounds) {
        return static_cast<float>(number_of(field.type.scalar, bounds, i));
      };
      if (field.low != nullptr && (from[i] < bound(field.low) || from[i] > bound(field.high)))
        return "`" + std::string(field.name) + "` is out of its space: element " +
               std::to_string(i) + " is " + host::number_text(from[i]);
    }
    if ((sampled == nullptr || !sampled[f]) && missing != 0 && missing != field.type.size)
      return "`" + std::string(field.name) + "` is not sampled: set all of its elements, or none";
  }
  return {};
}

std::string ExternalRows::problem_of_parameters(const float* row) const {
  std::string problem = problem_of_states(row, nullptr);
  for (std::size_t f = 0; f < fields_.states.size() && problem.empty(); ++f) {
    const Field& field = fields_.states[f];
    const float* const from = row + states_.first(f);
    const bool given =
        std::any_of(from, from + field.type.size, [](float x) { return !std::isnan(x); });
    if (given && !field.tunable)
      problem =
          "`" + std::string(field.name) + "` can be set at a reset, not while an episode runs";
  }
  return problem;
}

void ExternalRows::read_states(const float* row, StateRow states) const {
  for (std::size_t f = 0; f < fields_.states.size(); ++f) {
    const Field& field = fields_.states[f];
    const float* const from = row + states_.first(f);
    with_elements(field.type.scalar, states.messages[f], [&](auto* elements) {
      using T = std::remove_cvref_t<decltype(*elements)>;
      for (std::size_t i = 0; i < field.type.size; ++i) {
        if (std::isnan(from[i])) continue;
        elements[i] = state_from_row<T>(from[i]);
        states.has_value[f] = true;
      }
    });
  }
}

void ExternalRows::describe(host::Json& json, const std::vector<Field>& fields,
                            const ExternalColumns& columns) {
  json.begin_list();
  for (const std::size_t f : columns.order()) write_field(json, fields[f], columns.first(f));
  json.end_list();
}

}  // namespace eagerx::linux_sim
