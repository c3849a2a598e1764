#include <chrono>
#include <optional>
#include <runtime/host/base/files.hpp>
#include <runtime/host/base/text_file.hpp>
#include <runtime/host/trace/mcap.hpp>
#include <targets/linux-sim/publish/recording.hpp>

namespace eagerx::linux_sim {
namespace {

class McapSink final : public PublishSink {
 public:
  McapSink(Destination to, const PublishedChannels& channels)
      : to_(std::move(to)), channels_(channels) {}

  ~McapSink() override { file_.discard(); }  // if there was no run
  McapSink(const McapSink&) = delete;
  McapSink& operator=(const McapSink&) = delete;

  std::string open() override {
    if (channels_.size() > trace_log::kMostMcapChannels)
      return "error: MCAP has at most " + std::to_string(trace_log::kMostMcapChannels) +
             " channels\nhelp: `--trace`";
    if (!file_.open(to_.file, host::Writing::direct)) return problem();
    if (!file_.reserve())
      return "error: `" + to_.file +
             "` is written by another process\nhelp: give each its own file";
    mcap_.emplace(channels_);
    return {};
  }
  void message(const PublishedMessage& message) override {
    if (!mcap_->has_messages()) begun_ = Clock::now();
    mcap_->add(message.channel, message.episode, message.seq, message.time_ns, message.values);
    ++(file_.failed() ? dropped_ : sent_);
    write();
  }
  void step(const PublishedStep& /*step*/) override {}
  void idle() override {
    using namespace std::chrono_literals;
    if (mcap_->has_messages() && Clock::now() - begun_ > 1s) mcap_->end_chunk();
    write();
  }
  std::string close() override {
    mcap_->finish();
    write();
    return file_.close() ? "" : problem();
  }
  const char* unit() const override { return "messages"; }

 private:
  using Clock = std::chrono::steady_clock;

  void write() {
    const std::string bytes = mcap_->take();
    if (bytes.empty()) return;
    file_.text(bytes);
    file_.hand_on(true);
  }
  std::string problem() const {
    return "error: cannot write `" + to_.file + "`: " + host::problem_of_writing(file_.error());
  }

  Destination to_;
  const PublishedChannels& channels_;
  std::optional<trace_log::McapFile> mcap_;
  host::TextFile file_;
  Clock::time_point begun_;
};

}  // namespace

std::unique_ptr<PublishSink> mcap_sink(const Destination& to, const PublishedChannels& channels) {
  return std::make_unique<McapSink>(to, channels);
}

}  // namespace eagerx::linux_sim
