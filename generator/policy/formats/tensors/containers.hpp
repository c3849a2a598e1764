// Files that contain only named tensors: npz, torch.save, safetensors.
#pragma once

#include <functional>
#include <optional>
#include <string_view>

#include "generator/policy/formats/tensors/archive.hpp"
#include "generator/policy/formats/tensors/pickle.hpp"
#include "generator/policy/formats/tensors/tensor.hpp"

namespace eagerx::gen {

/// The arrays of an npz archive, by name without `.npy`. E0621, E0630.
bool read_npz(const Archive& archive, TensorTable& table, PolicyProblem& problem);

/// One array of NumPy's format. E0630.
std::optional<StoredTensor> read_npy(std::string_view bytes, const std::string& name,
                                     PolicyProblem& problem);

/// The tensors of a torch.save archive: a state dict, or a dictionary that holds one under
/// `model_state_dict`, `state_dict`, `model` or `policy`; with `all` everything that it holds.
/// Views into `archive`. E0621 to E0623.
bool read_torch(const Archive& archive, bool all, TensorTable& table, PolicyProblem& problem);

/// The bytes of the storage named `key`; nullopt and a problem if it does not exist.
using TorchStorages = std::function<std::optional<std::string_view>(std::string_view key)>;

/// The tensor of a call of `torch._utils._rebuild_tensor_v2`; its place in the bytes is not checked
/// yet. E0614, E0623.
std::optional<StoredTensor> rebuilt_tensor(const Pickle& pickle, const PickleValue& call,
                                           const std::string& name, const TorchStorages& storages,
                                           PolicyProblem& problem);

/// Whether `bytes` are a file of torch.save before 1.6, or one written with
/// `_use_new_zipfile_serialization=False`: pickles, then the storages of their tensors.
bool is_legacy_torch(std::string_view bytes);

/// The same of such a file. Views into `bytes`.
bool read_legacy_torch(std::string_view bytes, bool all, TensorTable& table,
                       PolicyProblem& problem);

/// Tensors and metadata of a safetensors file. E0604, E0614.
bool read_safetensors_table(std::string_view bytes, TensorTable& table, PolicyProblem& problem);

}  // namespace eagerx::gen
