// Keys of a trained policy in the graph file, for nodes and for the agent.
#include "generator/frontend/spec/graph_spec.hpp"

namespace eagerx::gen {
namespace {

std::vector<Field> policy_settings() {
  return {
      {"output", format::keyword({"squashed", "raw", "argmax", "binary"}), false,
       "squashed: answers from -1 to 1 are mapped to the action's bounds (SB3's SAC and TD3); raw: "
       "answers are clipped to the bounds (PPO, A2C); argmax: the action is the index of the "
       "largest output (DQN), or of several whole numbers the index of the largest of its own "
       "outputs (MultiDiscrete); binary: 1 where an output is above zero, else 0 (MultiBinary). "
       "Default: as the file says, else squashed if the last layer is a tanh, else raw"},
      {"trained_at", format::rate(), false,
       "rate of the training in Hz, for files that do not contain it; the rate of the policy must "
       "be equal"},
      {"normalize_actions", format::boolean(), false,
       "true: the training scaled the bounds of the actions to -1 and 1: `make_vec_env(…, "
       "normalize_actions=True)`, Gymnasium's RescaleAction"},
      {"normalize", format::text("a file name"), false,
       "statistics of the observations: VecNormalize.save, npz or JSON"},
      {"activation",
       format::keyword({"identity", "relu", "tanh", "elu", "leaky_relu", "silu", "gelu",
                        "gelu_tanh", "softplus", "sigmoid"}),
       false, "activation after the hidden layers, for files that do not contain it"},
      {"output_activation",
       format::keyword({"none", "relu", "tanh", "elu", "leaky_relu", "silu", "gelu", "gelu_tanh",
                        "softplus", "sigmoid"}),
       false,
       "activation after the last layer, for files that do not contain it: state dicts of modules "
       "of unknown libraries"},
      {"state_dependent_std", format::boolean(), false,
       "true: the first half of the outputs are means, which are used, and the second half "
       "standard deviations, which are not: rsl_rl's `state_dependent_std` and "
       "HeteroscedasticGaussianDistribution"},
      {"layers", format::list("a list of layers", format::text("a name"), 1), false,
       "layers in order, for a table of tensors whose names have no order: `[fc1, fc2, mu]`, or "
       "with activations `[fc1, relu, fc2, relu, mu, tanh]`"},
      {"input_sizes",
       format::list("a list of sizes", format::integer("a whole number above 0", 1.0), 1), false,
       "for TorchScript with several inputs: the size of each, if the file does not contain it"},
      {"actor", format::text("a name"), false,
       "for a file with several actors: the prefix of the tensors of one"},
      {"output_name", format::text("a name"), false,
       "output that is the action, for ONNX with several outputs; for TorchScript its position, "
       "from \"0\" on"},
      {"golden", format::text("a file name"), false,
       "observations with known answers (CSV or npz); the generator and every program check them"},
      {"weights", format::keyword({"float32", "int8"}), false,
       "int8: eight bits a weight, a quarter of the flash (default: float32)"},
      {"max_error", format::decimal("a number above 0", 0.0, true), false,
       "int8: maximum difference of an output from float32 on the golden rows"},
      {"profile", format::keyword({"exact", "fast"}), false,
       "fast: faster on Linux, but the bits differ from machine to machine (default: exact)"}};
}

}  // namespace

FormatPtr node_policy_format() {
  const Field file = {"file", format::text("a file name"), true, "policy file"};
  return format::one_of(
      "a weight file, or a mapping with its `file`",
      {format::record("a policy", with({file}, policy_settings())), format::text("a file name")});
}

FormatPtr agent_format() {
  return format::one_of(
      "`zero`, `random`, `{policy: FILE}` or `{csv: FILE}`",
      {format::record(
           "an agent",
           with({{"policy", format::text("a file name"), false,
                  "weight file of a trained policy: Stable-Baselines3's zip, ONNX, safetensors, "
                  "npz, "
                  "torch.save"},
                 {"csv", format::text("a file name"), false, "file of actions, one row a step"},
                 {"observations", format::list("a list of observations", format::name("a name"), 1),
                  false,
                  "order of the observations in the policy's input (default: by name, as "
                  "Gymnasium's Dict)"}},
                policy_settings())),
       format::keyword({"zero", "random"})});
}

}  // namespace eagerx::gen
