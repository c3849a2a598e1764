#include <eagerx/trace_text.hpp>
#include <runtime/host/base/text_file.hpp>
#include <runtime/host/identify/experiment.hpp>
#include <runtime/host/trace/replay.hpp>
#include <targets/linux-sim/elements.hpp>
#include <targets/linux-sim/graph_program.hpp>
#include <targets/linux-sim/measures.hpp>
#include <targets/linux-sim/pacer.hpp>
#include <targets/linux-sim/publish/publishing.hpp>
#include <targets/linux-sim/recorder.hpp>
#include <targets/linux-sim/scene_record.hpp>

namespace eagerx::linux_sim {
namespace {

using Text = TraceText<host::TextFile>;

}  // namespace

bool Recorder::before(std::uint32_t channel, Seq seq, MessageView message) {
  return with_elements(message.scalar, message.data, [&](auto* elements) {
    if (experiment_ != nullptr) {
      experiment_->message(channel, seq, elements, message.size);
      return false;
    }
    replay_->message(channel, episode_, seq, elements, message.size);
    return true;
  });
}

void Recorder::keep(std::uint32_t channel, Seq seq, MessageView message) {
  if (!only_publishes_) return keep_all(channel, seq, message);
  publishing_->message(channel, episode_, seq, message.data);
}

void Recorder::keep_all(std::uint32_t channel, Seq seq, MessageView message) {
  if (publishing_ != nullptr) publishing_->message(channel, episode_, seq, message.data);
  if (measures_ != nullptr) measures_->set_message(Variable::Kind::message, channel, message);
  if (file_ == nullptr) return;
  ++messages_;
  Text::begin_message(*file_, episode_, facts_->channels[channel], seq);
  if (timed_) Text::time(*file_, now_ns() - start_ns_);
  with_elements(message.scalar, message.data,
                [&](const auto* elements) { Text::values(*file_, elements, message.size); });
}

void Recorder::simulator(const char* object, Seq tick,
                         const identification::SimulatorView& simulator) {
  experiment_->simulator(object, tick, simulator);
}

bool Recorder::runs_engine() const {
  if (experiment_ != nullptr) experiment_->engine_runs();
  return replay_ == nullptr || replay_->runs_engine();
}

void Recorder::scene(std::uint64_t rate_num, std::uint64_t rate_den, Seq tick, const float* scene) {
  if (publishing_ != nullptr) publishing_->scene(episode_, tick, scene);
  if (scene_file_ != nullptr)
    scenes_->write(*scene_file_, {episode_, rate_num, rate_den, tick}, scene);
}

void Recorder::write_to(host::TextFile* file, bool timed) {
  file_ = file;
  start_ns_ = now_ns();
  timed_ = timed;
  decide();
}

void Recorder::keep_scenes(host::TextFile* file, SceneRecord* scenes) {
  scenes_ = scenes;
  scene_file_ = file;
  keeps_scenes_ = true;
}

void Recorder::decide() {
  const bool records = measures_ != nullptr || file_ != nullptr;
  keeps_ = records || publishing_ != nullptr;
  only_publishes_ = !records && publishing_ != nullptr;
}

void Recorder::publish(Publishing* publishing) {
  publishing_ = publishing;
  keeps_scenes_ = keeps_scenes_ || publishing->wants_scenes();
  decide();
}

void Recorder::measure(Measures& measures) {
  measures_ = measures.reads_messages() ? &measures : nullptr;
  decide();
}

void Recorder::write_end(std::uint64_t hash) const {
  if (file_ != nullptr) Text::end(*file_, messages_, hash);
}

}  // namespace eagerx::linux_sim
