"""All outputs of all commands and of generated programs, and what makes them: of the command lines BUILD_FOLDER LIBRARY PROGRAM
of full_files and every_kind."""
import os
import sys

BUILD, LIBRARY, PROGRAM = (os.path.realpath(word) for word in sys.argv[1:])
ROOT = os.path.realpath(os.path.join(os.path.dirname(__file__), "../.."))
SWING = ROOT + "/tests/environments/swing.yaml"
UPRIGHT = ROOT + "/tests/design/upright.yaml"
SAVED = ROOT + "/tests/import/cases/c01_minimal.graph.yaml"
POLICY = ROOT + "/examples/pendulum_swing_up/swing_up.onnx"
GENERATOR = [os.path.join(BUILD, "eagerx-gen")]
TRAIN = [os.path.join(BUILD, "eagerx-train"), LIBRARY, "--steps", "8192", "--hidden", "4", "--quiet"]
CAMPAIGN = [os.path.join(BUILD, "eagerx-campaign"), LIBRARY, "--runs", "2000", "--quiet"]
PLAY = [PROGRAM, "--episodes", "200", "--quiet"]
# For each output: the command line without it, its name, and what else the command needs.
OUTPUTS = {
    ("generate", "--output"): [*GENERATOR, "generate", SWING, "--quiet"],
    ("generate", "--depfile"): [*GENERATOR, "generate", SWING, "--quiet", "--output", "elsewhere"],
    ("build", "--output"): [*GENERATOR, "build", SWING, "--quiet"],
    ("run", "--output"): [*GENERATOR, "run", SWING, "--quiet"],
    ("linearize", "--output"): [*GENERATOR, "linearize", SWING, "--quiet"],
    ("trim", "--output"): [*GENERATOR, "trim", SWING, "--quiet"],
    ("design lqr", "--output"): [*GENERATOR, "design", "lqr", UPRIGHT, "--of", "balance", "--deviation", "balance.x=0.1,1", "--quiet"],
    ("design kalman", "--output"): [*GENERATOR, "design", "kalman", UPRIGHT, "--of", "estimate", "--process", "x=0.1,0.1", "--quiet"],
    ("design pid", "--output"): [*GENERATOR, "design", "pid", ROOT + "/examples/cascade/graph.yaml", "--of", "current", "--quiet"],
    ("pil", "--output"): [*GENERATOR, "pil", ROOT + "/examples/controller_in_your_main/graph.yaml", "--of", "control", "--quiet"],
    ("train", "--output"): TRAIN,
    ("train", "--checkpoint"): TRAIN,
    ("train", "--csv"): TRAIN,
    ("train", "--curve"): TRAIN,
    ("train", "--tensorboard"): TRAIN,
    ("train", "--record"): TRAIN,
    ("train", "--results"): [*TRAIN, "--case", "min_std=0.2"],
    ("train", "--build"): [*GENERATOR, "train", SWING, "--quiet"],
    ("campaign", "--csv"): CAMPAIGN,
    ("campaign", "--checkpoint"): CAMPAIGN,
    ("campaign", "--build"): [*GENERATOR, "campaign", SWING, "--quiet"],
    ("graph", "--output"): [*GENERATOR, "graph", SWING, "--quiet"],
    ("report", "--output"): [*GENERATOR, "report", SWING, "--quiet", "--trace", "run.log"],
    ("import", "--output"): [*GENERATOR, "import", SAVED, "--path", ROOT + "/tests/data/import", "--quiet"],
    ("new", "--output"): [*GENERATOR, "new", "project", "swing", "--quiet"],
    ("key new", "file"): [*GENERATOR, "key", "new"],
    ("identify", "--out"): [*GENERATOR, "identify", PROGRAM, "run.log"],
    ("trace convert", "--output"): [*GENERATOR, "trace", "convert", "run.log", "--quiet"],
    ("linearize", "--plot"): [*GENERATOR, "linearize", ROOT + "/examples/cascade/graph.yaml", "--open", "current.u", "--quiet"],
    ("linearize", "--npz"): [*GENERATOR, "linearize", ROOT + "/examples/cascade/graph.yaml", "--quiet"],
    ("plot", "--output"): [*GENERATOR, "plot", "run.log", "theta_dot", "--quiet"],
    ("monitor", "--record"): [*GENERATOR, "monitor", "run.log", "--once"],
    ("policy golden", "--output-file"): [*GENERATOR, "policy", "golden", POLICY, "--quiet"],
    ("program", "--csv"): PLAY,
    ("program", "--trace"): PLAY,
    ("program", "--render"): [PROGRAM, "--quiet"],
}
# In the place of FILE; several are tried each.
NAMES = {
    ("graph", "--output"): ["graph.svg", "graph.dot", "graph.mmd"],
    ("trace convert", "--output"): ["run.csv", "run.json", "run.mcap", "run.npz"],
    ("plot", "--output"): ["run.svg"],
    ("linearize", "--plot"): ["loop.svg"],
    ("linearize", "--npz"): ["loop.npz"],
    ("monitor", "--record"): ["run.mcap", "run.trace"],
    ("generate", "--depfile"): ["swing.d"],
    ("program", "--render"): ["%04d.png", "film.mp4"],
}
# Where something is read or made that must be somewhere.
NO_OUTPUTS = {"--path", ("report", "--build"), ("size", "--build")}
# These write while they run: what was written until then stays.
STREAMS = {("program", "--csv"), ("program", "--trace"), ("program", "--render"), ("campaign", "--checkpoint"),
           ("monitor", "--record"), ("train", "--csv"), ("train", "--tensorboard"), ("train", "--record"),
           ("train", "--results")}
FOLDERS = {("build", "--output"), ("linearize", "--output"), ("trim", "--output"), ("design lqr", "--output"), ("design kalman", "--output"),
           ("design pid", "--output"), ("pil", "--output"), ("run", "--output"), ("train", "--build"), ("campaign", "--build"), ("generate", "--output"),
           ("new", "--output"), ("train", "--tensorboard")}
# Where nothing may be before.
NEW = FOLDERS | {("campaign", "--checkpoint"), ("key new", "file"), ("train", "--results")}
