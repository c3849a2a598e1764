#include <pthread.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <eagerx/trace.hpp>
#include <runtime/host/base/background.hpp>
#include <runtime/host/base/nearest.hpp>
#include <runtime/host/dds/dds_sink.hpp>
#include <runtime/host/foxglove/server.hpp>
#include <runtime/host/publish/datagrams.hpp>
#include <targets/linux-sim/dds/graph_of.hpp>
#include <targets/linux-sim/elements.hpp>
#include <targets/linux-sim/publish/publishing.hpp>
#include <targets/linux-sim/publish/recording.hpp>
#include <targets/linux-sim/say.hpp>

namespace eagerx::linux_sim {
namespace {

constexpr std::size_t kWord = sizeof(std::uint64_t);

PublishedChannels channels_of(const GraphFacts& facts) {
  PublishedChannels channels;
  for (std::size_t c = 0; c < facts.channel_count; ++c) {
    const Channel& channel = facts.channels[c];
    channels.push_back({channel.name, *trace_log::dtype_of(channel.dtype), channel.size,
                        channel.rate_num, channel.rate_den});
  }
  return channels;
}

Scalar scalar_of_dtype(trace_log::Dtype dtype) {
  switch (dtype) {
    case trace_log::Dtype::float64:
      return Scalar::f64;
    case trace_log::Dtype::int8:
      return Scalar::i8;
    case trace_log::Dtype::int16:
      return Scalar::i16;
    case trace_log::Dtype::int32:
      return Scalar::i32;
    case trace_log::Dtype::int64:
      return Scalar::i64;
    case trace_log::Dtype::uint8:
      return Scalar::u8;
    case trace_log::Dtype::uint16:
      return Scalar::u16;
    case trace_log::Dtype::uint32:
      return Scalar::u32;
    case trace_log::Dtype::uint64:
      return Scalar::u64;
    case trace_log::Dtype::boolean:
      return Scalar::boolean;
    case trace_log::Dtype::float32:
      break;
  }
  return Scalar::f32;
}

/// One of this many is published, so that at most `most_hz` are published per second; 0: all.
std::uint64_t every_of(std::uint64_t num, std::uint64_t den, double most_hz) {
  if (most_hz <= 0.0) return 1;
  constexpr double kMost = 4e9;
  const double rate_hz = static_cast<double>(num) / static_cast<double>(den);
  return static_cast<std::uint64_t>(std::clamp(std::ceil(rate_hz / most_hz - 1e-9), 1.0, kMost));
}

std::string unknown_channel(const std::string& name, const PublishedChannels& channels) {
  std::vector<std::string> known;
  std::string list;
  for (const auto& channel : channels) {
    known.push_back(channel.name);
    list += (list.empty() ? "" : ", ") + channel.name;
  }
  const std::string near = host::did_you_mean(name, known);
  return "error: this program has no channel `" + name +
         "`\nhelp: " + (near.empty() ? "it has " + list : near);
}

}  // namespace

Publishing::Publishing(const Options& options, const GraphProgram& program, const Fields& fields)
    : options_(options),
      program_(program),
      fields_(fields),
      facts_(program.facts()),
      channels_(channels_of(facts_)),
      clock_(channels_) {
  for (const auto& channel : channels_) scalars_.push_back(scalar_of_dtype(channel.dtype));
}

Publishing::~Publishing() {
  ends_ = true;
  if (thread_.joinable()) thread_.join();
}

std::string Publishing::open() {
  std::string problem = choose_channels();
  if (problem.empty()) problem = open_sinks();
  if (problem.empty()) make_ring();
  return problem;
}

std::string Publishing::choose_channels() {
  wanted_.resize(channels_.size());
  std::vector<bool> chosen(channels_.size(), options_.publish_only.empty());
  for (const std::string& name : options_.publish_only) {
    const auto found = std::find_if(channels_.begin(), channels_.end(),
                                    [&](const auto& channel) { return channel.name == name; });
    if (found == channels_.end()) return unknown_channel(name, channels_);
    chosen[static_cast<std::size_t>(found - channels_.begin())] = true;
  }
  for (std::size_t c = 0; c < channels_.size(); ++c) {
    const auto& channel = channels_[c];
    const std::size_t size =
        with_scalar(scalars_[c], [](auto zero) -> std::size_t { return sizeof(zero); });
    wanted_[c].bytes = channel.size * size;
    wanted_[c].words =
        static_cast<std::uint32_t>(kHeadWords + (wanted_[c].bytes + kWord - 1) / kWord);
    if (chosen[c])
      wanted_[c].every = static_cast<std::uint32_t>(
          every_of(channel.rate_num, channel.rate_den, options_.publish_rate_hz));
  }
  step_every_ = every_of(facts_.rate_num, facts_.rate_den, options_.publish_rate_hz);
  if (facts_.is_scene)
    scene_every_ = every_of(facts_.render_num, facts_.render_den, options_.publish_rate_hz);
  return {};
}

std::string Publishing::open_sinks() {
  for (const Destination& to : options_.publish) {
    switch (to.kind) {
      case Destination::Kind::udp:
        sinks_.push_back(publish::udp_sink(to, channels_, facts_.graph_hash));
        break;
      case Destination::Kind::teleplot:
        sinks_.push_back(publish::teleplot_sink(to, channels_));
        break;
      case Destination::Kind::mcap:
        sinks_.push_back(mcap_sink(to, channels_));
        break;
      case Destination::Kind::foxglove:
        sinks_.push_back(foxglove_sink_of(to));
        break;
      case Destination::Kind::dds:
        sinks_.push_back(dds::topic_sink(to.network, to.written, channels_, graph_of(facts_),
                                         chosen_channels()));
        break;
    }
    names_.push_back(to.written);
    std::string problem = sinks_.back()->open();
    if (!problem.empty()) return problem;
    if (const std::string note = sinks_.back()->note(); !note.empty()) fail(note, 0);
  }
  return {};
}

std::unique_ptr<PublishSink> Publishing::foxglove_sink_of(const Destination& to) {
  if (facts_.is_scene) scene_rows_ = facts_.scene_rows;
  // A part samples its states itself, and does not wait.
  if (!facts_.is_split() && !remote_) remote_ = std::make_unique<Remote>(fields_);
  foxglove::Served served;
  served.graph = facts_.name;
  served.engine = facts_.engine;
  served.graph_hash = facts_.graph_hash;
  served.channels = &channels_;
  served.chosen = chosen_channels();
  served.has_scene = facts_.is_scene;
  served.is_real = program_.is_real();
  served.key_file = options_.publish_key;
  if (remote_) {
    parameters_.push_back(std::make_unique<Parameters>(fields_, *remote_, served.is_real));
    served.steering = parameters_.back().get();
  }
  return foxglove::server(to, std::move(served));
}

/// [channels] whether it is published.
std::vector<bool> Publishing::chosen_channels() const {
  std::vector<bool> chosen;
  for (const Wanted& wanted : wanted_) chosen.push_back(wanted.every != 0);
  return chosen;
}

/// As the plan wants it: the messages of half a second, and no less than some steps.
void Publishing::make_ring() {
  constexpr double kSeconds = 0.5, kLeast = 32.0 * 1024, kMost = 8.0 * 1024 * 1024;  // words
  std::size_t longest = kHeadWords;
  double words_s = static_cast<double>(kHeadWords) / facts_.period_s();
  for (std::size_t c = 0; c < channels_.size(); ++c) {
    if (wanted_[c].every == 0) continue;
    longest = std::max<std::size_t>(longest, wanted_[c].words);
    words_s += static_cast<double>(wanted_[c].words) * static_cast<double>(channels_[c].rate_num) /
               static_cast<double>(channels_[c].rate_den) / wanted_[c].every;
  }
  if (scene_rows_ > 0) {
    const std::size_t words = kSceneHeadWords + scene_rows_ * kRowWords;
    longest = std::max(longest, words);
    words_s += static_cast<double>(words) * static_cast<double>(facts_.render_num) /
               static_cast<double>(facts_.render_den) / static_cast<double>(scene_every_);
  }
  ring_ = std::make_unique<PublishRing>(
      static_cast<std::size_t>(std::clamp(words_s * kSeconds, kLeast, kMost)), longest);
  std::size_t most_values = 1;
  for (const auto& channel : channels_)
    most_values = std::max<std::size_t>(most_values, channel.size);
  values_.resize(most_values);
}

void Publishing::start() {
  thread_ = host::thread_without_signals([this] { work(); });
}

std::string Publishing::finish(Summary& summary) {
  ends_.store(true, std::memory_order_release);
  if (thread_.joinable()) thread_.join();
  std::string problem;
  for (std::size_t i = 0; i < sinks_.size(); ++i) {
    const std::string wrong = sinks_[i]->close();
    if (problem.empty()) problem = wrong;
    summary.more.emplace_back("published " + names_[i], std::to_string(sinks_[i]->sent()) + " " +
                                                            sinks_[i]->unit() + ", " +
                                                            std::to_string(sinks_[i]->dropped()) +
                                                            " dropped" + sinks_[i]->more());
  }
  const std::uint64_t lost = dropped_.load(std::memory_order_relaxed);
  if (lost > 0) summary.more.emplace_back("publishing dropped", std::to_string(lost));
  return problem;
}

/// The thread. It looks at the ring often enough for a plot that runs, and needs no wake-up.
void Publishing::work() {
  using namespace std::chrono_literals;
  // When it wakes, it takes no processor away from the thread that steps. A real-time priority that
  // the program was started with is not its own, either.
  const sched_param none{};
  pthread_setschedparam(pthread_self(), SCHED_BATCH, &none);
  while (true) {
    const bool last = ends_.load(std::memory_order_acquire);
    take_all();
    for (const auto& sink : sinks_) sink->idle();
    if (last) return;
    std::this_thread::sleep_for(2ms);
  }
}

void Publishing::take_all() {
  constexpr int kAtOnce = 4'096;  // sinks want to be idle() in between
  for (int i = 1;; ++i) {
    const std::uint64_t* const record = ring_->front();
    if (record == nullptr) return;
    ring_->pop(take(record));
    if (i % kAtOnce == 0)
      for (const auto& sink : sinks_) sink->idle();
  }
}

/// Sends a record; returns its words.
std::size_t Publishing::take(const std::uint64_t* record) {
  const auto channel = static_cast<std::uint32_t>(record[0]);
  const auto episode = static_cast<std::uint32_t>(record[0] >> kEpisodeShift);
  if (channel == kStep) return take_step(episode, record);
  if (channel == kScene) return take_scene(episode, record);
  const auto& known = channels_[channel];
  with_elements(scalars_[channel], static_cast<const void*>(record + kHeadWords),
                [&](const auto* elements) {
                  for (std::size_t i = 0; i < known.size; ++i)
                    values_[i] = canonical_bits(elements[i]);
                });
  const std::int64_t time_ns =
      clock_.in_log_ns(episode, trace_log::time_of_tick(record[1], known.rate_num, known.rate_den));
  const PublishedMessage message{channel, episode, record[1], time_ns, values_.data()};
  for (const auto& sink : sinks_) sink->message(message);
  return wanted_[channel].words;
}

std::size_t Publishing::take_step(std::uint32_t episode, const std::uint64_t* record) {
  const std::int64_t time_ns = clock_.in_log_of_other_ns(
      episode, trace_log::time_of_tick(record[1], facts_.rate_num, facts_.rate_den));
  for (const auto& sink : sinks_) sink->step({episode, record[1], time_ns});
  return kHeadWords;
}

std::size_t Publishing::take_scene(std::uint32_t episode, const std::uint64_t* record) {
  const std::int64_t time_ns = clock_.in_log_of_other_ns(
      episode, trace_log::time_of_tick(record[1], facts_.render_num, facts_.render_den));
  const std::size_t rows = record[kHeadWords];
  scene_.resize(rows * kSceneColumns);
  std::memcpy(scene_.data(), record + kSceneHeadWords, rows * kSceneColumns * sizeof(float));
  for (const auto& sink : sinks_) sink->scene({episode, time_ns, scene_.data(), rows});
  return kSceneHeadWords + rows * kRowWords;
}

void Publishing::scene(std::uint32_t episode, Seq tick, const float* scene) {
  if (scene_rows_ == 0 || tick % scene_every_ != 0) return;
  std::size_t rows = 0;
  while (rows < scene_rows_ && scene[rows * kSceneColumns] != 0.0F) ++rows;
  std::uint64_t* const at = ring_->begin(kSceneHeadWords + rows * kRowWords);
  if (at == nullptr) return drop();
  at[0] = std::uint64_t{episode} << kEpisodeShift | kScene;
  at[1] = tick;
  at[kHeadWords] = rows;
  std::memcpy(at + kSceneHeadWords, scene, rows * kSceneColumns * sizeof(float));
  ring_->commit(kSceneHeadWords + rows * kRowWords);
}

}  // namespace eagerx::linux_sim
