#include "generator/tools/monitor/recorded_file.hpp"

#include <fmt/format.h>

#include <chrono>
#include <eagerx/trace_text.hpp>
#include <runtime/host/base/files.hpp>
#include <runtime/host/base/text_file.hpp>
#include <runtime/host/trace/mcap.hpp>
#include <utility>

namespace eagerx::gen {
namespace {

/// Unlike generated files, it is not written under a temporary name first: it is read while it
/// grows.
class GrowingFile : public publish::PublishSink {
 public:
  explicit GrowingFile(std::string path) : path_(std::move(path)) {}

  std::string open() override {
    if (!file_.open(path_ == "-" ? "./-" : path_)) return problem();
    if (!file_.reserve())
      return fmt::format("error: another program writes into `{}`\nhelp: give each its own file",
                         path_);
    return {};
  }
  std::string close() override { return file_.close() ? "" : problem(); }
  void idle() override {
    using namespace std::chrono_literals;
    const auto now = std::chrono::steady_clock::now();
    if (now - flushed_ < 1s) return;
    flushed_ = now;
    end_part();
    file_.hand_on(true);
  }
  [[nodiscard]] const char* unit() const override { return "messages"; }

 protected:
  /// The part is complete.
  virtual void end_part() {}
  void write(const std::string& bytes) {
    if (bytes.empty() || !file_.is_open()) return;
    file_.text(bytes);
    if (file_.failed()) ++dropped_;
  }

 private:
  [[nodiscard]] std::string problem() const {
    return fmt::format("error: cannot write `{}`: {}", path_,
                       host::problem_of_writing(file_.error()));
  }

  const std::string path_;
  host::TextFile file_;
  std::chrono::steady_clock::time_point flushed_ = std::chrono::steady_clock::now();
};

class RecordedMcap final : public GrowingFile {
 public:
  RecordedMcap(const std::string& path, const publish::PublishedChannels& channels)
      : GrowingFile(path), mcap_(channels) {}

  void message(const publish::PublishedMessage& message) override {
    mcap_.add(message.channel, message.episode, message.seq, message.time_ns, message.values);
    ++sent_;
    write(mcap_.take());
  }
  void step(const publish::PublishedStep& /*step*/) override {}
  std::string close() override {
    mcap_.finish();
    write(mcap_.take());
    return GrowingFile::close();
  }

 private:
  void end_part() override {
    mcap_.end_chunk();
    write(mcap_.take());
  }

  trace_log::McapFile mcap_;
};

/// The sink of TraceText.
struct TraceWriter {
  std::string text_so_far;
  void text(std::string_view text) { text_so_far += text; }
  template <class T>
  void number(T number) {
    text_so_far += fmt::format("{}", number);
  }
};

class RecordedTrace final : public GrowingFile {
 public:
  RecordedTrace(const std::string& path, const StreamFacts& facts,
                const publish::PublishedChannels& channels)
      : GrowingFile(path), facts_(facts), channels_(channels) {}

  std::string open() override {
    std::string problem = GrowingFile::open();
    if (problem.empty()) write_head();
    return problem;
  }
  void message(const publish::PublishedMessage& message) override {
    const trace_log::RecordedChannel& channel = channels_[message.channel];
    std::string line = fmt::format("{},{},{}", message.episode, channel.name, message.seq);
    for (std::uint64_t i = 0; i < channel.size; ++i)
      line += "," + trace_log::text_of(channel.dtype, message.values[i]);
    write(line + "\n");
    ++sent_;
  }
  void step(const publish::PublishedStep& /*step*/) override {}

 private:
  void write_head() {
    std::vector<eagerx::Channel> channels;
    std::vector<std::string> dtypes;
    for (const auto& each : channels_) dtypes.emplace_back(trace_log::name_of(each.dtype));
    for (std::size_t i = 0; i < channels_.size(); ++i) {
      const auto& each = channels_[i];
      channels.push_back({each.name.c_str(), dtypes[i].c_str(), each.size, each.rate_num,
                          each.rate_den, Publisher::node});
    }
    // The environment is the first of them, if it has an action.
    std::uint64_t num = channels_.front().rate_num, den = channels_.front().rate_den;
    for (const auto& each : channels_) {
      if (each.name.starts_with("environment/")) num = each.rate_num, den = each.rate_den;
    }
    TraceWriter writer;
    TraceText<TraceWriter>::head(
        writer, {facts_.graph, facts_.engine, num, den, channels.data(), channels.size()},
        facts_.seed, facts_.environment, facts_.agent, false);
    write(writer.text_so_far);
  }

  const StreamFacts& facts_;
  const publish::PublishedChannels& channels_;
};

}  // namespace

std::unique_ptr<publish::PublishSink> mcap_file(const std::string& path,
                                                const publish::PublishedChannels& channels) {
  return std::make_unique<RecordedMcap>(path, channels);
}
std::unique_ptr<publish::PublishSink> trace_file(const std::string& path, const StreamFacts& facts,
                                                 const publish::PublishedChannels& channels) {
  return std::make_unique<RecordedTrace>(path, facts, channels);
}

}  // namespace eagerx::gen
