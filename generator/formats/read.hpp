// One reader a file format; read_policy() picks one by content. Inside policy/ only.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "generator/diagnostics/diagnostics.hpp"
#include "generator/network/network.hpp"

namespace eagerx::gen {

/// The largest policy file that is read. A 1024-1024-512 network has 6 MB.
inline constexpr std::size_t kMaxPolicyBytes = std::size_t{64} << 20U;

/// Why a file is not a usable policy: a diagnostic without its place.
struct PolicyProblem {
  std::string code;
  std::string message;
  std::string help;
};

/// Sets `problem` and returns nothing, for `return refuse(...)`.
inline std::nullopt_t refuse(PolicyProblem& problem, const char* code, std::string message,
                             std::string help) {
  problem = {code, std::move(message), std::move(help)};
  return std::nullopt;
}

struct TensorTable;

/// What a reader may need besides the bytes.
struct ReadContext {
  std::optional<Activation> activation;  // of hidden layers, as the graph says
};

/// The policy in `bytes`, whatever its format. `name` is the file as the user wrote it. Adds
/// exactly one error at `mention` if there is none.
std::optional<Network> read_policy_bytes(std::string_view bytes, const std::string& name,
                                         Span mention, Diagnostics& diagnostics,
                                         const ReadContext& context = {});

/// The actor in the bytes of an ONNX file, `file` left empty; or why there is none.
std::optional<Network> read_onnx(std::string_view bytes, PolicyProblem& problem);

/// The same of a safetensors file, and of a zip archive (Stable-Baselines3, torch.save, npz).
std::optional<Network> read_safetensors(std::string_view bytes, const ReadContext& context,
                                        PolicyProblem& problem);
std::optional<Network> read_zip_policy(std::string_view bytes, const ReadContext& context,
                                       PolicyProblem& problem);

/// Statistics of observations: a pickle of VecNormalize, an npz or a JSON file. E0627 and those of
/// the format.
std::optional<Normalization> read_statistics(std::string_view bytes, PolicyProblem& problem);

/// A name out of a file as it can be shown: ASCII, no control characters, not too long.
std::string printable(std::string_view name);

/// The bytes of a file. `what` is for messages ("policy", "statistics"). E0601, E0602.
std::optional<std::string> read_bytes(const std::string& path, const std::string& name,
                                      Span mention, const char* what, Diagnostics& diagnostics);

}  // namespace eagerx::gen
