#include <algorithm>
#include <cstring>
#include <targets/linux-sim/elements.hpp>
#include <targets/linux-sim/faults.hpp>
#include <targets/linux-sim/say.hpp>
#include <utility>

namespace eagerx::linux_sim {

AgentFaults::AgentFaults(const Fields& fields)
    : fields_(fields), seen_(fields.observations), given_(fields.actions) {
  const auto add = [&](const Field& field, bool is_action) {
    const bool is_real = field.type.scalar == Scalar::f32 || field.type.scalar == Scalar::f64;
    places_.push_back({field.name, is_action, field.most * field.type.size, is_real});
  };
  for (const Field& field : fields.observations) {
    add(field, false);
    sizes_.push_back(field.most);
  }
  for (const Field& field : fields.actions) add(field, true);
}

std::string AgentFaults::read(const std::vector<std::string>& texts) {
  for (const std::string& text : texts) {
    auto fault = target::parse_fault(text);
    if (!fault) return "error: `" + text + "` is not a fault\nhelp: write " + target::kFaultForms;
    if (!fault->begins) fault->begins = 0;
    target::FaultProblem problem;
    auto placed = target::place_fault(std::move(*fault), places_, problem);
    if (!problem.note.empty()) say_note(problem.note);
    if (!placed) return "error: " + problem.what + "\nhelp: " + problem.help;
    faults_.push_back(std::move(*placed));
  }
  return {};
}

ObservationRow AgentFaults::seen(Seq step, ObservationRow observations) {
  for (std::size_t i = 0; i < fields_.observations.size(); ++i) {
    if (is_silent(i, step)) continue;
    sizes_[i] = observations.sizes[i];
    put(i, sizes_[i] * fields_.observations[i].type.size, step, observations.messages[i]);
  }
  return {seen_.data(), sizes_.data()};
}

void AgentFaults::given(Seq step, void* action) {
  for (std::size_t i = 0; i < fields_.actions.size(); ++i) {
    const Field& field = fields_.actions[i];
    void* const message = static_cast<std::byte*>(action) + field.offset;
    put(fields_.observations.size() + i, field.type.size, step, message);
    std::memcpy(message, given_[i], field.type.bytes);
  }
}

/// Whether nothing of an observation comes, so that its window stays as long as it was.
bool AgentFaults::is_silent(std::size_t field, Seq step) const {
  return step > 0 && std::ranges::any_of(faults_, [&](const target::PlacedFault& each) {
           return each.fault.kind == target::Fault::Kind::silent &&
                  each.size == places_[field].size && each.acts(field, 0, step);
         });
}

/// The `size` numbers of `now` with their faults, as what the agent saw or gave last.
void AgentFaults::put(std::size_t field, std::size_t size, Seq step, const void* now) {
  const std::size_t observations = fields_.observations.size();
  const bool is_action = field >= observations;
  const Field& what =
      is_action ? fields_.actions[field - observations] : fields_.observations[field];
  void* const kept = is_action ? given_[field - observations] : seen_[field];
  with_elements(what.type.scalar, kept, [&](auto* elements) {
    const auto* const from = static_cast<decltype(elements)>(const_cast<void*>(now));
    for (std::size_t i = 0; i < size; ++i)
      elements[i] = target::with_faults(faults_, field, i, step, from[i], elements[i]);
  });
}

}  // namespace eagerx::linux_sim
