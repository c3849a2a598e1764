#include <cstdio>
#include <eagerx/float_environment.hpp>
#include <eagerx/trace_text.hpp>
#include <optional>
#include <runtime/host/base/files.hpp>
#include <runtime/host/base/interrupt.hpp>
#include <string>
#include <string_view>
#include <targets/linux-sim/dds/agent_watch.hpp>
#include <targets/linux-sim/external/external_watch.hpp>
#include <targets/linux-sim/files.hpp>
#include <targets/linux-sim/float_environment.hpp>
#include <targets/linux-sim/publish/publish_watch.hpp>
#include <targets/linux-sim/publish/remote_watch.hpp>
#include <targets/linux-sim/say.hpp>
#include <targets/linux-sim/scene_record.hpp>
#include <targets/linux-sim/session.hpp>
#include <targets/linux-sim/split.hpp>

namespace eagerx::linux_sim {
namespace {

/// Says that `path` cannot be written and why; returns false.
bool cannot_write(const host::TextFile& file, const std::string& path) {
  const std::string name = path == "-" ? "the standard output" : "`" + path + "`";
  fail("error: cannot write " + name + ": " + host::problem_of_writing(file.error()), kBadFile);
  return false;
}
/// Written by a thread of its own: a disk that is slow for once must not make a step late.
bool open_output(host::TextFile& file, const std::string& path, host::Writing writing) {
  return path.empty() || file.open(path, writing) || cannot_write(file, path);
}
/// Two programs that write into one file would mix their lines.
bool reserve_output(host::TextFile& file, const std::string& path) {
  if (path.empty() || file.reserve()) return true;
  fail("error: another program writes into `" + path + "`\nhelp: give each its own file", kBadFile);
  return false;
}
bool close_output(host::TextFile& file, const std::string& path) {
  return path.empty() || file.close() || cannot_write(file, path);
}

/// How many steps are done when something ends a run.
std::string place_of(const Summary& summary) {
  return "note: the run ended after step " + std::to_string(summary.steps) + " of episode " +
         std::to_string(summary.episodes) + ", counted from 1; files are complete up to there";
}

constexpr const char* kNothingToShow =
    "error: this program has nothing to show\nhelp: write it into the graph, such as "
    "`render: {source: OBJECT.scene}`, and generate the program again";

/// Opens the pictures of `--render`; empty, or the problem.
std::string open_pictures(const Options& options, GraphProgram& program) {
  const GraphFacts& facts = program.facts();
  if (Pictures* const pictures = program.pictures())
    return pictures->open(
        options.rendering, facts.name,
        std::to_string(facts.render_num) + "/" + std::to_string(facts.render_den));
  return options.rendering.to.empty() ? "" : kNothingToShow;
}
/// The problem with `--trace-scenes`, or empty.
std::string problem_of_scenes(const Options& options, const GraphFacts& facts) {
  if (!options.trace_scenes || facts.is_scene) return {};
  if (facts.is_shown)
    return "error: what this program shows is pixels, not a scene\nhelp: leave out "
           "`--trace-scenes`; `--render` has the pictures";
  return kNothingToShow;
}
/// Finishes them, and tells what they were.
std::string close_pictures(Pictures* pictures, Summary& summary) {
  if (pictures == nullptr) return {};
  if (pictures->is_on()) {
    summary.more.emplace_back("pictures", std::to_string(pictures->count()));
    std::string hash = hash_line(pictures->hash());
    hash = hash.substr(hash.find("0x"), 18);
    summary.more.emplace_back("hash of the pictures", hash);
  }
  return pictures->close();
}

class Session {
 public:
  Session(const RunInputs& inputs, GraphProgram& program, RemoteAgent* agent)
      : options_(inputs.options),
        inputs_(inputs),
        program_(program),
        facts_(program.facts()),
        agent_(agent) {}

  int run() {
    const int problem = open();
    if (problem != kDone) {
      // Files of an earlier run stay until this one has started without an error.
      csv_.discard();
      trace_.discard();
      return problem;
    }
    begin();
    if (!publishing_) return run_watched<RunWatch>();
    publishing_->start();
    if (publishing_->remote() != nullptr)
      return run_watched<RemoteWatch>(*publishing_, *publishing_->remote());
    return run_watched<PublishWatch>(*publishing_);
  }

 private:
  /// By a `Watch`, or one that asks another process for actions, too.
  template <class Watch, class... More>
  int run_watched(More&... more) {
    if (agent_ != nullptr)
      return run_by<AgentWatch<Watch>>(*agent_, program_, inputs_, csv_, trace_, more...);
    if (external_)
      return run_by<ExternalWatch<Watch>>(*external_, program_, inputs_, csv_, trace_, more...);
    return run_by<Watch>(program_, inputs_, csv_, trace_, more...);
  }
  template <class Watch, class... Arguments>
  int run_by(Arguments&... arguments) {
    Watch watch(arguments...);
    step_all(watch);
    return end(watch);
  }

  int open() {
    const bool in_real_time = options_.real_time_factor > 0.0 || program_.is_real();
    const host::Writing writing =
        in_real_time ? host::Writing::real_time : host::Writing::background;
    if (!open_output(csv_, options_.csv, writing) || !open_output(trace_, options_.trace, writing))
      return kBadFile;
    if (csv_.is_same_file(trace_))
      return fail("error: `--csv` and `--trace` are one file\nhelp: give each its own", kBadUsage);
    if (!reserve_output(csv_, options_.csv) || !reserve_output(trace_, options_.trace))
      return kBadFile;
    std::string unseen = problem_of_scenes(options_, facts_);
    if (unseen.empty()) unseen = open_pictures(options_, program_);
    if (unseen.empty() && !options_.publish.empty()) {
      publishing_.emplace(options_, program_, inputs_.fields);
      // Again: by now there are files that were not there before.
      unseen = problem_with_files(options_);
      if (unseen.empty()) unseen = publishing_->open();
    }
    if (unseen.empty() && agent_ != nullptr) unseen = agent_->open();
    if (unseen.empty() && options_.agent == kExternalAgent) {
      external_.emplace(options_, inputs_.fields, program_, is_traced());
      unseen = external_->open();
    }
    const bool is_file = unseen.starts_with("error: cannot write");
    if (!unseen.empty()) return fail(unseen, is_file ? kBadFile : kBadUsage);
    const std::string alone = agent_ != nullptr ? agent_->wait_for_agent() : "";
    return alone.empty() ? kDone : fail(alone, kBadFile);
  }

  bool is_traced() const {
    return options_.hash || trace_.is_open() || publishing_ || inputs_.measures.reads_messages();
  }

  void begin() {
    summary_.graph = facts_.name;
    summary_.engine = facts_.engine;
    summary_.agent = std::string(agent_name(options_));
    summary_.seed = options_.plan.seed;
    if (facts_.has_fast_policy)
      summary_.more.emplace_back("profile", "fast: the hash holds for this build only");
  }

  void step_all(RunWatch& watch) {
    const bool is_traced = this->is_traced();
    if (is_traced && trace_.is_open()) {
      const TracedGraph graph{facts_.name,     facts_.engine,   facts_.rate_num,
                              facts_.rate_den, facts_.channels, facts_.channel_count};
      TraceText<host::TextFile>::head(trace_, graph, options_.plan.seed, options_.plan.environment,
                                      agent_name(options_), options_.trace_time);
      program_.recorder.write_to(&trace_, options_.trace_time);
      if (options_.trace_scenes) {
        scenes_.emplace(facts_.scene_rows);
        program_.recorder.keep_scenes(&trace_, &*scenes_);
      }
    }
    if (is_traced) program_.recorder.measure(inputs_.measures);
    if (publishing_) program_.recorder.publish(&*publishing_);
    program_.run(watch, is_traced);
    if (is_traced) {
      if (links_are_whole(program_) && calculates_as_everywhere())
        program_.recorder.write_end(program_.hash());
      hash_ = program_.hash();
    }
    program_.list_counts(is_traced, faults_);
  }

  int end(RunWatch& watch) {
    program_.spaces.list(faults_);
    watch.finish(summary_);
    if (agent_ != nullptr) agent_->finish(summary_);
    const std::string problem_of_pictures = close_pictures(program_.pictures(), summary_);
    const std::string unpublished = publishing_ ? publishing_->finish(summary_) : "";
    std::string broken = agent_ != nullptr ? agent_->problem() : end_links(program_, summary_);
    inputs_.reconnection.finish(summary_, broken);
    if (!watch.has_begun()) {
      csv_.discard();
      trace_.discard();
    }
    const bool csv_closed = close_output(csv_, options_.csv);
    const bool trace_closed = close_output(trace_, options_.trace);
    const bool is_right = calculates_as_everywhere();
    std::FILE* const out = options_.csv == "-" || options_.trace == "-" ? stderr : stdout;
    std::string text = options_.quiet ? "" : summary_text(summary_);
    // The hash of a run with a hole is that of no run.
    const bool is_whole = broken.empty() && !inputs_.reconnection.has_lost();
    if (options_.hash && is_whole && is_right) text += hash_line(hash_);
    const bool printed = text.empty() || print(out, text);
    if (!broken.empty()) fail(broken + "\n" + place_of(summary_), kBadFile);
    if (!problem_of_pictures.empty()) fail(problem_of_pictures, kBadFile);
    if (!unpublished.empty()) fail(unpublished, kBadFile);
    const std::string misled = external_ ? external_->problem() : "";
    if (!misled.empty()) fail(misled, kBadActions);
    if (!is_right) fail(kFloatsWentWrong, kSelfTestFailed);
    if (watch.left_space())
      fail("error: " + program_.spaces.first() + "\n" + place_of(summary_), kLeftSpace);
    const std::string not_finite = watch.not_finite();
    if (!not_finite.empty()) fail(not_finite, kNotFinite);
    host::end_by_signal();
    if (!broken.empty()) return kBadFile;
    if (!is_right) return kSelfTestFailed;
    if (!not_finite.empty()) return kNotFinite;
    if (!misled.empty()) return kBadActions;
    if (watch.left_space()) return kLeftSpace;
    if (!problem_of_pictures.empty() || !unpublished.empty()) return kBadFile;
    return csv_closed && trace_closed && printed ? kDone : kBadFile;
  }

  struct Faults final : CountListener {
    explicit Faults(Summary& of_run) : summary(of_run) {}
    void count(const char* name, std::uint64_t count) override {
      summary.faults.emplace_back(name, count);
    }
    Summary& summary;
  };

  const Options& options_;
  const RunInputs& inputs_;
  GraphProgram& program_;
  const GraphFacts& facts_;
  RemoteAgent* const agent_;
  host::TextFile csv_, trace_;
  std::optional<SceneRecord> scenes_;
  std::optional<Publishing> publishing_;
  std::optional<ExternalAgent> external_;
  Summary summary_;
  Faults faults_{summary_};
  std::uint64_t hash_ = 0;
};

}  // namespace

int run_session(const RunInputs& inputs, GraphProgram& program, RemoteAgent* agent) {
  return Session(inputs, program, agent).run();
}

}  // namespace eagerx::linux_sim
