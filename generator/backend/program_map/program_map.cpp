#include "generator/backend/program_map/program_map.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <utility>

namespace eagerx::gen {
namespace {

constexpr std::string_view kFirstLine = "eagerx-gen program map 2";

/// One line in words.
class Words {
 public:
  explicit Words(std::string_view line) : rest_(line) {}

  /// Empty behind the last one.
  std::string_view word() {
    const std::size_t end = std::min(rest_.find(' '), rest_.size());
    const std::string_view word = rest_.substr(0, end);
    rest_.remove_prefix(std::min(end + 1, rest_.size()));
    return word;
  }
  template <class Number>
  std::optional<Number> number(int base = 10) {
    const std::string_view text = word();
    Number value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, base);
    if (text.empty() || error != std::errc{} || end != text.data() + text.size())
      return std::nullopt;
    return value;
  }
  /// All that is left: a file's name may have blanks.
  std::string rest() { return std::string(std::exchange(rest_, {})); }
  [[nodiscard]] bool at_end() const { return rest_.empty(); }

 private:
  std::string_view rest_;
};

class Parser {
 public:
  Parser(std::string_view text, const std::string& path, Diagnostics& diagnostics)
      : rest_(text), path_(path), diagnostics_(diagnostics) {}

  std::optional<ProgramMap> run() {
    if (next_line() != kFirstLine) return fail("is not a program map that this eagerx-gen reads");
    while (!rest_.empty()) {
      const std::string_view line = next_line();
      Words words(line);
      if (!line.starts_with('#') && !(take(words) && words.at_end()))
        return fail("is not a line of a program map");
    }
    if (!has_hash_) return fail("ends without the hash of program.hpp");
    return std::move(map_);
  }

 private:
  std::string_view next_line() {
    ++line_;
    const std::size_t end = std::min(rest_.find('\n'), rest_.size());
    const std::string_view line = rest_.substr(0, end);
    rest_.remove_prefix(std::min(end + 1, rest_.size()));
    return line;
  }

  bool take(Words& words) {
    const std::string_view kind = words.word();
    if (kind == "program") return take_program(words);
    if (kind == "node") return take_node(words);
    if (kind == "lines") return take_lines(words);
    if (kind == "shares") return take_shares(words);
    if (kind == "graph") return take_graph(words);
    if (kind == "place") return take_place(words);
    return kind == "member" && take_member(words);
  }

  bool take_program(Words& words) {
    constexpr int kHexadecimal = 16;
    const auto hash = words.number<std::uint64_t>(kHexadecimal);
    if (!hash || has_hash_) return false;
    map_.program_hash = *hash;
    has_hash_ = true;
    return true;
  }

  bool take_node(Words& words) {
    const std::string name(words.word()), type(words.word());
    return !name.empty() && !type.empty() && map_.type_of_node.emplace(name, type).second;
  }

  bool take_lines(Words& words) {
    const auto first = words.number<std::uint32_t>();
    const auto last = words.number<std::uint32_t>();
    const std::string node(words.word());
    const std::uint32_t before = map_.blocks.empty() ? 0 : map_.blocks.back().last;
    if (!first || !last || *first <= before || *last < *first || !map_.type_of_node.contains(node))
      return false;
    map_.blocks.push_back({*first, *last, node});
    return true;
  }

  bool take_member(Words& words) {
    const std::string member(words.word());
    const std::string_view kind = words.word();
    const ProgramMap::Owner owner{kind == "node", std::string(words.word())};
    if (member.empty() || owner.name.empty() || (kind != "node" && kind != "part")) return false;
    if (owner.is_node && !map_.type_of_node.contains(owner.name)) return false;
    return map_.owner_of_member.emplace(member, owner).second;
  }

  bool take_shares(Words& words) {
    const std::string node(words.word()), owner(words.word());
    return map_.type_of_node.contains(node) && map_.type_of_node.contains(owner) &&
           !map_.shares.contains(owner) && map_.shares.emplace(node, owner).second;
  }

  bool take_graph(Words& words) {
    if (!map_.graph_file.empty()) return false;
    map_.graph_file = words.rest();
    return !map_.graph_file.empty();
  }

  bool take_place(Words& words) {
    const auto line = words.number<std::uint32_t>();
    const auto column = words.number<std::uint32_t>();
    const std::string element(words.word());
    if (!line || !column || element.empty()) return false;
    map_.places.push_back({*line, *column, element});
    return true;
  }

  std::optional<ProgramMap> fail(std::string_view what) {
    diagnostics_.io_error("E0911", {}, fmt::format("`{}:{}` {}", path_, line_, what)).help =
        "generate the program again and build it anew";
    return std::nullopt;
  }

  std::string_view rest_;
  const std::string& path_;
  Diagnostics& diagnostics_;
  std::uint32_t line_ = 0;
  ProgramMap map_;
  bool has_hash_ = false;
};

}  // namespace

const std::string* ProgramMap::node_of_line(std::uint32_t line) const {
  const auto after =
      std::ranges::upper_bound(blocks, line, {}, [](const Block& block) { return block.first; });
  if (after == blocks.begin()) return nullptr;
  const Block& block = *std::prev(after);
  return line <= block.last ? &block.node : nullptr;
}

ProgramMap::Owner ProgramMap::owner(const std::string& member) const {
  const auto found = owner_of_member.find(member);
  return found != owner_of_member.end() ? found->second : Owner{false, "schedule"};
}

std::string to_text(const ProgramMap& map) {
  std::string text = fmt::format("{}\n", kFirstLine);
  text +=
      "# What of program.hpp belongs to which node, for `eagerx-gen size`: the hash of its text, "
      "nodes and\n";
  text +=
      "# their types, lines, members of the class. Places are lines and columns of the graph.\n";
  text += fmt::format("program {:016x}\n", map.program_hash);
  for (const auto& [node, type] : map.type_of_node) text += fmt::format("node {} {}\n", node, type);
  for (const auto& block : map.blocks)
    text += fmt::format("lines {} {} {}\n", block.first, block.last, block.node);
  for (const auto& [member, owner] : map.owner_of_member)
    text += fmt::format("member {} {} {}\n", member, owner.is_node ? "node" : "part", owner.name);
  for (const auto& [node, owner] : map.shares) text += fmt::format("shares {} {}\n", node, owner);
  if (!map.graph_file.empty()) text += fmt::format("graph {}\n", map.graph_file);
  for (const auto& place : map.places)
    text += fmt::format("place {} {} {}\n", place.line, place.column, place.element);
  return text;
}

std::optional<ProgramMap> parse_program_map(std::string_view text, const std::string& path,
                                            Diagnostics& diagnostics) {
  return Parser(text, path, diagnostics).run();
}

}  // namespace eagerx::gen
