#include "targets/environments/train/evaluation.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "targets/environments/train/bytes.hpp"
#include "targets/environments/train/spent.hpp"

namespace eagerx::train {

void Evaluation::add(const Evaluation& more) {
  const auto mine = static_cast<double>(episodes), theirs = static_cast<double>(more.episodes);
  const auto mean = [&](double a, double b) { return (mine * a + theirs * b) / (mine + theirs); };
  mean_return = mean(mean_return, more.mean_return);
  const double my_steps = mine * mean_steps, their_steps = theirs * more.mean_steps;
  const auto of_steps = [&](double a, double b) {
    return (my_steps * a + their_steps * b) / (my_steps + their_steps);
  };
  saturated = of_steps(saturated, more.saturated);
  for (std::size_t i = 0; i < far.size(); ++i) far[i] = of_steps(far[i], more.far[i]);
  mean_steps = mean(mean_steps, more.mean_steps);
  for (std::size_t i = 0; i < terms.size(); ++i) terms[i] = mean(terms[i], more.terms[i]);
  lowest_return = std::min(lowest_return, more.lowest_return);
  highest_return = std::max(highest_return, more.highest_return);
  successes += more.successes;
  episodes += more.episodes;
  outcomes.insert(outcomes.end(), more.outcomes.begin(), more.outcomes.end());
}

struct Evaluator::Episode {
  double sum = 0.0;
  std::vector<double> terms;
  std::uint32_t steps = 0;
  bool success = false;
};

namespace {

/// Calls `visitor` with all of a part, for other ranks.
template <class Visitor, class Result>
void visit_result(Visitor& visitor, Result& result) {
  std::uint64_t count = result.episodes.size();
  visitor(count);
  result.episodes.resize(std::min(count, std::uint64_t{kLanes}));
  for (auto& episode : result.episodes) {
    visitor(episode.sum);
    visitor(episode.terms);
    visitor(episode.steps);
    visitor(episode.success);
  }
  visitor(result.saturated);
  visitor(result.numbers);
  visitor(result.far);
}

}  // namespace

/// The result of a part.
struct Evaluator::Result {
  std::vector<Episode> episodes;
  std::uint64_t saturated = 0, numbers = 0;  // of the actions
  std::vector<std::uint64_t> far;            // [inputs] steps
};

class Evaluator::Part {
 public:
  Part(const Library& library, std::uint32_t first, std::uint32_t count, std::uint32_t longest)
      : environments_(library.functions(), count, first, 0, longest, EAGERX_DISABLED),
        terms_(library.description().terms.size()),
        count_(count),
        rows_(library.description(), count),
        action_(count * library.description().action_numbers()) {
    rows_.terms.resize(count * terms_);
    rows_.observation.resize(kLanes * library.description().observation_numbers());
  }

  std::size_t count() const { return count_; }

  Result run(const Kernels& kernels, const Policy& policy, std::uint64_t seed,
             const Statistics& observations, const std::string& stage) {
    result_ = {.episodes = std::vector(count_, Episode{0.0, std::vector<double>(terms_), 0, false}),
               .far = std::vector<std::uint64_t>(policy.network.inputs())};
    row_.assign(policy.network.row(), Simd{});  // nothing is remembered
    std::vector<bool> ended(count_);
    environments_.set_stage(stage);
    environments_.reset(seed, rows_.observation.data());
    while (std::count(ended.begin(), ended.end(), false) != 0) {
      act(kernels, policy);
      for (std::uint32_t e = 0; e < count_; ++e) {
        if (!ended[e]) look(policy, observations, e);
      }
      step_all(environments_, action_.data(), rows_);
      for (std::uint32_t e = 0; e < count_; ++e) {
        if (!ended[e]) count(e);
        ended[e] = ended[e] || rows_.ended(e);
      }
    }
    return std::move(result_);
  }

 private:
  void act(const Kernels& kernels, const Policy& policy) {
    policy.answer(kernels, rows_.observation.data(), row_.data());
    const Simd* const answers = &row_[policy.network.output()];
    for (std::size_t e = 0; e < count_; ++e) {
      policy.head.act(answers, e, &action_[e * policy.head.numbers]);
    }
  }
  /// Counts what is at a bound, and what is far from all that was seen.
  void look(const Policy& policy, const Statistics& observations, std::uint32_t e) {
    for (std::size_t j = 0; j < policy.head.numbers && !policy.head.chooses; ++j) {
      const float x = action_[e * policy.head.numbers + j];
      result_.saturated += x <= policy.head.low[j] || x >= policy.head.high[j] ? 1 : 0;
      ++result_.numbers;
    }
    const std::size_t width = result_.far.size();
    for (std::size_t i = 0; i < width; ++i) {
      const double distance = rows_.observation[e * width + i] - observations.mean[i];
      result_.far[i] += std::abs(distance) * observations.scale(i) > double{kFar} ? 1 : 0;
    }
  }
  void count(std::uint32_t e) {
    Episode& episode = result_.episodes[e];
    episode.sum += rows_.reward[e];
    for (std::size_t i = 0; i < terms_; ++i) episode.terms[i] += rows_.terms[e * terms_ + i];
    ++episode.steps;
    episode.success = rows_.success[e] != 0;
  }

  Environments environments_;
  Result result_;
  std::size_t terms_, count_;
  Rows rows_;  // [count] of the last step; [kLanes] of observations
  std::vector<float> action_;
  Simds row_;
};

Evaluator::Evaluator(const Library& library, const Kernels& kernels, ThreadPool& pool,
                     std::uint32_t longest, std::size_t episodes, Ranks& ranks)
    : kernels_(kernels),
      pool_(pool),
      ranks_(ranks),
      has_threads_(library.description().has_threads),
      results_((episodes + kLanes - 1) / kLanes) {
  own_ = environments::share_of(results_.size(), ranks.rank(), ranks.size());
  for (std::size_t part = own_.first; part < own_.end; ++part) {
    const std::size_t first = part * kLanes, count = std::min(kLanes, episodes - first);
    parts_.push_back(std::make_unique<Part>(library, static_cast<std::uint32_t>(first),
                                            static_cast<std::uint32_t>(count), longest));
  }
  spent_s_.resize(parts_.size());
}

double Evaluator::spent_s() const {
  return std::accumulate(spent_s_.begin(), spent_s_.end(), 0.0);
}

Evaluator::~Evaluator() = default;

std::size_t Evaluator::parts() const {
  return results_.size();
}

/// Those of `some` that a rank computes.
environments::Share Evaluator::share_of(std::uint32_t rank, environments::Share some) const {
  const auto all = environments::share_of(parts(), rank, ranks_.size());
  const std::size_t first = std::max(all.first, some.first);
  return {first, std::max(first, std::min(all.end, some.end))};
}

Evaluation Evaluator::run(const Policy& policy, std::uint64_t seed, const Statistics& observations,
                          const std::string& stage, environments::Share some) {
  const auto own = share_of(ranks_.rank(), some);
  const auto work = [&](std::size_t i) {
    const std::size_t part = own.first + i;
    const Stopwatch watch;
    results_[part] = parts_[part - own_.first]->run(kernels_, policy, seed, observations, stage);
    spent_s_[i] += watch.seconds();
  };
  const auto all = together(
      ranks_,
      [&] {
        const std::size_t count = own.end - own.first;
        if (has_threads_) return pool_.run_parts(count, work);
        for (std::size_t i = 0; i < count; ++i) work(i);
      },
      [&] { return ranks_.size() == 1 ? std::string() : bytes_of(own); });
  for (std::uint32_t rank = 0; rank < ranks_.size(); ++rank) {
    if (rank != ranks_.rank()) take(share_of(rank, some), all[rank]);
  }
  return sum(policy.network.inputs(), seed, some);
}

std::string Evaluator::bytes_of(environments::Share parts) {
  Writer writer;
  for (std::size_t part = parts.first; part < parts.end; ++part)
    visit_result(writer, results_[part]);
  return std::move(writer.bytes);
}

void Evaluator::take(environments::Share parts, const std::string& bytes) {
  Reader reader(bytes);
  for (std::size_t part = parts.first; part < parts.end; ++part)
    visit_result(reader, results_[part]);
  if (!reader.complete) throw Problem(kInputOutput, "a rank has sent damaged results");
}

Evaluation Evaluator::sum(std::size_t inputs, std::uint64_t seed, environments::Share some) const {
  Evaluation result;
  result.far.resize(inputs);
  double numbers = 0.0;
  for (std::size_t i = some.first; i < some.end; ++i) {
    const Result& part = results_[i];
    result.saturated += static_cast<double>(part.saturated);
    numbers += static_cast<double>(part.numbers);
    for (std::size_t input = 0; input < inputs; ++input)
      result.far[input] += static_cast<double>(part.far[input]);
    for (const Episode& episode : part.episodes) {
      const auto environment = static_cast<std::uint32_t>(some.first * kLanes + result.episodes);
      result.outcomes.push_back({seed, environment, episode.steps, episode.sum, episode.success});
      const bool is_first = result.episodes++ == 0;
      result.successes += episode.success ? 1 : 0;
      result.mean_return += episode.sum;
      result.mean_steps += episode.steps;
      result.lowest_return = is_first ? episode.sum : std::min(result.lowest_return, episode.sum);
      result.highest_return = is_first ? episode.sum : std::max(result.highest_return, episode.sum);
      result.terms.resize(episode.terms.size());
      for (std::size_t term = 0; term < episode.terms.size(); ++term)
        result.terms[term] += episode.terms[term];
    }
  }
  const auto episodes = static_cast<double>(result.episodes);
  for (double& share : result.far) share /= result.mean_steps;
  result.saturated /= std::max(numbers, 1.0);
  result.mean_return /= episodes;
  result.mean_steps /= episodes;
  for (double& term : result.terms) term /= episodes;
  return result;
}

}  // namespace eagerx::train
