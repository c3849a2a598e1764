// torch.save: a pickle whose tensors point into files next to it.
#include <fmt/core.h>

#include <map>

#include "generator/policy/formats/common/foreign.hpp"
#include "generator/policy/formats/tensors/containers.hpp"
#include "generator/policy/network/limits.hpp"

namespace eagerx::gen {
namespace {

using Kind = PickleValue::Kind;

constexpr std::string_view kPickleName = "data.pkl";
constexpr const char* kTorchHelp = "save it again with `torch.save`, or with Stable-Baselines3";
constexpr int kDeepestDictionary = 8;
constexpr std::size_t kMostVisits = 500'000;

class TorchReader {
 public:
  /// `archive`: nullptr for the format before torch 1.6.
  TorchReader(const Archive* archive, bool all, TensorTable& table, PolicyProblem& problem)
      : archive_(archive), all_(all), table_(table), problem_(problem) {}

  /// Five pickles (a magic number, a version, the machine, the object, names of its storages), then
  /// each storage: how many elements, and they.
  bool run_legacy(std::string_view bytes) {
    constexpr int kPickles = 5;
    constexpr int kMachine = 2;
    constexpr int kObject = 3;
    Pickle names;
    for (int i = 0; i < kPickles; ++i) {
      auto pickle = read_pickle(bytes, PickleNames::tensors, problem_);
      if (!pickle) return false;
      bytes.remove_prefix(pickle->end);
      if (i == kMachine) {
        const PickleValue* little = pickle->find(pickle->top(), "little_endian");
        if (little != nullptr && little->integer == 0) return fail("big-endian numbers");
      }
      if (i == kObject) pickle_ = std::move(*pickle);
      if (i == kPickles - 1) names = std::move(*pickle);
    }
    return find_legacy_storages(names, bytes) && add_state_dict();
  }

  bool run(const std::string& folder) {
    folder_ = folder;
    std::string& buffer = table_.buffers.emplace_back();
    const auto bytes = archive_->read(folder_ + std::string(kPickleName), buffer, problem_);
    if (!bytes || !check_byte_order()) return false;
    auto pickle = read_pickle(*bytes, PickleNames::tensors, problem_);
    if (!pickle) return false;
    pickle_ = std::move(*pickle);
    return add_state_dict();
  }

 private:
  bool add_state_dict() {
    const PickleValue* dictionary = &pickle_.top();
    // CleanRL saves the state dicts of actor and critics as a tuple.
    if (dictionary->kind == Kind::sequence && !dictionary->items.empty()) {
      dictionary = &pickle_.at(dictionary->items.front());
    }
    const PickleValue& top = *dictionary;
    if (all_) return add_all(top, "", 0);
    // safe-control-gym's agents hold their network and their optimizers.
    const PickleValue* agent = pickle_.find(top, "agent");
    if (agent != nullptr && pickle_.find(*agent, "ac") != nullptr) {
      dictionary = pickle_.find(*agent, "ac");
    }
    for (const char* key :
         {"actor_state_dict", "model_state_dict", "state_dict", "model", "policy"}) {
      if (dictionary != &top) break;
      const PickleValue* inner = pickle_.find(*dictionary, key);
      if (inner == nullptr || pickle_.made_by(*inner, "torch._utils._rebuild_tensor_v2")) continue;
      dictionary = inner;
      break;
    }
    if (dictionary == &top) return add_all(top, "", 0);
    for (const char* key : {"obs_norm_state_dict", "state_preprocessor", "observation_preprocessor",
                            "obs_normalizer", "running_mean_std"}) {
      const PickleValue* statistics = pickle_.find(top, key);
      // rl_games has its statistics in the model since 1.2, and next to it in older versions.
      if (pickle_.find(*dictionary, std::string(key) + ".running_mean") != nullptr) continue;
      if (statistics != nullptr && !add_all(*statistics, std::string(key) + ".", 1)) return false;
    }
    return add_all(*dictionary, "", 0);
  }

  /// Where each storage lies in `bytes`, in the order of `names`.
  bool find_legacy_storages(const Pickle& names, std::string_view bytes) {
    constexpr std::size_t kCount = 8;  // bytes of a number of elements
    std::map<std::string_view, ElementType> types;
    for (const PickleValue& value : pickle_.values) {
      if (value.kind != Kind::persistent) continue;
      const std::vector<std::uint32_t>& storage = pickle_.at(value.function).items;
      if (storage.size() < 3) continue;
      const auto type = torch_storage_type(pickle_.at(storage[1]).text);
      if (type) types[pickle_.at(storage[2]).text] = *type;
    }
    for (const std::uint32_t index : names.top().items) {
      const std::string_view name = names.at(index).text;
      const auto type = types.find(name);
      if (type == types.end()) return fail("a storage that no tensor is in");
      if (bytes.size() < kCount) return cut_short();
      const std::uint64_t count = little_endian(bytes, kCount);
      bytes.remove_prefix(kCount);
      if (count > bytes.size() / size_of(type->second)) return cut_short();
      const std::size_t size = static_cast<std::size_t>(count) * size_of(type->second);
      storages_.emplace(fmt::format("data/{}", name), bytes.substr(0, size));
      bytes.remove_prefix(size);
    }
    return true;
  }
  bool cut_short() { return refuse(problem_, "E0623", "ends before its tensors do", kCutShort); }

  Refused fail(const std::string& how) {
    return refuse(problem_, "E0623", fmt::format("has {}", how), kTorchHelp);
  }

  bool check_byte_order() {
    const std::string name = folder_ + "byteorder";
    if (!archive_->has(name)) return true;
    std::string buffer;
    const auto order = archive_->read(name, buffer, problem_);
    if (!order) return false;
    return *order == "little" || fail("big-endian numbers");
  }

  bool add_all(const PickleValue& dictionary, const std::string& prefix, int depth) {
    if (depth > kDeepestDictionary) return fail("dictionaries nested too deeply");
    for (std::size_t i = 0; i + 1 < dictionary.items.size(); i += 2) {
      // The same dictionary may be in many, and they in many more.
      if (++visited_ > kMostVisits) return fail("too many dictionaries");
      const PickleValue& key = pickle_.at(dictionary.items[i]);
      const PickleValue* item = &pickle_.at(dictionary.items[i + 1]);
      if (key.kind != Kind::text) continue;
      if (key.text.size() > kLongestPickledName) return fail("a name of impossible length");
      const std::string name = prefix + std::string(key.text);
      if (pickle_.made_by(*item, "torch._utils._rebuild_parameter")) {
        const PickleValue& arguments = pickle_.at(item->arguments);
        if (arguments.items.empty()) return fail("a damaged parameter");
        item = &pickle_.at(arguments.items.front());
      }
      if (pickle_.made_by(*item, "torch._utils._rebuild_tensor_v2")) {
        if (!add_tensor(name, *item)) return false;
      } else if (item->kind == Kind::object &&
                 pickle_.at(item->function).text.ends_with("multiarray._reconstruct")) {
        auto array = pickle_.array(item);
        // Statistics that cannot be read must not be left out.
        if (!array && !all_) {
          return fail(fmt::format("a NumPy array `{}` that cannot be read", printable(name)));
        }
        if (array && !add_array(name, std::move(*array))) return false;
      } else if (item->kind == Kind::dictionary ||
                 pickle_.made_by(*item, "collections.OrderedDict")) {
        if (!add_all(*item, name + ".", depth + 1)) return false;
      }
    }
    return true;
  }

  /// Its bytes may lie in the pickle, which is gone before the table.
  bool add_array(const std::string& name, StoredTensor array) {
    unpacked_ += array.bytes.size();  // the same array may be there under many names
    if (unpacked_ > kMaxPolicyBytes) return fail("more NumPy arrays than the 64 MB that are read");
    array.bytes = table_.buffers.emplace_back(array.bytes);
    return table_.add(name, std::move(array), problem_);
  }

  bool add_tensor(const std::string& name, const PickleValue& call) {
    auto tensor = rebuilt_tensor(
        pickle_, call, name, [this](std::string_view key) { return storage_bytes(key); }, problem_);
    return tensor && table_.add(name, std::move(*tensor), problem_);
  }

  std::optional<std::string_view> storage_bytes(std::string_view key) {
    const std::string name = fmt::format("{}data/{}", folder_, key);
    if (const auto known = storages_.find(name); known != storages_.end()) return known->second;
    if (archive_ == nullptr) {
      return fail(fmt::format("a tensor in a storage `{}` that is not there", printable(key)));
    }
    const auto bytes = archive_->read(name, table_.buffers.emplace_back(), problem_);
    if (bytes) storages_.emplace(name, *bytes);
    const std::size_t more = table_.buffers.back().size();
    return count_unpacked(more, unpacked_, kTorchHelp, problem_) ? bytes : std::nullopt;
  }

  const Archive* archive_;
  bool all_;  // not only what is known to be the actor
  TensorTable& table_;
  PolicyProblem& problem_;
  Pickle pickle_;
  std::string folder_;
  std::map<std::string, std::string_view> storages_;
  std::size_t unpacked_ = 0;
  std::size_t visited_ = 0;
};

}  // namespace

/// _rebuild_tensor_v2(storage, offset, shape, strides, needs gradient, hooks)
std::optional<StoredTensor> rebuilt_tensor(const Pickle& pickle, const PickleValue& call,
                                           const std::string& name, const TorchStorages& storages,
                                           PolicyProblem& problem) {
  const auto damaged = [&] {
    return refuse(problem, "E0623", fmt::format("has a damaged tensor `{}`", printable(name)),
                  kTorchHelp);
  };
  const std::vector<std::uint32_t>& arguments = pickle.at(call.arguments).items;
  if (arguments.size() < 4) return damaged();
  const PickleValue& reference = pickle.at(arguments[0]);
  const auto shape = pickle.integers(&pickle.at(arguments[2]));
  const auto strides = pickle.integers(&pickle.at(arguments[3]));
  const std::int64_t offset = pickle.at(arguments[1]).integer;
  if (reference.kind != Kind::persistent || !shape || !strides || offset < 0 ||
      offset > kMaxElements || strides->size() != shape->size()) {
    return damaged();
  }
  // ('storage', class, key, where it was, number of elements)
  const std::vector<std::uint32_t>& storage = pickle.at(reference.function).items;
  if (storage.size() < 5) return damaged();
  const auto type = torch_storage_type(pickle.at(storage[1]).text);
  if (!type) return damaged();
  const auto bytes = storages(pickle.at(storage[2]).text);
  if (!bytes) return std::nullopt;
  const std::size_t start = static_cast<std::size_t>(offset) * size_of(*type);
  const auto said = static_cast<std::uint64_t>(pickle.at(storage[4]).integer);
  if (said != bytes->size() / size_of(*type)) {
    return refuse(problem, "E0614",
                  fmt::format("says that the storage of tensor `{}` has {} values, but it holds {}",
                              printable(name), said, bytes->size() / size_of(*type)),
                  kTorchHelp);
  }
  return StoredTensor{*type, *shape, *strides, bytes->substr(std::min(start, bytes->size()))};
}

bool read_torch(const Archive& archive, bool all, TensorTable& table, PolicyProblem& problem) {
  for (const std::string& name : archive.names()) {
    if (name != kPickleName && !name.ends_with("/data.pkl")) continue;
    return TorchReader(&archive, all, table, problem)
        .run(name.substr(0, name.size() - kPickleName.size()));
  }
  problem = foreign_archive(archive.names());
  return false;
}

bool is_legacy_torch(std::string_view bytes) {
  using namespace std::string_view_literals;
  return bytes.starts_with("\x80\x02\x8a\x0a\x6c\xfc\x9c\x46\xf9\x20\x6a\xa8\x50\x19."sv);
}

bool read_legacy_torch(std::string_view bytes, bool all, TensorTable& table,
                       PolicyProblem& problem) {
  return TorchReader(nullptr, all, table, problem).run_legacy(bytes);
}

}  // namespace eagerx::gen
