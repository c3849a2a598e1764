// Options of eagerx-campaign and `eagerx-gen campaign`.
#pragma once

#include "targets/environments/options/row.hpp"

namespace eagerx::options {

inline constexpr Row kCampaign[] = {
    {.names = "--runs", .value = "N", .about = "number of episodes (default: 1000)"},
    {.names = "--vary",
     .value = "NAME=LOW:HIGH",
     .about =
         "range from which each run samples a state or a delay, or one element of it: NAME[0]; "
         "may be repeated",
     .repeated = true},
    {.names = "--faults",
     .value = "NAME=KIND",
     .about =
         "disturb an observation or an action from a random step of each run on: `silent`, `nan`, "
         "`offset:X` or `value:X`; with +STEPS for N steps, as in angle=silent+10; may be repeated",
     .repeated = true},
    {.names = "--steps",
     .value = "N",
     .about = "end an episode after N steps (default: from the task, or 300)"},
    {.names = "--seed",
     .value = "N",
     .about = "seed of random numbers: another seed gives other runs (default: 1)"},
    {.names = "--threads",
     .value = "N",
     .about = "number of threads, which does not change the report (default: one for each core)"},
    {.names = "--worst", .value = "N", .about = "list the N worst runs (default: 5)"},
    {.names = "--csv",
     .value = "FILE",
     .about = "write a table with a row for each run",
     .use = Use::writes},
    {.names = "--json", .value = "", .about = "print the report as JSON"},
    {.names = "--checkpoint",
     .value = "FILE",
     .about = "file that finished runs are added to, for --resume",
     .use = Use::writes},
    {.names = "--resume",
     .value = "FILE",
     .about = "continue from a checkpoint; the report is the same as without the interruption",
     .use = Use::reads,
     .continues = "--checkpoint"},
    {.names = "--replay",
     .value = "WORDS",
     .about = "first words of the command that repeats a run",
     .who = For::program},
    {.names = "-q,--quiet", .value = "", .about = "print problems only", .who = For::program},
    {.names = "--check",
     .value = "",
     .about = "only check the options, and whether the files can be written",
     .who = For::program},
    {.names = "--describes",
     .value = "JSON",
     .about = "with --check: description of the graph, as the library will give it, to check the "
              "options against",
     .who = For::program},
    {.names = "-h,--help", .value = "", .about = "print this", .who = For::program, .ends = true},
};

}  // namespace eagerx::options
