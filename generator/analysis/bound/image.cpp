#include "generator/analysis/bound/image.hpp"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string_view>

#include "generator/analysis/bound/instruction_text.hpp"
#include "generator/analysis/size/tools.hpp"

namespace eagerx::gen::bound {
namespace {

constexpr std::uint32_t kWord = 4;

/// Little-endian; 0 beyond the end.
std::uint32_t little(const std::string& bytes, std::size_t at, unsigned size) {
  constexpr unsigned kBitsOfByte = 8;
  std::uint32_t value = 0;
  if (at > bytes.size() || bytes.size() - at < size) return 0;
  for (unsigned i = 0; i < size; ++i)
    value |= std::uint32_t{static_cast<unsigned char>(bytes[at + i])} << (kBitsOfByte * i);
  return value;
}

std::optional<std::string> bytes_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) return std::nullopt;
  return std::string{std::istreambuf_iterator<char>(file), {}};
}

/// A table of an ELF file of 32 bits: System V ABI, "ELF Header".
struct ElfTable {
  std::uint32_t begin = 0, size = 0, count = 0;

  static ElfTable of(const std::string& file, std::size_t begin, std::size_t size) {
    return {little(file, begin, 4), little(file, size, 2), little(file, size + 2, 2)};
  }
};

}  // namespace

std::optional<Image> Image::read(const std::string& path, const std::string& prefix) {
  Image image;
  image.path_ = path;
  image.prefix_ = prefix;
  if (!image.read_segments() || !image.read_code() || !image.read_functions()) return std::nullopt;
  return image;
}

bool Image::read_segments() {
  const auto file = bytes_of(path_);
  constexpr std::size_t kHeader = 52;
  if (!file || file->size() < kHeader) return false;
  constexpr std::uint32_t kLoad = 1;
  constexpr std::uint32_t kWritable = 2;
  const auto table = ElfTable::of(*file, 28, 42);
  for (std::uint32_t i = 0; i < table.count; ++i) {
    const std::size_t at = table.begin + std::size_t{i} * table.size;
    const std::uint32_t offset = little(*file, at + 4, 4), bytes = little(*file, at + 16, 4);
    if (little(*file, at, 4) != kLoad || (little(*file, at + 24, 4) & kWritable) != 0) continue;
    if (offset > file->size() || file->size() - offset < bytes) return false;
    constants_.push_back({little(*file, at + 8, 4), file->substr(offset, bytes)});
  }
  read_notes(*file);
  return true;
}

void Image::read_notes(const std::string& file) {
  const auto table = ElfTable::of(file, 32, 46);
  const auto header = [&](std::uint32_t section) {
    return table.begin + std::size_t{section} * table.size;
  };
  const std::uint32_t names = little(file, header(little(file, 50, 2)) + 16, 4);
  constexpr std::string_view kName{".debug_eagerx_loops\0", 20};
  for (std::uint32_t i = 0; i < table.count; ++i) {
    const std::size_t at = header(i);
    const std::size_t name = names + std::size_t{little(file, at, 4)};
    if (name > file.size() || std::string_view(file).substr(name, kName.size()) != kName) continue;
    const std::uint32_t begin = little(file, at + 16, 4), bytes = little(file, at + 20, 4);
    for (std::uint32_t entry = 0; entry + 2 * kWord <= bytes; entry += 2 * kWord) {
      const std::uint32_t most = little(file, begin + entry + kWord, 4);
      notes_[little(file, begin + entry, 4) & ~1U] = {most, most == 0};
    }
  }
}

bool Image::read_code() {
  InstructionReader reader;
  std::map<Address, Instruction> code;
  for_each_line({prefix_ + "objdump", "-d", "--no-show-raw-insn", "-z", path_},
                [&](std::string_view line) {
                  if (auto instruction = reader.line(line)) {
                    const Address at = instruction->at;
                    code.insert_or_assign(at, std::move(*instruction));
                  } else if (const auto data = reader.data()) {
                    code.erase(*data);
                  }
                });
  code_.reserve(code.size());
  for (auto& [at, instruction] : code) {
    if (!code_.empty()) code_.back().next = std::min(at, code_.back().at + kWord);
    instruction.index = static_cast<std::uint32_t>(code_.size());
    instruction.next = at + 2;
    index_.emplace(at, instruction.index);
    code_.push_back(std::move(instruction));
  }
  return !code_.empty();
}

bool Image::read_functions() {
  constexpr int kHexadecimal = 16;
  for_each_line({prefix_ + "nm", "--defined-only", path_}, [&](std::string_view view) {
    const std::string line(view);
    const auto space = line.find(' ');
    if (space == std::string::npos || line.size() < space + 4) return;
    if (std::string_view("tTwW").find(line[space + 1]) == std::string_view::npos) return;
    const auto at = static_cast<Address>(std::strtoull(line.c_str(), nullptr, kHexadecimal)) & ~1U;
    const std::string name = line.substr(space + 3);
    if (name.starts_with("$") || name.starts_with(".L") || !index_.contains(at)) return;
    functions_.emplace(at, name);
    addresses_.emplace(name, at);
  });
  return !functions_.empty();
}

const Instruction* Image::instruction(Address at) const {
  const auto found = index_.find(at);
  return found == index_.end() ? nullptr : &code_[found->second];
}

std::optional<std::uint32_t> Image::constant(Address at, unsigned size) const {
  for (const Segment& segment : constants_) {
    if (at < segment.begin || at - segment.begin >= segment.bytes.size()) continue;
    if (segment.bytes.size() - (at - segment.begin) < size) return std::nullopt;
    return little(segment.bytes, at - segment.begin, size);
  }
  return std::nullopt;
}

std::string Image::function_of(Address at) const {
  auto found = functions_.upper_bound(at);
  return found == functions_.begin() ? std::string() : std::prev(found)->second;
}

}  // namespace eagerx::gen::bound
