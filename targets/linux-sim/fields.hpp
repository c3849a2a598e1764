// Actions, observations and states of a graph, as its program lists them.
#pragma once

#include <cstddef>
#include <cstring>
#include <memory>
#include <string>
#include <targets/linux-sim/graph_program.hpp>
#include <vector>

namespace eagerx::linux_sim {

class Fields final : public FieldListener {
 public:
  explicit Fields(const GraphProgram& program) { program.list_fields(*this); }
  Fields(const Fields&) = delete;
  Fields& operator=(const Fields&) = delete;

  struct Outcome {
    std::string name;
    bool is_flag;
  };
  std::vector<Field> actions, observations, states, ranges;
  std::vector<Outcome> outcomes;

  void action(const Field& field) override { add(field, actions); }
  void observation(const Field& field) override { add(field, observations); }
  void state(const Field& field) override { add(field, states); }
  void range(const Field& field) override { add(field, ranges); }
  void outcome(const char* name, bool is_flag) override { outcomes.push_back({name, is_flag}); }

 private:
  using Place = std::unique_ptr<std::max_align_t[]>;

  const void* kept(const void* bounds, std::size_t bytes) {
    if (bounds == nullptr) return nullptr;
    bounds_.push_back(std::make_unique<std::max_align_t[]>(bytes / sizeof(std::max_align_t) + 1));
    std::memcpy(bounds_.back().get(), bounds, bytes);
    return bounds_.back().get();
  }
  void add(Field field, std::vector<Field>& fields) {
    field.low = kept(field.low, field.type.bytes);
    field.high = kept(field.high, field.type.bytes);
    fields.push_back(field);
  }

  std::vector<Place> bounds_;
};

/// Memory for messages of fields, `most` of each: [fields][most]. Zero bytes at first.
class MessageRows {
 public:
  explicit MessageRows(const std::vector<Field>& fields) {
    for (const Field& field : fields) {
      const std::size_t bytes = field.type.bytes * field.most;
      places_.push_back(std::make_unique<std::max_align_t[]>(bytes / sizeof(std::max_align_t) + 1));
      messages_.push_back(places_.back().get());
    }
  }
  void* const* data() const { return messages_.data(); }
  void* operator[](std::size_t field) const { return messages_[field]; }

 private:
  std::vector<std::unique_ptr<std::max_align_t[]>> places_;
  std::vector<void*> messages_;
};

/// Memory for a StateRow.
class StateMemory {
 public:
  explicit StateMemory(const std::vector<Field>& states)
      : messages_(states), has_value_(std::make_unique<bool[]>(states.size() + 1)) {}
  StateRow row() const { return {messages_.data(), has_value_.get()}; }

 private:
  MessageRows messages_;
  std::unique_ptr<bool[]> has_value_;
};

}  // namespace eagerx::linux_sim
