// Follows `forward` of a TorchScript archive from its arguments to its results, without running it:
// a tensor is a symbol with known properties, and conditions must be known.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "generator/policy/formats/torchscript/archive.hpp"
#include "generator/policy/formats/torchscript/value.hpp"

namespace eagerx::gen {

/// Help where the state of a GRU or LSTM is not kept as it should be.
inline constexpr const char* kStateAsInput =
    "export the actor with its state as an input and an output, to ONNX";
/// What is wrong with a buffer that changes in another way, and help.
inline constexpr const char* kUnknownState =
    "that is changed, and is not the state of a GRU or LSTM, nor a history";
inline constexpr const char* kHistoryAsInput =
    "a buffer may keep the state of a GRU or LSTM, or the last N values of something that does not "
    "depend on it; if this one has the last N observations, export a module whose `forward` takes "
    "them as its argument, oldest first, and set `window: N` on the observation's connection";

class TorchInterpreter {
 public:
  /// Executes at most `*budget` statements, and subtracts those executed. Reads the buffers
  /// `histories` as values that are not known yet.
  TorchInterpreter(TorchArchive& archive, NetCall::State& state, std::int64_t& budget,
                   PolicyProblem& problem, const std::set<std::uint32_t>& histories)
      : archive_(archive),
        state_(state),
        budget_(budget),
        problem_(problem),
        histories_(histories) {}

  /// The result of the module's `forward` for tensors.
  std::optional<TorchValue> run(const std::vector<NetValue>& inputs);
  /// Statements that were followed.
  [[nodiscard]] std::int64_t followed() const { return followed_; }
  /// A buffer, not among `histories`, that is changed into something else than a recurrent state.
  [[nodiscard]] std::optional<std::uint32_t> changed() const;
  /// Buffers of several axes that were read, and are zeros.
  [[nodiscard]] std::vector<std::uint32_t> zeros() const;
  /// Of each of `histories` that was read the step that stands for its values.
  [[nodiscard]] const std::map<std::uint32_t, std::int32_t>& former_values() const {
    return former_;
  }
  /// Tensors of modules that were looked at.
  [[nodiscard]] const std::map<std::uint32_t, std::shared_ptr<TorchTensor>>& cells() const {
    return cells_;
  }

 private:
  using Variables = std::map<std::string, TorchValue, std::less<>>;
  using Value = std::optional<TorchValue>;
  using Named = std::vector<std::pair<std::string, TorchValue>>;
  enum class Flow : std::uint8_t { on, returned, failed };

  Value call(const TorchFunction& function, std::vector<TorchValue> arguments, Named named);
  Flow follow(const std::vector<TorchStatement>& body, Variables& variables, TorchValue& result);
  Flow follow(const TorchStatement& statement, Variables& variables, TorchValue& result);
  bool assign(const std::vector<TorchExpression>& targets, TorchValue value, Variables& variables);

  Value evaluate(const TorchExpression& expression, Variables& variables);
  Value evaluate_name(const TorchExpression& expression, Variables& variables);
  Value evaluate_attribute(const TorchExpression& expression, Variables& variables);
  Value evaluate_call(const TorchExpression& expression, Variables& variables);
  Value evaluate_subscript(const TorchExpression& expression, Variables& variables);
  Value built_in(const std::string& name, std::vector<TorchValue> arguments);
  Value operation(const std::string& name, std::vector<TorchValue> arguments, Named named);
  Value in_place(const std::string& name, std::vector<TorchValue> arguments, Named named);
  Value copy_into_part(const TorchValue& part, const std::vector<TorchValue>& arguments);
  Value method(const TorchValue& module, const std::string& name, std::vector<TorchValue> arguments,
               Named named);
  std::optional<std::uint32_t> index_of(const TorchValue& module, const std::string& name);
  Value member(const TorchValue& module, const std::string& name);
  Value value_of(int pickle, std::uint32_t index, const std::string& name, int depth = 0);
  Value tensor_of(int pickle, std::uint32_t index, const std::string& name);
  std::optional<NetValue> values_before(std::uint32_t index, const NetValue& buffer);

  Refused fail(const std::string& what);
  Refused fail_changed(std::string_view buffer);
  [[nodiscard]] std::string where() const;

  TorchArchive& archive_;
  NetCall::State& state_;
  std::int64_t& budget_;
  PolicyProblem& problem_;
  std::map<std::uint32_t, std::shared_ptr<TorchTensor>> cells_;
  std::map<std::uint32_t, std::string> names_;  // of buffers
  const std::set<std::uint32_t>& histories_;
  std::map<std::uint32_t, std::int32_t> former_;
  std::optional<std::uint32_t> changed_;
  const std::string* file_ = nullptr;
  int line_ = 0;
  int depth_ = 0;
  std::int64_t followed_ = 0;
};

/// "torch.nn.functional" of names and their attributes; empty for anything else.
std::string dotted_name(const TorchExpression& expression);

/// Calculations with known numbers, lists and shapes: "eq", "size", "__not__". Nothing if it is no
/// such operator.
std::optional<TorchValue> run_plain_operator(const std::string& name,
                                             const std::vector<TorchValue>& arguments);

}  // namespace eagerx::gen
