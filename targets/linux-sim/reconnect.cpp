#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <runtime/host/base/interrupt.hpp>
#include <runtime/host/base/number.hpp>
#include <runtime/host/base/supervisor.hpp>
#include <string_view>
#include <targets/linux-sim/graph_program.hpp>
#include <targets/linux-sim/reconnect.hpp>
#include <thread>

namespace eagerx::linux_sim {
namespace {

constexpr std::uint64_t kWholeSecondNs = 1'000'000'000;
constexpr std::chrono::milliseconds kBetweenTries(50);

std::uint64_t ns_of(double seconds) {
  return static_cast<std::uint64_t>(seconds * static_cast<double>(kWholeSecondNs));
}
double seconds_from(std::uint64_t begin_ns, std::uint64_t end_ns) {
  const std::uint64_t ns = end_ns > begin_ns ? end_ns - begin_ns : 0;
  return static_cast<double>(ns) / static_cast<double>(kWholeSecondNs);
}
double seconds_until(std::uint64_t ns) {
  return seconds_from(LinkPort::now_ns(), ns);
}
double seconds_since(std::uint64_t ns) {
  return seconds_from(ns, LinkPort::now_ns());
}

void say(const std::string& text) {
  std::fputs((text + "\n").c_str(), stderr);
}

/// Without what to do about it: this is no error yet.
std::string as_note(const std::string& problem) {
  constexpr std::string_view kError = "error: ";
  const std::string text = problem.substr(0, problem.find("\nhelp: "));
  return "note: " + (text.starts_with(kError) ? text.substr(kError.size()) : text);
}

/// Whether a program in another language ends when its line does. The hub waits
/// for its restart as for any other.
bool ends_with_its_line(const link::PartFacts& part) {
  constexpr std::array<std::string_view, 2> kTargets{"python", "c"};
  return std::ranges::find(kTargets, std::string_view(part.target)) != kTargets.end();
}

}  // namespace

Reconnection::Reconnection(GraphProgram& program, const Options& options)
    : program_(program), options_(options), parts_(program.facts().part_count) {}

std::string Reconnection::problem_of_options() const {
  if (options_.reconnect_s <= 0.0) return {};
  const GraphFacts& facts = program_.facts();
  if (options_.plan.episodes < 2)
    return "error: `--reconnect` continues with the next episode, and there is only one\n"
           "help: say how many there are, `--episodes N`";
  if (facts.waits_in_resets)
    return "error: `--reconnect` does not go together with reset nodes: their resets continue from "
           "where the last episode ended, which a part that begins anew does not know\n"
           "help: leave it out";
  for (std::size_t part = 0; part < facts.part_count; ++part)
    if (ends_with_its_line(facts.parts[part]))
      say("note: " + name_of_part(facts.parts[part]) + ", for " + facts.parts[part].target +
          ", ends when its line is lost: it comes back if it is started again");
  return {};
}

bool Reconnection::link_again(std::uint64_t steps) {
  if (options_.reconnect_s <= 0.0 || host::interrupted()) return false;
  const GraphFacts& facts = program_.facts();
  static_cast<void>(find_parts(facts, options_, where_));  // as when they were connected
  note_losses(steps);
  host::make_safe_now();
  const host::WatchdogPause safely;
  const std::uint64_t begun_ns = LinkPort::now_ns();
  if (!wait_for_parts(begun_ns + ns_of(options_.reconnect_s))) return false;
  for (std::size_t part = 0; part < facts.part_count; ++part)
    program_.link(part)->set_time_limit(ns_of(options_.link_timeout_s));
  constexpr int kDigits = 2;
  say("note: all parts are connected after " + fixed(seconds_since(begun_ns), kDigits) +
      " s, and begin the next episode");
  return true;
}

/// Those that are whole stay on their lines.
void Reconnection::note_losses(std::uint64_t steps) {
  for (std::size_t part = 0; part < parts_.size(); ++part) {
    SplitLink& link = *program_.link(part);
    parts_[part].is_ready = false;
    parts_[part].is_away = !link.ok();
    if (link.ok()) continue;
    say(as_note(why_over(link, program_.facts())) + "\nnote: the episode ended after step " +
        std::to_string(steps) + " of the run; waits " + host::number_text(options_.reconnect_s) +
        " s for " + name_of_part(link.part()));
    note_loss(part);
  }
}

void Reconnection::note_loss(std::size_t part) {
  ++losses_;
  ++parts_[part].losses;
  parts_[part].is_away = true;
  program_.link(part)->port().close();
}

bool Reconnection::wait_for_parts(std::uint64_t until_ns) {
  const auto is_away = [](const Part& part) { return part.is_away; };
  for (;;) {
    bool is_ready = true;
    for (std::size_t part = 0; part < parts_.size(); ++part) {
      // Completed lines are reported only once all others are there: it may be long until then.
      const bool is_turn = parts_[part].is_away || std::ranges::none_of(parts_, is_away);
      if (!parts_[part].is_ready && is_turn) parts_[part].is_ready = try_part(part, until_ns);
      if (is_someone_else(part)) return give_up(part), false;
      is_ready = is_ready && parts_[part].is_ready;
    }
    if (is_ready) return true;
    host::stop_if_requested();
    if (host::interrupted()) return false;
    host::make_safe_now();  // again: hardware may have lost its power meanwhile
    if (LinkPort::now_ns() < until_ns) {
      std::this_thread::sleep_for(kBetweenTries);
      continue;
    }
    const auto missing = std::ranges::find(parts_, false, &Part::is_ready);
    return give_up(static_cast<std::size_t>(missing - parts_.begin())), false;
  }
}

bool Reconnection::try_part(std::size_t part, std::uint64_t until_ns) {
  SplitLink& link = *program_.link(part);
  Part& state = parts_[part];
  const GraphFacts& facts = program_.facts();
  state.problem = state.is_away
                      ? connect_part(link, where_.lines[part], where_.keys[part], facts, options_,
                                     std::min(options_.link_timeout_s, seconds_until(until_ns)))
                      : greet_part(link, facts, options_.link_timeout_s);
  if (!state.problem.empty() && !state.is_away) note_loss(part);
  if (!state.problem.empty()) link.port().close();
  if (state.problem.empty()) state.is_away = false;
  return state.problem.empty();
}

/// Whether another program is in its place, so that no wait is needed.
bool Reconnection::is_someone_else(std::size_t part) const {
  using link::Problem;
  constexpr std::array kWrong{Problem::other_protocol, Problem::other_runtime, Problem::other_graph,
                              Problem::refused};
  return std::ranges::find(kWrong, program_.link(part)->problem()) != kWrong.end();
}

void Reconnection::give_up(std::size_t part) {
  const std::string& problem = parts_[part].problem;
  if (is_someone_else(part)) {
    given_up_ = problem;
    return;
  }
  given_up_ = "error: " + name_of_part(program_.facts().parts[part]) +
              " was lost, and is not there again after " + host::number_text(options_.reconnect_s) +
              " s\n" + as_note(problem) +
              "\nhelp: start it again; `--reconnect` says how long it is waited for";
}

void Reconnection::finish(Summary& summary, std::string& broken) const {
  if (!given_up_.empty()) broken = given_up_;
  for (std::size_t part = 0; part < parts_.size(); ++part) {
    if (parts_[part].losses == 0) continue;
    const std::string prefix =
        parts_.size() == 1 ? std::string() : std::string(program_.facts().parts[part].name) + ": ";
    summary.more.emplace_back(prefix + "times lost", std::to_string(parts_[part].losses));
  }
  if (has_lost() && options_.hash && broken.empty())
    say("note: there is no trace hash, because an episode ended early; the others are those "
        "of a run without losses");
}

}  // namespace eagerx::linux_sim
