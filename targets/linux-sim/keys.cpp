#include <cstring>
#include <runtime/host/key/key_file.hpp>
#include <targets/linux-sim/graph_program.hpp>
#include <targets/linux-sim/keys.hpp>

namespace eagerx::linux_sim {
namespace {

std::string does_nothing(const std::string& what) {
  return "error: `--key " + what + "` does nothing: " +
         "it is for TCP, and serial lines and unix sockets need none\nhelp: leave it out";
}

/// The part that `PART=FILE` begins with; as many as there are if it names none.
std::size_t part_named(const std::string& text, const GraphFacts& facts) {
  const std::string name = text.substr(0, text.find('='));
  std::size_t part = 0;
  while (part < facts.part_count && (name.size() == text.size() || name != facts.parts[part].name))
    ++part;
  return part;
}

}  // namespace

std::string find_keys(const std::vector<std::string>& given, const GraphFacts& facts,
                      const std::vector<std::string>& lines, std::vector<std::string>& files) {
  files.assign(facts.part_count, "");
  std::string of_all;
  for (const std::string& text : given) {
    const std::size_t part = part_named(text, facts);
    std::string& file = part == facts.part_count ? of_all : files[part];
    if (!file.empty()) return "error: two keys for one line\nhelp: give one `--key`";
    file = part == facts.part_count ? text : text.substr(text.find('=') + 1);
    if (part < facts.part_count && !is_tcp_address(lines[part])) return does_nothing(text);
  }
  bool is_used = of_all.empty();
  for (std::size_t part = 0; part < facts.part_count; ++part) {
    if (!files[part].empty() || of_all.empty() || !is_tcp_address(lines[part])) continue;
    files[part] = of_all;
    is_used = true;
  }
  return is_used ? std::string() : does_nothing(of_all);
}

std::string use_key_of(const std::string& file, const std::string& line, LinkPort& port) {
  if (!is_tcp_address(line)) return does_nothing(file);
  KeyInUse key;
  std::string problem;
  key.sodium = key::sodium(problem);
  if (key.sodium == nullptr) return "error: " + problem;
  problem = key::read_key(file, key.key);
  if (!problem.empty()) return "error: cannot use the key `" + file + "`: " + problem;
  port.use_key(key);
  explicit_bzero(key.key.data(), key.key.size());
  return {};
}

}  // namespace eagerx::linux_sim
