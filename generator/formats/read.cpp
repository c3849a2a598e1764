// From a path to bytes to the reader of the format.
#include "generator/formats/read.hpp"

#include <fmt/core.h>

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <string>
#include <system_error>

namespace eagerx::gen {
namespace {

constexpr std::size_t kMaxShownName = 80;
constexpr const char* kHelp =
    "known are Stable-Baselines3's zip, ONNX, safetensors, npz and torch.save";

bool is_safetensors(std::string_view bytes) {
  constexpr std::size_t kLength = 8;
  return bytes.size() > kLength && bytes[kLength] == '{' && bytes[kLength - 1] == '\0';
}

/// What `bytes` are by their first few, or empty when only a parser can tell.
std::string_view known_other_format(std::string_view bytes) {
  if (bytes.starts_with("version https://git-lfs")) {
    return "a Git LFS pointer, not the file itself: run `git lfs pull`";
  }
  if (bytes.starts_with("\x93NUMPY")) return "one NumPy array, not an archive of them (npz)";
  if (bytes.starts_with("\x89HDF")) return "an HDF5 file";
  if (bytes.starts_with("\x80\x02") || bytes.starts_with("\x80\x04") ||
      bytes.starts_with("\x80\x05")) {
    return "a Python pickle without tensors' files (torch before 1.6, or VecNormalize's "
           "statistics, which are named as `normalize`)";
  }
  constexpr char kFirstLetter = ' ';
  if (bytes.front() >= kFirstLetter) return "a text file";  // no format starts like this
  return {};
}

std::optional<Network> read_any(std::string_view bytes, const ReadContext& context,
                                PolicyProblem& problem) {
  if (bytes.empty()) return refuse(problem, "E0603", "is empty", kHelp);
  if (bytes.starts_with("PK\x03\x04")) return read_zip_policy(bytes, context, problem);
  if (is_safetensors(bytes)) return read_safetensors(bytes, context, problem);
  if (const std::string_view other = known_other_format(bytes); !other.empty()) {
    return refuse(problem, "E0603", fmt::format("is {}", other), kHelp);
  }
  return read_onnx(bytes, problem);
}

void report(const PolicyProblem& problem, const char* what, const std::string& name, Span mention,
            Diagnostics& diagnostics) {
  diagnostics.error(problem.code, mention, fmt::format("{} `{}` {}", what, name, problem.message))
      .help = problem.help;
}

/// "`angle` (2), `speed` (1)"
std::string listed(const std::vector<NamedPart>& parts) {
  std::string text;
  for (const NamedPart& part : parts) {
    text += fmt::format("{}`{}` ({})", text.empty() ? "" : ", ", printable(part.name), part.size);
  }
  return text;
}

/// True also if one of them does not say.
bool same_order(const std::vector<NamedPart>& a, const std::vector<NamedPart>& b) {
  return a.empty() || b.empty() ||
         std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const NamedPart& x, const NamedPart& y) { return x.name == y.name; });
}

/// Adds the statistics that the graph names. False if they cannot be read or do not fit.
bool add_normalization(const PolicyRequest& request, Network& network, Diagnostics& diagnostics) {
  const auto bytes = read_bytes(request.normalize_path, request.normalize_name,
                                request.normalize_span, "statistics", diagnostics);
  if (!bytes) return false;
  PolicyProblem problem;
  auto statistics = read_statistics(*bytes, problem);
  if (statistics && statistics->mean.size() != network.inputs()) {
    problem = {"E0627",
               fmt::format("normalise {} numbers, but the policy `{}` takes {}",
                           statistics->mean.size(), request.name, network.inputs()),
               "name the statistics that were saved with this policy"};
    statistics.reset();
  }
  if (statistics && !same_order(statistics->parts, network.contract.observations)) {
    problem = {"E0627",
               fmt::format("are of {}, but the policy `{}` takes {}", listed(statistics->parts),
                           request.name, listed(network.contract.observations)),
               "save them with all parts of the observation, in the order of its space"};
    statistics.reset();
  }
  if (statistics && network.normalization &&
      (network.normalization->mean != statistics->mean ||
       network.normalization->variance != statistics->variance)) {
    problem = {"E0631",
               fmt::format("differ from those that the policy `{}` holds itself", request.name),
               "leave `normalize` out, or name the file that belongs to the policy"};
    statistics.reset();
  }
  if (!statistics) {
    report(problem, "statistics", request.normalize_name, request.normalize_span, diagnostics);
    return false;
  }
  network.normalization = std::move(statistics);
  network.normalization->source = request.normalize_name;
  return true;
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
                                         Span mention, Diagnostics& diagnostics,
                                         const ReadContext& context) {
  PolicyProblem problem;
  std::optional<Network> network = read_any(bytes, context, problem);
  if (!network) {
    report(problem, "policy", name, mention, diagnostics);
    return std::nullopt;
  }
  network->file = name;
  if (network->normalization) network->normalization->source = name;
  return network;
}

std::optional<std::string> read_bytes(const std::string& path, const std::string& name,
                                      Span mention, const char* what, Diagnostics& diagnostics) {
  const auto unreadable = [&](const std::string& why) {
    diagnostics.io_error("E0601", mention, fmt::format("cannot read {} `{}`: {}", what, name, why));
    return std::nullopt;
  };
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status)) return unreadable("no such file");
  if (!std::filesystem::is_regular_file(status)) return unreadable("not a regular file");
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  if (error) return unreadable(error.message());
  if (size > kMaxPolicyBytes) {
    diagnostics.error("E0602", mention,
                      fmt::format("{} `{}` has {} bytes; at most {} are read", what, name, size,
                                  kMaxPolicyBytes));
    return std::nullopt;
  }
  std::ifstream file(path, std::ios::binary);
  if (!file) return unreadable(std::error_code(errno, std::generic_category()).message());
  std::string bytes(static_cast<std::size_t>(size), '\0');
  file.read(bytes.data(), static_cast<std::streamsize>(size));
  if (!file) return unreadable("the file ended early");
  return bytes;
}

std::optional<Network> read_policy(const PolicyRequest& request, Diagnostics& diagnostics) {
  const auto bytes = read_bytes(request.path, request.name, request.span, "policy", diagnostics);
  if (!bytes) return std::nullopt;
  auto network = read_policy_bytes(*bytes, request.name, request.span, diagnostics,
                                   ReadContext{request.activation});
  if (!network) return std::nullopt;
  if (!request.normalize_path.empty() && !add_normalization(request, *network, diagnostics)) {
    return std::nullopt;
  }
  return network;
}

std::optional<Network> read_policy(const std::string& path, const std::string& name, Span mention,
                                   Diagnostics& diagnostics) {
  PolicyRequest request;
  request.path = path;
  request.name = name;
  request.span = mention;
  return read_policy(request, diagnostics);
}

}  // namespace eagerx::gen
