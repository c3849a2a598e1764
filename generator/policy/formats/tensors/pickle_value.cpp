// Values of a pickle, and the names that may make them.
#include <algorithm>
#include <array>

#include "generator/policy/formats/tensors/pickle.hpp"

namespace eagerx::gen {
namespace {

using Kind = PickleValue::Kind;
using Index = std::uint32_t;

/// NumPy's type behind `dtype('f4', False, True)` with state `(3, '<', …)`.
std::optional<ElementType> numpy_dtype_of(const Pickle& pickle, const PickleValue& dtype) {
  if (!pickle.made_by(dtype, "numpy.dtype")) return std::nullopt;
  const PickleValue& arguments = pickle.at(dtype.arguments);
  if (arguments.items.empty()) return std::nullopt;
  const PickleValue& state = pickle.at(dtype.state);
  if (state.items.size() > 1 && pickle.at(state.items[1]).text == ">") return std::nullopt;
  return numpy_type(pickle.at(arguments.items[0]).text);
}

/// And the classes of torch's storages.
constexpr std::array kTensorNames = {
    "collections.OrderedDict",
    "torch._utils._rebuild_tensor_v2",
    "torch._utils._rebuild_parameter",
    "torch.Size",
    "torch.device",
    "collections.defaultdict",
    "numpy.dtype",
    "numpy.ndarray",
    "numpy.core.multiarray._reconstruct",
    "numpy.core.multiarray.scalar",
    "numpy._core.multiarray._reconstruct",
    "numpy._core.multiarray.scalar",
    "_codecs.encode",
};

constexpr std::array kStatisticsNames = {
    "stable_baselines3.common.vec_env.vec_normalize.VecNormalize",
    "stable_baselines3.common.running_mean_std.RunningMeanStd",
    "numpy.dtype",
    "numpy.ndarray",
    "numpy.core.multiarray._reconstruct",
    "numpy.core.multiarray.scalar",
    "numpy.core.numeric._frombuffer",
    "numpy._core.multiarray._reconstruct",
    "numpy._core.multiarray.scalar",
    "numpy._core.numeric._frombuffer",
    "numpy.random._pickle.__generator_ctor",
    "numpy.random._pickle.__bit_generator_ctor",
    "numpy.random._pickle.__randomstate_ctor",
    "numpy.random._pcg64.PCG64",
    "numpy.random._mt19937.MT19937",
    "numpy.random.bit_generator.__pyx_unpickle_SeedSequence",
    "numpy.random.bit_generator.SeedSequence",
    "gymnasium.spaces.box.Box",
    "gymnasium.spaces.dict.Dict",
    "gymnasium.spaces.discrete.Discrete",
    "gymnasium.spaces.multi_discrete.MultiDiscrete",
    "gymnasium.spaces.multi_binary.MultiBinary",
    "gym.spaces.box.Box",
    "gym.spaces.dict.Dict",
    "gym.spaces.discrete.Discrete",
    "gym.spaces.multi_discrete.MultiDiscrete",
    "gym.spaces.multi_binary.MultiBinary",
    "collections.OrderedDict",
    "collections.deque",
    "builtins.set",
    "__builtin__.set",
    "_codecs.encode",
};

constexpr std::array kProgramNames = {
    "torch.jit._pickle.restore_type_tag", "torch.jit._pickle.build_tensorlist",
    "torch.jit._pickle.build_intlist",    "torch.jit._pickle.build_doublelist",
    "torch.jit._pickle.build_boollist",
};

}  // namespace

bool is_known_in_pickles(std::string_view name, PickleNames known) {
  const auto among = [&](const auto& names) {
    return std::find(names.begin(), names.end(), name) != names.end();
  };
  if (known == PickleNames::statistics) return among(kStatisticsNames);
  if (known == PickleNames::program && (name.starts_with("__torch__.") || among(kProgramNames))) {
    return true;
  }
  return among(kTensorNames) || torch_storage_type(name).has_value();
}

const PickleValue* Pickle::dictionary_of(const PickleValue& in) const {
  const PickleValue* where = &in;
  // The state of an object may be (dictionary, slots).
  if (in.kind == Kind::object && in.items.empty()) where = &at(in.state);
  if (where->kind == Kind::sequence && !where->items.empty()) where = &at(where->items.front());
  return where->kind == Kind::dictionary || where->kind == Kind::object ? where : nullptr;
}

const PickleValue* Pickle::find(const PickleValue& in, std::string_view key) const {
  const PickleValue* where = dictionary_of(in);
  if (where == nullptr) return nullptr;
  for (std::size_t i = 0; i + 1 < where->items.size(); i += 2) {
    const PickleValue& name = at(where->items[i]);
    if (name.kind == Kind::text && name.text == key) return &at(where->items[i + 1]);
  }
  return nullptr;
}

bool Pickle::made_by(const PickleValue& value, std::string_view name) const {
  return value.kind == Kind::object && at(value.function).text == name;
}

std::optional<double> Pickle::number(const PickleValue* value) const {
  if (value == nullptr) return std::nullopt;
  if (value->kind == Kind::real) return value->real;
  if (value->kind == Kind::integer) return static_cast<double>(value->integer);
  const auto scalar = array(value);
  if (!scalar || element_count(scalar->shape) != 1) return std::nullopt;
  return values_of(*scalar).front();
}

std::optional<std::vector<std::int64_t>> Pickle::integers(const PickleValue* value) const {
  constexpr std::size_t kMostDimensions = 64;  // NumPy's; one shape may be named often
  if (value == nullptr || value->kind != Kind::sequence || value->items.size() > kMostDimensions) {
    return std::nullopt;
  }
  std::vector<std::int64_t> result;
  for (const Index item : value->items) {
    if (at(item).kind != Kind::integer) return std::nullopt;
    result.push_back(at(item).integer);
  }
  return result;
}

std::optional<StoredTensor> Pickle::array(const PickleValue* value) const {
  if (value == nullptr || value->kind != Kind::object) return std::nullopt;
  const std::string_view function = at(value->function).text;
  const std::vector<Index>& arguments = at(value->arguments).items;
  const std::vector<Index>& state = at(value->state).items;
  StoredTensor tensor;
  std::optional<ElementType> type;
  std::optional<std::vector<std::int64_t>> shape;
  if (function.ends_with("multiarray._reconstruct") && state.size() == 5) {
    // (version, shape, dtype, is Fortran order, bytes)
    shape = integers(&at(state[1]));
    type = numpy_dtype_of(*this, at(state[2]));
    if (at(state[3]).integer != 0 && shape && shape->size() > 1) return std::nullopt;
    tensor.bytes = at(state[4]).text;
  } else if (function.ends_with("numeric._frombuffer") && arguments.size() == 4) {
    // (bytes, dtype, shape, order)
    tensor.bytes = at(arguments[0]).text;
    type = numpy_dtype_of(*this, at(arguments[1]));
    shape = integers(&at(arguments[2]));
    if (at(arguments[3]).text == "F" && shape && shape->size() > 1) return std::nullopt;
  } else if (function.ends_with("multiarray.scalar") && arguments.size() == 2) {
    type = numpy_dtype_of(*this, at(arguments[0]));
    tensor.bytes = at(arguments[1]).text;
    shape.emplace();
  }
  if (!type || !shape) return std::nullopt;
  tensor.type = *type;
  tensor.shape = *shape;
  PolicyProblem ignored;
  if (!fits("", tensor, ignored)) return std::nullopt;
  return tensor;
}

}  // namespace eagerx::gen
