#include "targets/environments/ranks/ranks.hpp"

#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <numeric>
#include <string_view>

#include "targets/environments/client/problem.hpp"

namespace eagerx::environments {

std::vector<std::string> Ranks::gather(const std::string& mine) {
  const std::uint64_t own = mine.size();
  std::vector<std::uint64_t> lengths(size());
  const std::vector<std::size_t> of_lengths(size(), sizeof own);
  gather(std::span(reinterpret_cast<const char*>(&own), sizeof own),
         std::span(reinterpret_cast<char*>(lengths.data()), lengths.size() * sizeof own),
         of_lengths);
  const std::vector<std::size_t> sizes(lengths.begin(), lengths.end());
  std::string all(std::accumulate(sizes.begin(), sizes.end(), std::size_t{0}), '\0');
  gather(std::span(mine.data(), mine.size()), std::span(all.data(), all.size()), sizes);
  std::vector<std::string> pieces;
  std::string_view left = all;
  for (const std::size_t length : sizes) {
    pieces.emplace_back(left.substr(0, length));
    left.remove_prefix(length);
  }
  return pieces;
}

bool Ranks::is_any(bool here) {
  if (size() == 1) return here;
  const char mine = here ? '\1' : '\0';
  std::string all(size(), '\0');
  const std::vector<std::size_t> sizes(size(), 1);
  gather(std::span(&mine, 1), std::span(all.data(), all.size()), sizes);
  return std::ranges::count(all, '\0') != static_cast<std::ptrdiff_t>(size());
}

void Alone::abort(int exit_code) {
  std::exit(exit_code);
}

void Alone::gather(std::span<const char> mine, std::span<char> all,
                   std::span<const std::size_t> /*sizes*/) {
  std::ranges::copy(mine, all.begin());
}

void Alone::exchange(std::span<const char> out, std::span<const std::size_t> /*out_sizes*/,
                     std::span<char> in, std::span<const std::size_t> /*in_sizes*/) {
  std::ranges::copy(out, in.begin());
}

Ranks& alone() {
  static Alone ranks;
  return ranks;
}

Share share_of(std::size_t parts, std::uint32_t rank, std::uint32_t ranks) {
  return {parts * rank / ranks, parts * (rank + 1) / ranks};
}

std::string words_of(int argc, const char* const* argv) {
  std::string words;
  for (int i = 1; i < argc; ++i) words += argv[i] + std::string(1, '\0');
  return words;
}

std::vector<const char*> command_line(const char* name, const std::string& shared) {
  std::vector<const char*> argv = {name};
  for (std::size_t at = 0; at < shared.size(); at = shared.find('\0', at) + 1)
    argv.push_back(shared.data() + at);
  return argv;
}

std::string file_of(const std::string& bytes) {
  const int file = memfd_create("shared", MFD_CLOEXEC);
  std::string_view left = bytes;
  while (file >= 0 && !left.empty()) {
    const ssize_t written = write(file, left.data(), left.size());
    if (written < 0) break;
    left.remove_prefix(static_cast<std::size_t>(written));
  }
  if (file < 0 || !left.empty())
    throw client::Problem(client::kInputOutput, "no memory for a file of rank 0");
  return "/proc/self/fd/" + std::to_string(file);
}

}  // namespace eagerx::environments
