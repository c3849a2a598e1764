#include "generator/frontend/spec/foreign_words.hpp"

#include <algorithm>
#include <array>
#include <cctype>

namespace eagerx::gen {
namespace {

struct Meaning {
  std::string_view word, here;
};

constexpr std::array kWords = {
    // of an episode
    Meaning{"done", "terminated"}, Meaning{"termination", "terminated"},
    Meaning{"terminate", "terminated"}, Meaning{"failure", "terminated"},
    Meaning{"timeout", "truncated"}, Meaning{"max_steps", "truncated"},
    Meaning{"max_episode_steps", "truncated"}, Meaning{"time_limit", "truncated"},
    Meaning{"goal", "success"}, Meaning{"cost", "reward"},
    // of distributions
    Meaning{"gaussian", "normal"}, Meaning{"gauss", "normal"}, Meaning{"randn", "normal"},
    Meaning{"mu", "mean"}, Meaning{"sigma", "std"}, Meaning{"stddev", "std"},
    Meaning{"loguniform", "log_uniform"}, Meaning{"constant", "value"}, Meaning{"fixed", "value"},
    Meaning{"initial", "value"},
    // of entities and spaces
    Meaning{"frequency", "rate"}, Meaning{"freq", "rate"}, Meaning{"hz", "rate"},
    Meaning{"params", "config"}, Meaning{"parameters", "config"}, Meaning{"args", "config"},
    Meaning{"class", "type"}, Meaning{"kind", "type"}, Meaning{"min", "low"},
    Meaning{"max", "high"}, Meaning{"size", "shape"}};

constexpr std::array kTrue = {"yes", "y", "on", "true", "1"};
constexpr std::array kFalse = {"no", "n", "off", "false", "0"};

std::string lower_case(std::string_view word) {
  std::string result(word);
  for (char& c : result) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return result;
}

}  // namespace

std::string foreign_word(std::string_view word, const std::vector<std::string>& known) {
  const std::string wanted = lower_case(word);
  for (const Meaning& each : kWords) {
    if (each.word != wanted) continue;
    if (std::find(known.begin(), known.end(), each.here) != known.end())
      return std::string(each.here);
  }
  return {};
}

std::string_view foreign_truth(std::string_view word) {
  const std::string wanted = lower_case(word);
  if (std::find(kTrue.begin(), kTrue.end(), wanted) != kTrue.end()) return "true";
  if (std::find(kFalse.begin(), kFalse.end(), wanted) != kFalse.end()) return "false";
  return {};
}

}  // namespace eagerx::gen
