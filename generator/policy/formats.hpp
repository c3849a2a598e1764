// One reader a file format; read_policy() picks one by content. Inside policy/ only.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "generator/diagnostics/diagnostics.hpp"
#include "generator/policy/network.hpp"

namespace eagerx::gen {

/// The largest policy file that is read. A 1024-1024-512 network has 6 MB.
inline constexpr std::size_t kMaxPolicyBytes = std::size_t{64} << 20U;

/// Why a file is not a usable policy: a diagnostic without its place.
struct PolicyProblem {
  std::string code;
  std::string message;
  std::string help;
};

/// The policy in `bytes`, whatever its format. `name` is the file as the user wrote it. Adds
/// exactly one error at `mention` if there is none.
std::optional<Network> read_policy_bytes(std::string_view bytes, const std::string& name,
                                         Span mention, Diagnostics& diagnostics);

/// The actor in the bytes of an ONNX file, `file` left empty; or why there is none.
std::optional<Network> read_onnx(std::string_view bytes, PolicyProblem& problem);

/// A name out of a file as it can be shown: ASCII, no control characters, not too long.
std::string printable(std::string_view name);

}  // namespace eagerx::gen
