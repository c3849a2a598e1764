// Names of objects and nodes, wherever a graph has them.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

#include "generator/support/diagnostics/search.hpp"
#include "generator/tools/edit/edit.hpp"
#include "generator/tools/edit/words.hpp"

namespace eagerx::gen {
namespace {

constexpr std::array kOwners = {"objects", "nodes"};
/// Sections in which a word alone, without a port, is an object or a node.
constexpr std::array kOfWords = {"placement", "remove", "safety", "tunable", "budget", "allow"};

template <std::size_t N>
bool is_one_of(const std::array<const char*, N>& words, std::string_view word) {
  return ranges::contains(words, word);
}

class Uses {
 public:
  Uses(std::string_view text, const std::string& name) : text_(text), name_(name) {}

  std::vector<Bytes> all() {
    graph(outline_of(text_));
    std::ranges::sort(found_, std::less{}, &Bytes::begin);
    return std::move(found_);
  }

 private:
  void graph(const OutlineNode& top) {
    for (const OutlineEntry& section : top.entries) {
      if (is_one_of(kOwners, section.key)) {
        for (const OutlineEntry& owner : section.value.entries) {
          if (owner.key == name_ || owner.key.starts_with(name_ + "["))
            add(owner.key_place, name_.size());
          ports_in(owner.value);
        }
      } else if (section.key == "variants") {
        for (const OutlineEntry& variant : section.value.entries) graph(variant.value);
      } else {
        words_ = is_one_of(kOfWords, section.key);
        ports_in(section.value);
        words_ = false;
      }
    }
  }
  void ports_in(const OutlineNode& node) {
    if (node.kind == OutlineNode::Kind::scalar) ports_at(node.place);
    for (const OutlineEntry& entry : node.entries) {
      if (!entry.key.empty()) ports_at(entry.key_place);
      ports_in(entry.value);
    }
  }
  /// `name.port`, `name[0].port`, and where words may stand alone, `name`.
  void ports_at(Bytes place) {
    const std::string_view scalar = text_.substr(place.begin, place.end - place.begin);
    for (std::size_t at = scalar.find(name_); at != std::string_view::npos;
         at = scalar.find(name_, at + 1)) {
      const std::size_t end = at + name_.size();
      if (at > 0 && (is_letter(scalar[at - 1]) || scalar[at - 1] == '.' || scalar[at - 1] == '/'))
        continue;
      const char next = end < scalar.size() ? scalar[end] : ' ';
      const bool is_port = next == '.' && end + 1 < scalar.size() && is_letter(scalar[end + 1]);
      const bool is_element = next == '[' || next == '/';
      if (is_port || is_element || (words_ && !is_letter(next) && next != '.'))
        found_.push_back({place.begin + at, place.begin + end});
    }
  }
  void add(Bytes place, std::size_t size) {
    const bool is_quoted = text_[place.begin] == '"' || text_[place.begin] == '\'';
    const std::size_t begin = place.begin + (is_quoted ? 1 : 0);
    found_.push_back({begin, begin + size});
  }

  std::string_view text_;
  const std::string& name_;
  std::vector<Bytes> found_;
  bool words_ = false;
};

}  // namespace

std::vector<std::string> owners_of(std::string_view text) {
  std::vector<std::string> names;
  const OutlineNode top = outline_of(text);
  for (const char* const section : kOwners) {
    const OutlineNode* const all = top.find(section);
    if (all == nullptr || all->kind != OutlineNode::Kind::map) continue;
    for (const OutlineEntry& owner : all->entries)
      names.push_back(owner.key.substr(0, owner.key.find('[')));
  }
  return names;
}

std::vector<Bytes> uses_of(std::string_view text, const std::string& name) {
  const auto owners = owners_of(text);
  if (name.empty() || !ranges::contains(owners, name)) return {};
  return Uses(text, name).all();
}

bool is_free_name(std::string_view text, const std::string& name) {
  constexpr std::array kTaken = {"actions", "observations", "engine", "environment"};
  const auto owners = owners_of(text);
  return !name.empty() && std::isalpha(static_cast<unsigned char>(name[0])) != 0 &&
         ranges::all_of(name, is_letter) && !is_one_of(kTaken, name) &&
         !ranges::contains(owners, name);
}

std::string name_at(std::string_view text, std::size_t at) {
  std::size_t begin = std::min(at, text.size()), end = begin;
  while (begin > 0 && is_letter(text[begin - 1])) --begin;
  while (end < text.size() && is_letter(text[end])) ++end;
  std::string name(text.substr(begin, end - begin));
  const std::vector<Bytes> uses = uses_of(text, name);
  return ranges::contains(uses, begin, &Bytes::begin) ? name : std::string();
}

std::optional<Edit> rename(std::string_view text, const std::string& from, const std::string& to) {
  const std::vector<Bytes> uses = uses_of(text, from);
  if (uses.empty() || !is_free_name(text, to)) return std::nullopt;
  Edit edit{fmt::format("Rename `{}` to `{}`", from, to), {}};
  for (const Bytes& use : uses) edit.splices.push_back({use, to});
  return edit;
}

}  // namespace eagerx::gen
