#include "generator/analysis/size/tools.hpp"

#include <array>
#include <fstream>

#include "generator/support/process/process.hpp"

namespace eagerx::gen {

int for_each_line(const std::vector<std::string>& command,
                  const std::function<void(std::string_view)>& line, int input) {
  const auto result = run_process(command, {.input = input, .line = line});
  return result ? result->exit_code : -1;
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
