// Contents of a TorchScript archive: modules with their tensors, constants and code.
#pragma once

#include <deque>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "generator/policy/formats/tensors/archive.hpp"
#include "generator/policy/formats/tensors/containers.hpp"
#include "generator/policy/formats/tensors/pickle.hpp"
#include "generator/policy/formats/torchscript/syntax.hpp"
#include "generator/policy/network/graph/operators.hpp"

namespace eagerx::gen {

class TorchArchive {
 public:
  TorchArchive(const Archive& archive, std::string folder)
      : archive_(archive), folder_(std::move(folder)) {}

  /// Reads the description of the modules. E0621 to E0623.
  bool open(PolicyProblem& problem);

  /// The modules (0), or the constants of traced code (1).
  [[nodiscard]] const Pickle& pickle(int i) const {
    return pickles_.at(static_cast<std::size_t>(i));
  }

  /// A tensor of `pickle(which)` as a constant. E0614 to E0616, E0621, E0623.
  const NetValue* tensor(int which, std::uint32_t index, const std::string& name,
                         PolicyProblem& problem);

  /// Function "Linear.forward" or "elu" of module "__torch__.torch.nn.functional"; nullptr and
  /// E0621 or E0753 if it does not exist.
  const TorchFunction* function(const std::string& module, const std::string& name,
                                PolicyProblem& problem);

  /// Sizes that an observation may have: those of the file's tensors.
  [[nodiscard]] std::vector<std::int64_t> sizes() const;

 private:
  const TorchFunctions* code(const std::string& module, PolicyProblem& problem);
  std::optional<std::string_view> storage(int which, std::string_view key, PolicyProblem& problem);

  const Archive& archive_;
  std::string folder_;
  std::deque<Pickle> pickles_;  // never copied: their texts point to names that they hold
  std::deque<std::string> buffers_;
  std::map<std::string, std::string_view, std::less<>> storages_;
  std::size_t unpacked_ = 0;
  std::map<std::string, TorchFunctions, std::less<>> codes_;
  std::map<std::pair<int, std::uint32_t>, NetValue> known_;
  std::deque<NetTensor> tensors_;
  std::size_t numbers_ = 0;
};

}  // namespace eagerx::gen
