#include "targets/environments/train/ranks/together.hpp"

#include <algorithm>
#include <optional>

#include "targets/environments/train/bytes.hpp"
#include "targets/environments/train/client.hpp"

namespace eagerx::train {
namespace {

using environments::Share;
using environments::share_of;

/// "" or the bytes of a problem: its exit code, what it says, what helps.
std::string bytes_of(const std::optional<Problem>& problem) {
  if (!problem) return {};
  return std::string(1, static_cast<char>(problem->code)) + problem->what() + '\0' + problem->help;
}

void throw_again(const std::string& bytes) {
  if (bytes.empty()) return;
  const std::size_t end = bytes.find('\0', 1);
  throw Problem(static_cast<ExitCode>(static_cast<unsigned char>(bytes[0])),
                bytes.substr(1, end - 1), bytes.substr(end + 1));
}

std::vector<float> behind(const std::vector<float>& values, std::size_t first) {
  first = std::min(first, values.size());
  return {values.begin() + static_cast<std::ptrdiff_t>(first), values.end()};
}

}  // namespace

std::vector<std::string> together(Ranks& ranks, const std::function<void()>& work,
                                  const std::function<std::string()>& bytes) {
  if (ranks.size() == 1) {
    work();
    return {bytes()};
  }
  std::optional<Problem> problem;
  try {
    work();
  } catch (const Problem& what) {
    problem = what;
  }
  const std::string said = bytes_of(problem);
  Writer mine;
  mine(std::vector<char>(said.begin(), said.end()));
  mine.bytes += problem ? std::string() : bytes();
  std::vector<std::string> all = ranks.gather(mine.bytes);
  for (std::string& one : all) {
    Reader reader(one);
    std::vector<char> what;
    reader(what);
    throw_again({what.begin(), what.end()});
    one.erase(0, sizeof(std::uint64_t) + what.size());
  }
  return all;
}

void share_seen(Ranks& ranks, const std::vector<std::unique_ptr<RolloutStatistics>>& parts,
                const std::function<void()>& work) {
  if (ranks.size() == 1) return work();
  const Share own = share_of(parts.size(), ranks.rank(), ranks.size());
  std::vector<std::size_t> known;  // actions of each
  known.reserve(parts.size());
  for (const auto& part : parts) known.push_back(part->taken.size());
  const auto all = together(ranks, work, [&] {
    Writer writer;
    for (std::size_t part = own.first; part < own.end; ++part) {
      visit_rollout(writer, *parts[part]);
      writer(behind(parts[part]->taken, known[part]));
    }
    return std::move(writer.bytes);
  });
  for (std::uint32_t rank = 0; rank < ranks.size(); ++rank) {
    if (rank == ranks.rank()) continue;
    const Share theirs = share_of(parts.size(), rank, ranks.size());
    Reader reader(all[rank]);
    std::vector<float> taken;
    for (std::size_t part = theirs.first; part < theirs.end; ++part) {
      visit_rollout(reader, *parts[part]);
      reader(taken);
      parts[part]->taken.insert(parts[part]->taken.end(), taken.begin(), taken.end());
    }
    if (!reader.complete) throw Problem(kInputOutput, "a rank has sent damaged results");
  }
}

}  // namespace eagerx::train
