#include "generator/size/tools.hpp"

#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <fstream>

namespace eagerx::gen {
namespace {

std::string quoted(const std::string& word) {
  std::string result = "'";
  for (const char c : word) result += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return result + "'";
}

}  // namespace

int for_each_line(const std::vector<std::string>& command,
                  const std::function<void(std::string_view)>& line) {
  std::string text;
  for (const auto& word : command) text += quoted(word) + " ";
  std::FILE* pipe = popen((text + "2>/dev/null").c_str(), "r");
  if (pipe == nullptr) return -1;
  std::string current;
  std::array<char, 1U << 16U> buffer{};
  while (std::fgets(buffer.data(), buffer.size(), pipe) != nullptr) {
    current += buffer.data();
    if (current.back() != '\n') continue;
    current.pop_back();
    line(current);
    current.clear();
  }
  if (!current.empty()) line(current);
  const int status = pclose(pipe);
  constexpr int kNotFound = 127;
  if (status == -1 || !WIFEXITED(status) || WEXITSTATUS(status) == kNotFound) return -1;
  return WEXITSTATUS(status);
}

std::optional<std::string> tool_prefix(const std::string& image) {
  constexpr std::size_t kMachine = 18;  // of the ELF header, little-endian
  std::array<char, 20> head{};
  std::ifstream file(image, std::ios::binary);
  if (!file.read(head.data(), head.size())) return std::nullopt;
  if (std::string_view(head.data(), 4) !=
      "\x7f"
      "ELF")
    return std::nullopt;
  const int machine = static_cast<unsigned char>(head[kMachine]) +
                      256 * static_cast<unsigned char>(head[kMachine + 1]);
  constexpr int kArm = 40;
  constexpr int kRiscv = 243;
  if (machine == kArm) return "arm-none-eabi-";
  if (machine == kRiscv) return "riscv64-unknown-elf-";
  return "";
}

}  // namespace eagerx::gen
