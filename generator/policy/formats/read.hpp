// Reads networks from weight files of every format.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "generator/policy/formats/common/read_context.hpp"
#include "generator/policy/network/network.hpp"
#include "generator/support/diagnostics/diagnostics.hpp"

namespace eagerx::gen {

/// The settings of a policy in the graph or on the command line.
struct PolicyRequest {
  std::string path, name;                      // where it is, and as the user wrote it
  Span span;                                   // where the graph names it
  std::string normalize_path, normalize_name;  // statistics; empty: those in the file, if any
  Span normalize_span;
  ReadContext context;  // for files that do not say it
};

/// Reads a policy: ONNX, safetensors, npz, Stable-Baselines3 zip, torch.save; and its statistics:
/// VecNormalize.save, npz, JSON. Reports exactly one error (E06xx) if it cannot be read.
std::optional<Network> read_policy(const PolicyRequest& request, Diagnostics& diagnostics);

/// The same with nothing but a file; `mention` is where the graph names it.
std::optional<Network> read_policy(const std::string& path, const std::string& name, Span mention,
                                   Diagnostics& diagnostics);

/// The policy in `bytes`, in any format. `name` is the file as the user wrote it. Adds exactly one
/// error at `mention` if it cannot be read.
std::optional<Network> read_policy_bytes(std::string_view bytes, const std::string& name,
                                         Span mention, Diagnostics& diagnostics,
                                         const ReadContext& context = {});

}  // namespace eagerx::gen
