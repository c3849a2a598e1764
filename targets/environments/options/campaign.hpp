// What eagerx-campaign and `eagerx-gen campaign` take.
#pragma once

#include "targets/environments/options/row.hpp"

namespace eagerx::options {

inline constexpr Row kCampaign[] = {
    {.names = "--runs", .value = "N", .about = "episodes (default: 1000)"},
    {.names = "--vary",
     .value = "NAME=LOW:HIGH",
     .about = "draw a state or a delay of each run from this range, may be repeated; an element is "
              "NAME[0]",
     .repeated = true},
    {.names = "--faults",
     .value = "NAME=KIND",
     .about = "from a step that each run draws, what the agent sees or gives is `silent`, `nan`, "
              "`offset:X` or `value:X`; +STEPS: for that many steps; may be repeated",
     .repeated = true},
    {.names = "--steps",
     .value = "N",
     .about = "end an episode after N steps (default: from the task, or 300)"},
    {.names = "--seed",
     .value = "N",
     .about = "where random numbers start: another seed is another campaign (default: 1)"},
    {.names = "--threads",
     .value = "N",
     .about = "how many threads; the report is the same for any number (default: one for each "
              "core)"},
    {.names = "--worst", .value = "N", .about = "name the N worst runs (default: 5)"},
    {.names = "--csv",
     .value = "FILE",
     .about = "write a table with a row for each run",
     .use = Use::writes},
    {.names = "--json", .value = "", .about = "print the report as JSON"},
    {.names = "--checkpoint",
     .value = "FILE",
     .about = "add finished runs to this file, for --resume",
     .use = Use::writes},
    {.names = "--resume",
     .value = "FILE",
     .about = "continue from a checkpoint: the report is that of one long run",
     .use = Use::reads,
     .continues = "--checkpoint"},
    {.names = "--replay",
     .value = "WORDS",
     .about = "what the command that repeats a run begins with",
     .who = For::program},
    {.names = "-q,--quiet", .value = "", .about = "print problems only", .who = For::program},
    {.names = "--check",
     .value = "",
     .about = "only look whether the options are right and the files can be written",
     .who = For::program},
    {.names = "--describes",
     .value = "JSON",
     .about = "with --check: what the library will say of its graph, which the options must fit",
     .who = For::program},
    {.names = "-h,--help", .value = "", .about = "print this", .who = For::program, .ends = true},
};

}  // namespace eagerx::options
