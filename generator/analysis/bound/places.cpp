#include "generator/analysis/bound/places.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <cstdlib>
#include <memory>

#include "generator/analysis/size/tools.hpp"

namespace eagerx::gen::bound {
namespace {

constexpr std::string_view kProgramFile = "/program.hpp";

/// "/x/program.hpp:17 (discriminator 2)"
void read_line(std::string_view text, Frame& frame) {
  const auto colon = text.rfind(':');
  if (colon == std::string_view::npos) return;
  frame.file = text.substr(0, colon);
  frame.line = static_cast<std::uint32_t>(
      std::strtoul(std::string(text.substr(colon + 1)).c_str(), nullptr, 10));
}

}  // namespace

Places::Places(const Image& image) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> list(std::tmpfile(), std::fclose);
  if (list == nullptr) return;
  for (const auto& [at, instruction] : image.instructions()) fmt::print(list.get(), "{:x}\n", at);
  if (std::fflush(list.get()) != 0 || std::fseek(list.get(), 0, SEEK_SET) != 0) return;
  constexpr int kHexadecimal = 16;
  std::vector<Frame>* frames = nullptr;
  bool is_function = true;
  const auto take = [&](std::string_view line) {
    if (line.starts_with("0x")) {
      frames = &frames_[static_cast<Address>(
          std::strtoul(std::string(line).c_str(), nullptr, kHexadecimal))];
      is_function = true;
      return;
    }
    if (frames == nullptr) return;
    if (is_function)
      frames->push_back({std::string(line), "", 0});
    else
      read_line(line, frames->back());
    is_function = !is_function;
  };
  for_each_line({image.prefix() + "addr2line", "-a", "-f", "-i", "-e", image.path()}, take,
                fileno(list.get()));
}

const std::vector<Frame>& Places::of(Address at) const {
  static const std::vector<Frame> kNowhere;
  const auto found = frames_.find(at);
  return found == frames_.end() ? kNowhere : found->second;
}

std::string Places::program() const {
  for (const auto& [at, frames] : frames_) {
    for (const Frame& frame : frames) {
      if (frame.file.ends_with(kProgramFile)) return frame.file;
    }
  }
  return {};
}

const std::string* Places::node(Address at, const ProgramMap& map) const {
  for (const Frame& frame : of(at)) {
    if (!frame.file.ends_with(kProgramFile)) continue;
    if (const std::string* node = map.node_of_line(frame.line)) return node;
  }
  return nullptr;
}

}  // namespace eagerx::gen::bound
