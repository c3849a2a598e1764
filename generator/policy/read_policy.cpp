// From a path to bytes to the reader of the format.
#include <fmt/core.h>

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <string>
#include <system_error>

#include "generator/policy/formats.hpp"

namespace eagerx::gen {
namespace {

constexpr std::size_t kMaxShownName = 80;

/// What `bytes` are by their first few, or empty when only a parser can tell.
std::string_view known_other_format(std::string_view bytes) {
  constexpr std::string_view kZip = "PK\x03\x04";
  constexpr std::string_view kNumpy = "\x93NUMPY";
  constexpr std::string_view kHdf5 = "\x89HDF";
  constexpr std::size_t kSafetensorsHeader = 8;
  if (bytes.starts_with(kZip)) return "a zip archive (Stable-Baselines3, PyTorch or npz)";
  if (bytes.starts_with(kNumpy)) return "a NumPy array";
  if (bytes.starts_with(kHdf5)) return "an HDF5 file";
  if (bytes.starts_with("\x80\x02") || bytes.starts_with("\x80\x04")) return "a Python pickle";
  if (bytes.size() > kSafetensorsHeader && bytes[kSafetensorsHeader] == '{' &&
      bytes[kSafetensorsHeader - 1] == '\0') {
    return "a safetensors file";
  }
  return {};
}

std::optional<Network> read_any(std::string_view bytes, PolicyProblem& problem) {
  constexpr const char* kHelp = "export the actor with `torch.onnx.export`";
  if (bytes.empty()) {
    problem = {"E0603", "is empty", kHelp};
    return std::nullopt;
  }
  if (const std::string_view other = known_other_format(bytes); !other.empty()) {
    problem = {"E0603", fmt::format("is {}, not an ONNX file", other), kHelp};
    return std::nullopt;
  }
  return read_onnx(bytes, problem);
}

}  // namespace

std::string printable(std::string_view name) {
  constexpr char kFirst = ' ';
  constexpr char kLast = '~';
  std::string shown;
  for (const char c : name.substr(0, kMaxShownName)) {
    shown += c >= kFirst && c <= kLast && c != '`' ? c : '?';
  }
  if (name.size() > kMaxShownName) shown += "...";
  return shown;
}

std::optional<Network> read_policy_bytes(std::string_view bytes, const std::string& name,
                                         Span mention, Diagnostics& diagnostics) {
  PolicyProblem problem;
  std::optional<Network> network = read_any(bytes, problem);
  if (network) {
    network->file = name;
    return network;
  }
  diagnostics.error(problem.code, mention, fmt::format("policy `{}` {}", name, problem.message))
      .help = problem.help;
  return std::nullopt;
}

std::optional<Network> read_policy(const std::string& path, const std::string& name, Span mention,
                                   Diagnostics& diagnostics) {
  const auto unreadable = [&](const std::string& why) {
    diagnostics.io_error("E0601", mention, fmt::format("cannot read policy `{}`: {}", name, why));
    return std::nullopt;
  };
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status)) return unreadable("no such file");
  if (!std::filesystem::is_regular_file(status)) return unreadable("not a regular file");
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  if (error) return unreadable(error.message());
  if (size > kMaxPolicyBytes) {
    diagnostics.error(
        "E0602", mention,
        fmt::format("policy `{}` has {} bytes; at most {} are read", name, size, kMaxPolicyBytes));
    return std::nullopt;
  }
  std::ifstream file(path, std::ios::binary);
  if (!file) return unreadable(std::error_code(errno, std::generic_category()).message());
  std::string bytes(static_cast<std::size_t>(size), '\0');
  file.read(bytes.data(), static_cast<std::streamsize>(size));
  if (!file) return unreadable("the file ended early");
  return read_policy_bytes(bytes, name, mention, diagnostics);
}

}  // namespace eagerx::gen
