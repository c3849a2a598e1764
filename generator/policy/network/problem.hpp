// The reason why a file cannot be used, as text for users.
#pragma once

#include <concepts>
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

/// The result of `return refuse(...)`: false, nothing, or no pointer, as the function has it.
struct Refused {
  // NOLINTBEGIN(google-explicit-constructor): that is what it is for
  template <std::same_as<bool> Bool>
  operator Bool() const {
    return false;
  }
  template <class T>
  operator std::optional<T>() const {
    return std::nullopt;
  }
  template <class T>
  operator T*() const {
    return nullptr;
  }
  // NOLINTEND(google-explicit-constructor)
};

/// Sets `problem`.
Refused refuse(PolicyProblem& problem, std::string code, std::string message, std::string help);

/// A name out of a file as it can be shown: ASCII, no control characters, not too long.
std::string printable(std::string_view name);

/// The help for damaged files.
inline constexpr const char* kSaveAgain = "the file is damaged: save it again";
inline constexpr const char* kCutShort = "the file is damaged or truncated: save it again";
/// And against actors that are read by the names of their tensors, and are built in another way.
inline constexpr const char* kOtherActor =
    "the actor is not built as its names say: export it to ONNX, which says every step";

}  // namespace eagerx::gen
