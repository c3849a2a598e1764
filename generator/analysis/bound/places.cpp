#include "generator/analysis/bound/places.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <memory>
#include <utility>

#include "generator/analysis/size/tools.hpp"

namespace eagerx::gen::bound {
namespace {

constexpr std::string_view kProgramFile = "/program.hpp";

/// "/x/program.hpp:17 (discriminator 2)": the file and the line.
std::pair<std::string_view, std::uint32_t> place_in(std::string_view text) {
  const auto colon = text.rfind(':');
  if (colon == std::string_view::npos) return {};
  std::uint32_t line = 0;
  std::from_chars(text.data() + colon + 1, text.data() + text.size(), line);
  return {text.substr(0, colon), line};
}

}  // namespace

std::uint32_t Texts::number_of(std::string_view text) {
  if (const auto found = numbers_.find(text); found != numbers_.end()) return found->second;
  const auto number = static_cast<std::uint32_t>(all_.size());
  numbers_.emplace(text, number);
  all_.emplace_back(text);
  return number;
}

Places::Places(const Image& image) : frames_(image.instructions().size()) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> list(std::tmpfile(), std::fclose);
  if (list == nullptr) return;
  for (const Instruction& instruction : image.instructions())
    fmt::print(list.get(), "{:x}\n", instruction.at);
  if (std::fflush(list.get()) != 0 || std::fseek(list.get(), 0, SEEK_SET) != 0) return;
  constexpr int kHexadecimal = 16;
  std::vector<Frame>* frames = nullptr;
  bool is_function = true;
  const auto take = [&](std::string_view line) {
    if (line.starts_with("0x")) {
      Address at = 0;
      std::from_chars(line.data() + 2, line.data() + line.size(), at, kHexadecimal);
      const Instruction* instruction = image.instruction(at);
      frames = instruction == nullptr ? nullptr : &frames_[instruction->index];
      is_function = true;
      return;
    }
    if (frames == nullptr) return;
    if (is_function) {
      frames->push_back({functions_.number_of(line), files_.number_of(""), 0});
    } else {
      const auto [file, number] = place_in(line);
      frames->back().file = files_.number_of(file);
      frames->back().line = number;
    }
    is_function = !is_function;
  };
  for_each_line({image.prefix() + "addr2line", "-a", "-f", "-i", "-e", image.path()}, take,
                fileno(list.get()));
  occurrences_.resize(functions().size());
  for (std::uint32_t i = 0; i < frames_.size(); ++i) {
    for (std::uint32_t frame = 0; frame < frames_[i].size(); ++frame)
      occurrences_[frames_[i][frame].function].push_back({i, frame});
  }
}

std::vector<bool> Places::are_programs() const {
  std::vector<bool> are;
  for (const std::string& file : files()) are.push_back(file.ends_with(kProgramFile));
  return are;
}

std::string Places::program() const {
  const std::vector<bool> are = are_programs();
  const auto found = std::ranges::find(are, true);
  return found == are.end() ? "" : files()[static_cast<std::size_t>(found - are.begin())];
}

std::vector<const std::string*> Places::nodes(const ProgramMap& map) const {
  const std::vector<bool> are = are_programs();
  std::vector<const std::string*> nodes(frames_.size());
  for (std::size_t i = 0; i < frames_.size(); ++i) {
    for (const Frame& frame : frames_[i]) {
      if (are[frame.file]) nodes[i] = map.node_of_line(frame.line);
      if (nodes[i] != nullptr) break;
    }
  }
  return nodes;
}

}  // namespace eagerx::gen::bound
