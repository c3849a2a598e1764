// Helpers for loops over a source. Inside monitor/ only.
#pragma once

#include <cstdint>
#include <string>

#include "generator/tools/monitor/model.hpp"
#include "generator/tools/monitor/recording.hpp"

namespace eagerx::gen {

/// Completes the recording, and restores the terminal.
void end_at_signals();
[[nodiscard]] bool is_interrupted();

/// Of a steady clock.
[[nodiscard]] std::int64_t steady_ns();

/// The reason why the stream was rejected, and a fix.
[[nodiscard]] std::string refusal_text(const Model& model);

/// Shown messages are also recorded, as soon as the stream is accepted.
class Both : public StreamListener {
 public:
  Both(Model& model, Recording& recording) : model_(model), recording_(recording) {}
  bool begin(const StreamFacts& facts) override {
    return model_.begin(facts) && recording_.begin(facts);
  }
  void message(const StreamMessage& message) override {
    model_.message(message);
    recording_.message(message);
  }
  void step(const StreamStep& step) override {
    model_.step(step);
    recording_.step(step);
  }
  void fault(StreamFault fault, std::uint64_t count) override { model_.fault(fault, count); }
  void scene(const StreamScene& scene) override { recording_.scene(scene); }
  [[nodiscard]] bool wants_scenes() const override { return recording_.wants_scenes(); }

 private:
  Model& model_;
  Recording& recording_;
};

}  // namespace eagerx::gen
