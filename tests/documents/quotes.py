"""The generated program that templates/README.md shows is one that is generated."""
import re

DOCUMENT = "templates/README.md"
PROGRAM = "tests/golden/pendulum_swing_up/expected/pendulum_swing_up/program.hpp"


def check_quotes(root):
    document, program = root / DOCUMENT, root / PROGRAM
    if not document.is_file():
        return [], "no quoted program"
    blocks = re.findall(r"^```cpp\n(.*?)^```", document.read_text(encoding="utf-8"), re.DOTALL | re.MULTILINE)
    quoted = next((block for block in blocks if "Observation step(" in block), "")
    parts = [part.strip("\n") for part in re.split(r"^ *…\n", quoted, flags=re.MULTILINE)]
    text = program.read_text(encoding="utf-8")
    problems = [f"{DOCUMENT}: this is not in {PROGRAM}: {part.splitlines()[0].strip()} …" for part in parts if part not in text]
    if len(quoted) < 200:
        problems.append(f"{DOCUMENT} shows no program")
    return problems, f"{quoted.count(chr(10))} lines of a program"
