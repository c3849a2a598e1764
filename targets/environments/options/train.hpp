// What eagerx-train and `eagerx-gen train` take.
#pragma once

#include "targets/environments/options/row.hpp"

namespace eagerx::options {

inline constexpr Row kTrain[] = {
    {.names = "-o,--output",
     .value = "FILE",
     .about = "the policy (default: policy.safetensors)",
     .use = Use::writes,
     .otherwise = "policy.safetensors"},
    {.names = "--algorithm", .value = "NAME", .about = "ppo (default), or sac, which needs fewer steps and more time for each"},
    {.names = "--steps",
     .value = "N",
     .about = "steps of all environments, at most (default: 5000000)"},
    {.names = "--until-return",
     .value = "X",
     .about = "do not end before the mean return of 100 episodes is X"},
    {.names = "--seed",
     .value = "N",
     .about = "where random numbers start: another seed gives another policy (default: 1)"},
    {.names = "--threads",
     .value = "N",
     .about = "how many threads; the policy is the same for any number (default: one for each "
              "core)"},
    {.names = "--hidden", .value = "N,N", .about = "widths of the hidden layers (default: 64,64)"},
    {.names = "--discount",
     .value = "X",
     .about = "weight of a reward one step later (default: 0.99)"},
    {.names = "--checkpoint",
     .value = "FILE",
     .about = "write here, each minute and at the end, what --resume and --from need",
     .use = Use::writes},
    {.names = "--resume",
     .value = "FILE",
     .about = "go on from a checkpoint: the policy is that of one long run",
     .use = Use::reads,
     .goes_on = "--checkpoint"},
    {.names = "--from",
     .value = "FILE",
     .about = "begin with what a checkpoint has learnt, also on another graph with the same "
              "observations and actions",
     .use = Use::reads},
    {.names = "--csv",
     .value = "FILE",
     .about = "write the learning curve as a table",
     .use = Use::writes},
    {.names = "--curve",
     .value = "FILE",
     .about = "write the learning curve as a picture (SVG)",
     .use = Use::writes},
    {.names = "--isa",
     .value = "NAME",
     .about = "plain, avx2 or avx512; the bits are the same (default: the fastest)",
     .who = For::program},
    {.names = "-q,--quiet", .value = "", .about = "print problems only", .who = For::program},
    {.names = "--check",
     .value = "",
     .about = "only look whether the options are right and the files can be written",
     .who = For::program},
    {.names = "-h,--help", .value = "", .about = "print this", .who = For::program, .ends = true},
};

}  // namespace eagerx::options
