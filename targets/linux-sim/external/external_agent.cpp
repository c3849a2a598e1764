#include <fcntl.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/uio.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <ctime>
#include <eagerx/version.hpp>
#include <limits>
#include <runtime/host/base/interrupt.hpp>
#include <runtime/host/base/json.hpp>
#include <runtime/host/base/number.hpp>
#include <runtime/host/base/supervisor.hpp>
#include <targets/linux-sim/describe.hpp>
#include <targets/linux-sim/elements.hpp>
#include <targets/linux-sim/external/external_agent.hpp>
#include <targets/linux-sim/options.hpp>
#include <targets/linux-sim/pacer.hpp>
#include <targets/linux-sim/pictures/pictures.hpp>
#include <utility>

namespace eagerx::linux_sim {
namespace {

constexpr double kNsInSecond = 1e9;
// Of the time until something of the graph is due next; the rest is for what is done before.
constexpr double kPatience = 0.8;
// Between episodes the safe action is sent again at this interval: an adapter may have been plugged
// in meanwhile, and a watchdog wants to hear something.
constexpr std::int64_t kSafeAgainNs = 250'000'000;

/// Of what is due most often, at least as often as the environment.
double shortest_period_s(const GraphFacts& facts) {
  double shortest = facts.period_s();
  for (std::size_t c = 0; c < facts.channel_count; ++c) {
    const Channel& channel = facts.channels[c];
    shortest = std::min(
        shortest, static_cast<double>(channel.rate_den) / static_cast<double>(channel.rate_num));
  }
  return shortest;
}

/// How long a step waits for its action; 0: for ever.
std::int64_t patience_ns(const Options& options, const GraphFacts& facts, bool is_real) {
  double period_s = 0.0;
  if (is_real) {
    period_s = shortest_period_s(facts);
  } else if (options.real_time_factor > 0.0 && facts.safety.declared) {
    period_s = facts.period_s() / options.real_time_factor;
  }
  return static_cast<std::int64_t>(period_s * kPatience * kNsInSecond);
}

std::size_t terms_of(const Fields& fields) {
  const auto is_number = [](const Fields::Outcome& each) { return !each.is_flag; };
  const auto numbers = std::ranges::count_if(fields.outcomes, is_number);
  return numbers > 0 ? static_cast<std::size_t>(numbers) - 1 : 0;  // the first is the reward
}

struct Counted final : CountListener {
  explicit Counted(host::Json& to) : json(to) {}
  void count(const char* name, std::uint64_t count) override {
    if (count > 0) json.key(name).whole(count);
  }
  host::Json& json;
};

}  // namespace

ExternalAgent::ExternalAgent(const Options& options, const Fields& fields, GraphProgram& program,
                             bool traced)
    : options_(options),
      facts_(program.facts()),
      program_(program),
      fields_(fields),
      rows_(fields),
      seen_(fields.observations),
      sampled_(fields.states),
      sizes_(fields.observations.size()),
      action_(program.action_bytes() / sizeof(std::max_align_t) + 1),
      terms_(terms_of(fields)),
      row_(terms_.size() + rows_.action_numbers() + rows_.observation_numbers()),
      given_(std::max(rows_.action_numbers(), rows_.state_numbers())),
      states_(rows_.state_numbers()),
      tuned_(rows_.state_numbers(), std::numeric_limits<float>::quiet_NaN()),
      socket_(options.agent_socket),
      patience_ns_(patience_ns(options, facts_, program.is_real())),
      is_traced_(traced),
      is_real_(program.is_real()) {
  program_.zero(action_.data());
  program_.sample({0, 0, 0}, sampled_.row());  // the same states for every key
}

ExternalAgent::~ExternalAgent() {
  host::on_gone(nullptr, nullptr);
}

std::string ExternalAgent::open() {
  int type = 0;
  socklen_t size = sizeof type;
  if (getsockopt(socket_, SOL_SOCKET, SO_TYPE, &type, &size) != 0 || type != SOCK_SEQPACKET)
    return "error: " + std::to_string(socket_) +
           " is not a socket of type SOCK_SEQPACKET\nhelp: `--agent fd:N` is for a program that "
           "starts "
           "this one with an end of a socketpair, such as Python's `eagerx_gen.make(…, "
           "real_time_factor=1)`";
  fcntl(socket_, F_SETFD, FD_CLOEXEC);  // not for ffmpeg
  if (is_real_ && !facts_.safety.declared)
    return "error: this program drives real hardware, and its graph does not define what happens "
           "when "
           "the agent is late\nhelp: write `safety: {late: 3}` into the graph, or how many steps "
           "in "
           "a row may be without an action";
  const std::size_t longest = sizeof(float) * std::max(row_.size(), given_.size());
  if (longest > kLongestRow)
    return "error: a row of this graph has " + std::to_string(longest) + " bytes, and " +
           std::to_string(kLongestRow) +
           " go to an external agent at most\nhelp: make the graph's "
           "observations smaller";
  host::on_gone([](void* agent) { return static_cast<ExternalAgent*>(agent)->is_gone(); }, this);
  return {};
}

bool ExternalAgent::is_gone() const {
  pollfd ready{socket_, POLLIN, 0};
  return poll(&ready, 1, 0) > 0 && (ready.revents & POLLHUP) != 0;
}

void ExternalAgent::reset(std::uint32_t episode) {
  answer_ = {};
  answer_.episode = episode;
  std::ranges::fill(terms_, 0.0);
  std::fill_n(applied_row(), rows_.action_numbers(), 0.0F);
  rows_.write_observation(observation(), observation_row());
  program_.zero(action_.data());
  in_episode_ = true;
  wants_reset_ = end_is_news_ = false;
  late_in_a_row_ = 0;
}

void ExternalAgent::step(Seq step, bool has_ended, bool is_longest, const OutcomeView& outcome) {
  answer_.step = step;
  answer_.reward += outcome.reward;
  answer_.flags = (outcome.terminated ? kTerminated : 0U) |
                  (outcome.truncated || is_longest ? kTruncated : 0U) |
                  (outcome.success ? kSuccess : 0U);
  for (std::size_t i = 0; outcome.terms != nullptr && i < terms_.size(); ++i)
    terms_[i] += number_of(outcome.scalar, outcome.terms, i);
  rows_.write_observation(observation(), observation_row());
  in_episode_ = !has_ended;
  end_is_news_ = has_ended && !waits_;
}

bool ExternalAgent::go_on() {
  if (ends_) return false;
  if (wants_reset_) return true;
  answer_.time_ns = now_ns();
  answer_observation();
  if (!in_episode_) host::make_safe_now();
  for (;;) {
    std::int64_t until_ns = 0;
    if (in_episode_ && patience_ns_ > 0) until_ns = answer_.time_ns + patience_ns_;
    if (!in_episode_ && is_real_) until_ns = now_ns() + kSafeAgainNs;
    const Got got = receive(until_ns);
    if (ends_ || got == Got::end) return false;
    if (got == Got::request) {
      if (serve()) return true;
      if (ends_) return false;
    } else if (in_episode_) {
      ++late_in_a_row_;
      ++answer_.late;
      return true;
    } else {
      host::make_safe_now();
    }
  }
}

/// Waits for a request until then; 0: for ever. A signal that ends the run is an end.
ExternalAgent::Got ExternalAgent::receive(std::int64_t until_ns) {
  constexpr std::int64_t kWhole = 1'000'000'000;
  for (;;) {
    const std::int64_t left_ns = until_ns == 0 ? 0 : std::max<std::int64_t>(until_ns - now_ns(), 0);
    const timespec left{static_cast<time_t>(left_ns / kWhole), static_cast<long>(left_ns % kWhole)};
    pollfd ready{socket_, POLLIN, 0};
    if (until_ns != 0) host::say_asleep_until(until_ns);
    const int count = ppoll(&ready, 1, until_ns == 0 ? nullptr : &left, nullptr);
    if (host::interrupted()) return Got::end;
    host::stop_if_requested();
    if (count == 0) return Got::nothing;
    if (count < 0) continue;
    std::array<iovec, 2> parts{
        {{&request_, sizeof request_}, {given_.data(), given_.size() * sizeof(float)}}};
    msghdr message{};
    message.msg_iov = parts.data();
    message.msg_iovlen = parts.size();
    const ssize_t bytes = recvmsg(socket_, &message, MSG_DONTWAIT | MSG_TRUNC);
    if (bytes < 0 && (errno == EAGAIN || errno == EINTR)) continue;
    if (bytes <= 0) return lose(""), Got::end;
    const char* const wrong = problem_of_request(request_, static_cast<std::size_t>(bytes),
                                                 rows_.action_numbers(), rows_.state_numbers());
    if (wrong == nullptr) return Got::request;
    lose("error: a request of the agent has " + std::to_string(bytes) + " bytes, and " + wrong +
         "\nhelp: use the Python package of the same eagerx-gen");
    return Got::end;
  }
}

/// True: the run continues with a step or a reset.
bool ExternalAgent::serve() {
  switch (request_.ask) {
    case Ask::reset:
      return take_reset();
    case Ask::step:
      return take_step();
    case Ask::close:
      ends_ = is_announced_ = true;
      break;
    case Ask::tune:
      take_parameters();
      break;
    case Ask::hash: {
      Answer answer{};
      answer.said = AnswerKind::number;
      answer.step = is_traced_ ? program_.hash() : 0;
      say(answer, nullptr, 0);
      break;
    }
    case Ask::describe:
    case Ask::counts:
      if (request_.number == 0) text_ = request_.ask == Ask::counts ? counts() : description();
      answer_piece(text_.data(), text_.size());
      break;
    case Ask::picture:
      give_picture();
      break;
  }
  return false;
}

bool ExternalAgent::take_reset() {
  const std::string problem = rows_.problem_of_states(given_.data(), sampled_.row().has_value);
  if (!problem.empty()) return answer_problem(problem), false;
  // Parameters for a step that does not come are those of the episode.
  for (std::size_t i = 0; i < states_.size(); ++i)
    states_[i] = std::isnan(given_[i]) ? tuned_[i] : given_[i];
  std::ranges::fill(tuned_, std::numeric_limits<float>::quiet_NaN());
  has_tuned_ = false;
  has_states_ = std::ranges::any_of(states_, [](float number) { return !std::isnan(number); });
  if (request_.number != 0) {
    has_seed_ = true;
    seed_ = request_.seed;
    episode_of_seed_ = 0;
  }
  in_episode_ = false;
  return waits_ = wants_reset_ = true;
}

void ExternalAgent::take_parameters() {
  if (!in_episode_)
    return answer_problem("no episode has begun, or it has ended: set states at the next reset");
  const std::string problem = rows_.problem_of_parameters(given_.data());
  if (!problem.empty()) return answer_problem(problem);
  for (std::size_t i = 0; i < tuned_.size(); ++i) {
    if (!std::isnan(given_[i])) tuned_[i] = given_[i];
  }
  has_tuned_ = true;
  Answer answer{};
  answer.said = AnswerKind::number;
  say(answer, nullptr, 0);
}

bool ExternalAgent::apply_parameters(StateRow states) {
  if (!std::exchange(has_tuned_, false)) return false;
  rows_.read_states(tuned_.data(), states);
  std::ranges::fill(tuned_, std::numeric_limits<float>::quiet_NaN());
  return true;
}

bool ExternalAgent::take_step() {
  if (end_is_news_) {
    end_is_news_ = false;
    waits_ = true;
    answer_observation();
    return false;
  }
  if (!in_episode_) {
    answer_problem("no episode has begun, or it has ended: reset() comes before the next step");
    return false;
  }
  rows_.read_action(given_.data(), action_.data());
  late_in_a_row_ = 0;
  return waits_ = true;
}

void ExternalAgent::give_picture() {
  Pictures* const pictures = program_.pictures();
  const std::uint8_t* const pixels =
      pictures == nullptr ? nullptr : pictures->kept(request_.number == 0);
  if (pixels == nullptr) return answer_problem("this program keeps no pictures");
  constexpr std::size_t kChannels = 3;
  const Rendering& size = options_.rendering;
  answer_piece(pixels, static_cast<std::size_t>(size.width) *
                           static_cast<std::size_t>(size.height) * kChannels);
}

EpisodeKey ExternalAgent::key(EpisodeKey planned) {
  if (!has_seed_) return planned;
  return {seed_, planned.environment, episode_of_seed_++};
}

bool ExternalAgent::apply_states(StateRow states) {
  if (!std::exchange(has_states_, false)) return false;
  rows_.read_states(states_.data(), states);
  return true;
}

void ExternalAgent::answer_observation() {
  if (!std::exchange(waits_, false)) return;
  answer_.said = AnswerKind::observation;
  for (std::size_t i = 0; i < terms_.size(); ++i) row_[i] = static_cast<float>(terms_[i]);
  say(answer_, row_.data(), row_.size() * sizeof(float));
  answer_.reward = 0.0;
  answer_.late = 0;
  std::ranges::fill(terms_, 0.0);
}

void ExternalAgent::answer_problem(const std::string& text) {
  Answer answer{};
  answer.said = AnswerKind::problem;
  say(answer, text.data(), text.size());
}

void ExternalAgent::answer_piece(const void* data, std::size_t bytes) {
  const std::size_t first = std::min<std::size_t>(request_.number, bytes);
  Answer answer{};
  answer.said = AnswerKind::piece;
  answer.step = bytes;
  say(answer, static_cast<const char*>(data) + first, std::min(kLongestPiece, bytes - first));
}

/// Never waits: an agent that does not read what it asked for ends the run.
void ExternalAgent::say(Answer answer, const void* data, std::size_t bytes) {
  answer.asked = request_.asked;
  // sendmsg() only reads it.
  std::array<iovec, 2> parts{{{&answer, sizeof answer}, {const_cast<void*>(data), bytes}}};
  msghdr message{};
  message.msg_iov = parts.data();
  message.msg_iovlen = parts.size();
  if (sendmsg(socket_, &message, MSG_DONTWAIT | MSG_NOSIGNAL) < 0) lose("");
}

/// The run ends, and what is left of an episode is made safe.
void ExternalAgent::lose(std::string why) {
  ends_ = true;
  if (problem_.empty()) problem_ = std::move(why);
}

std::string ExternalAgent::description() const {
  host::Json json;
  json.begin_object().key("version").whole(kExternalVersion);
  json.key("generator").text(std::to_string(kVersionMajor) + "." + std::to_string(kVersionMinor));
  json.key("graph").text(facts_.name).key("engine").text(facts_.engine);
  json.key("rate_hz").number(1.0 / facts_.period_s()).key("real").boolean(is_real_);
  json.key("patience_s");
  patience_ns_ > 0 ? json.number(static_cast<double>(patience_ns_) / kNsInSecond) : json.null();
  rows_.describe_observations(json.key("observations"));
  rows_.describe_actions(json.key("actions"));
  rows_.describe_states(json.key("states"));
  json.key("tunable").begin_list();
  for (const Field& state : fields_.states)
    if (state.tunable) json.text(state.name);
  json.end_list();
  describe_task(json.key("task"));
  describe_render(json.key("render"));
  return json.end_object().str();
}

/// The terms of the reward, which is the first number itself.
void ExternalAgent::describe_task(host::Json& json) const {
  const auto is_number = [](const Fields::Outcome& each) { return !each.is_flag; };
  if (std::ranges::none_of(fields_.outcomes, is_number)) {
    json.null();
    return;
  }
  json.begin_object().key("terms").begin_list();
  bool is_first = true;
  for (const Fields::Outcome& each : fields_.outcomes)
    if (is_number(each) && !std::exchange(is_first, false)) json.text(each.name);
  json.end_list().end_object();
}

void ExternalAgent::describe_render(host::Json& json) const {
  if (!facts_.is_shown) {
    json.null();
    return;
  }
  const double rate_hz =
      static_cast<double>(facts_.render_num) / static_cast<double>(facts_.render_den);
  json.begin_object().key("rate_hz").number(rate_hz).end_object();
}

std::string ExternalAgent::counts() const {
  host::Json json;
  json.begin_object();
  Counted counted(json);
  program_.list_counts(is_traced_, counted);
  return json.end_object().str();
}

}  // namespace eagerx::linux_sim
