// Why a file is not usable, in words that can be shown.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace eagerx::gen {

/// Why a file is not a usable policy: a diagnostic without its place.
struct PolicyProblem {
  std::string code;
  std::string message;
  std::string help;
};

/// Sets `problem` and returns nothing, for `return refuse(...)`.
std::nullopt_t refuse(PolicyProblem& problem, const char* code, std::string message,
                      std::string help);

/// A name out of a file as it can be shown: ASCII, no control characters, not too long.
std::string printable(std::string_view name);

/// What helps against damaged files.
inline constexpr const char* kSaveAgain = "the file is damaged: save it again";
inline constexpr const char* kCutShort = "the file is damaged or truncated: save it again";
/// And against actors that are read by the names of their tensors, and are built in another way.
inline constexpr const char* kOtherActor =
    "the actor is not built as its names say: export it to ONNX, which says every step";

}  // namespace eagerx::gen
