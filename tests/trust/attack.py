#!/usr/bin/env python3
"""attack.py GENERATOR WORK [NAME...]: checks of lines with a key; WORK/programs has the programs. Called by run."""
import os
import shutil
import socket
import subprocess
import sys
import threading
import traceback

from play import RUN, Between, Stage, at, cost_of, sampled, flipped, generator, hash_in
from sealed import Refused, Sealed, key_of

GENERATOR, WORK = sys.argv[1:3]
MANY = 10_000


def check(condition, what, *more):
    if not condition:
        raise AssertionError("\n".join([what, *map(str, more)]))


def same_hash(hub):
    check(hub.wait() == 0 and hash_in(hub.said()) == EXPECTED, "the hash of the one program", EXPECTED, hub.said())


def nothing_applied(stage, hub, *patterns):
    """The run has ended with the part's name, and all that was written is what the one program writes."""
    code, said = hub.wait(), hub.said()
    check(code == 3 and not hash_in(said), "exit code 3 and no hash", code, said)
    check(all(text in said for text in patterns), "this is said: " + repr(patterns), said)
    with open(stage.trace, encoding="utf-8") as file:
        found = file.read().splitlines()
    check(len(found) < len(WHOLE_TRACE) and found == WHOLE_TRACE[:len(found)], "a beginning of the right trace", found[-1:])


# --- with a key all is as without ---
def the_hash_is_the_same(stage):
    same_hash(stage.hub(stage.left()[1], key=False))
    same_hash(stage.hub(stage.left("--key", stage.key)[1]))
    part, port = stage.left("--key", stage.key)
    hub = stage.hub(port, "--key", stage.key, key=False)  # of all TCP lines
    same_hash(hub)
    check(part.wait() == 0, "the part ends with the hub", part.said())


def beyond_this_machine(stage):
    if shutil.which("ip") and subprocess.run(["ip", "netns", "add", "eagerx_a"], capture_output=True).returncode == 0:
        names = ("eagerx_a", "eagerx_b")
        try:
            for command in ("netns add eagerx_b", "-n eagerx_a link add eagerx0 type veth peer name eagerx0 netns eagerx_b",
                            "-n eagerx_a addr add 10.99.7.1/24 dev eagerx0", "-n eagerx_b addr add 10.99.7.2/24 dev eagerx0",
                            "-n eagerx_a link set eagerx0 up", "-n eagerx_b link set eagerx0 up"):
                subprocess.run(["ip", *command.split()], check=True)
            over(stage, "10.99.7.2", *(["ip", "netns", "exec", name] for name in names))
        finally:
            stage.close()
            for name in names:
                subprocess.run(["ip", "netns", "del", name], capture_output=True)
        return
    address = subprocess.run(["hostname", "-I"], capture_output=True, text=True).stdout.split()
    check(address, "this machine has an address")
    over(stage, address[0], [], [])


def over(stage, address, of_hub, of_part):
    host = f"[{address}]" if ":" in address else address
    for listen in (host + ":7001", "0.0.0.0:7001"):
        part = stage.start([*of_part, *stage.program("left"), "--listen", listen])
        check(part.wait() == 3 and "TCP needs a key\nhelp: `eagerx-gen key new FILE`" in part.said(), "no part without a key",
              part.said())
    hub = stage.hub(7001, host=host, key=False, before=of_hub)
    check(hub.wait() == 3 and "TCP needs a key\nhelp: `eagerx-gen key new FILE`" in hub.said(), "no hub without", hub.said())
    part = stage.start([*of_part, *stage.program("left"), "--listen", host + ":7001", "--key", stage.key])
    part.listens()
    same_hash(stage.hub(7001, host=host, before=of_hub))


def no_allocation_in_a_step(stage):
    guarded = ["env", "LD_PRELOAD=" + os.path.join(WORK, "no_alloc.so")]
    hub = stage.hub(stage.left("--key", stage.key)[1], before=guarded)
    same_hash(hub)
    check("no_alloc: no allocation while stepping" in hub.said(), "records need no memory", hub.said())


def cost_of_a_step(stage):
    """Requested by name, it is the least of three runs, because whatever else runs here only adds to it."""
    steps, runs = 10_000, 3 if sys.argv[3:] else 1
    run = ["--agent", "random", "--steps", str(steps)]

    def once(key):
        part, port = stage.left(*(["--key", stage.key] if key else []))
        hub = stage.hub(port, key=key, run=run)
        check(hub.wait() == 0, "it runs", hub.said())
        part.wait()

    without, with_key = (min(cost_of(lambda key=key: once(key)) for _ in range(runs)) for key in (False, True))
    print(f"     processor time a step, hub and part over TCP: {without / steps * 1e6:.1f} us without a key, "
          f"{with_key / steps * 1e6:.1f} us with it, {with_key / without:.2f} times")


def a_second_implementation(stage):
    """A program in Python that has the key is between them: so the page says enough."""
    part, port = stage.left("--key", stage.key)
    key, server = key_of(stage.key), socket.create_server(("127.0.0.1", 0))
    noise, wrong = generator(3), []

    def stand():
        to_hub = Sealed(server.accept()[0], key, connects=False)
        to_part = Sealed(socket.create_connection(("127.0.0.1", port)), key, connects=True)

        def carry(source, target):
            # A peer with the key may still send what is not a frame: it is ignored, as on every line.
            for number in range(MANY):
                target.send(b"\0" + bytes(noise.randrange(1, 256) for _ in range(number % 60)) + b"\0")
            try:
                while data := source.receive():
                    target.send(data)
                target.end()
            except (Refused, OSError) as problem:
                wrong.append(problem)

        threading.Thread(target=carry, args=(to_part, to_hub), daemon=True).start()
        carry(to_hub, to_part)

    threading.Thread(target=stand, daemon=True).start()
    hub = stage.hub(server.getsockname()[1])
    same_hash(hub)
    check(part.wait() == 0 and not wrong, "the end is said, too", part.said(), wrong)
    check("left: frames ignored" in hub.said(), "noise is counted", hub.said())


# --- a peer without the key ---
def another_key(stage):
    part, port = stage.left("--key", stage.key)
    nothing_of = stage.hub(port, "--key", "left=" + os.path.join(WORK, "other.key"), key=False)
    check(nothing_of.wait() == 3 and "does not have this key" in nothing_of.said(), "a hub with another key", nothing_of.said())
    check(part.process.poll() is None, "the part continues to listen")
    same_hash(stage.hub(port))


def a_key_on_one_side(stage):
    hub = stage.hub(stage.left()[1])
    check(hub.wait() == 3 and "help: start it with `--key`" in hub.said(), "a part without", hub.said())
    part, port = stage.left("--key", stage.key)
    hub = stage.hub(port, key=False)
    check(hub.wait() == 3 and "the other end hung up" in hub.said(), "a hub without", hub.said())
    same_hash(stage.hub(port))


def of_another_graph(stage):
    hub = stage.hub(stage.left("--key", stage.key, program="other_left")[1])
    check(hub.wait() == 3 and "error: part `left` runs another graph" in hub.said(), "another graph", hub.said())


def slow_greetings(stage):
    part, port = stage.left("--key", stage.key)
    end = threading.Event()

    def drip(connection, data):
        for byte in data:
            if end.wait(0.2):
                return
            try:
                connection.sendall(bytes([byte]))
            except OSError:
                return

    slow = [socket.create_connection(("127.0.0.1", port)) for _ in range(3)]
    for connection in slow:
        threading.Thread(target=drip, args=(connection, b"eagerx-key-link1" + b"x" * 60), daemon=True).start()
    # And a slow one at the other end, while the part waits for those.
    server = socket.create_server(("127.0.0.1", 0))
    threading.Thread(target=lambda: drip(server.accept()[0], bytes(range(73))), daemon=True).start()
    hub = stage.hub(server.getsockname()[1])
    check(hub.wait() == 3 and "did not authenticate in time" in hub.said(), "the hub ends", hub.said())
    part.until(lambda: "did not authenticate within 5 s" in part.said(), "the end of a slow greeting")
    slow.append(socket.create_connection(("127.0.0.1", port)))
    same_hash(stage.hub(port))
    end.set()


def many_hostile_connections(stage):
    part, port = stage.left("--key", stage.key)
    between = Between(port)
    same_hash(stage.hub(between.port))
    earlier = [bytes(record) for record in between.there.said + between.there.records]
    part, port = stage.left("--key", stage.key)
    rng = generator(1)
    kept = []
    for number in range(MANY):
        kind = number % 5
        says = [b"", sampled(rng, rng.randrange(1, 200)), earlier[0] + sampled(rng, 41), b"".join(earlier),
                flipped(earlier[0] + earlier[1], rng)][kind]
        try:
            connection = socket.create_connection(("127.0.0.1", port))
            if says:
                connection.sendall(says)
            kept.append(connection)
        except OSError:
            pass  # it was dropped while it spoke
        if len(kept) > 20:
            kept.pop(0).close()
    check(part.process.poll() is None and len(part.said().splitlines()) < 10, "it listens, and fills no disk", part.said())
    same_hash(stage.hub(port))


def hostile_answers(stage):
    part, port = stage.left("--key", stage.key)
    between = Between(port)
    same_hash(stage.hub(between.port))
    answer, rng = between.back.said[0], generator(2)
    own = between.there.said[0][16:]
    for says in (answer, answer[:50], sampled(rng, 73), own + sampled(rng, 41), own * 3, bytes(73), flipped(answer, rng),
                 sampled(rng, 100_000)):
        server = socket.create_server(("127.0.0.1", 0))

        def speak(says=says, server=server):
            connection = server.accept()[0]
            try:
                connection.sendall(says)
                connection.shutdown(socket.SHUT_WR)
                while connection.recv(4096):
                    pass
            except OSError:
                pass  # the hub has hung up

        threading.Thread(target=speak, daemon=True).start()
        hub = stage.hub(server.getsockname()[1])
        check(hub.wait() == 3 and "error: cannot open `127.0.0.1:" in hub.said(), "a hub is not deceived", hub.said())
    # Its own greeting, sent back.
    server = socket.create_server(("127.0.0.1", 0))

    def reflect():
        connection = server.accept()[0]
        said = connection.recv(4096)
        connection.sendall(said[16:] + sampled(rng, 41))

    threading.Thread(target=reflect, daemon=True).start()
    hub = stage.hub(server.getsockname()[1])
    check(hub.wait() == 3 and "does not have this key" in hub.said(), "reflected", hub.said())


# --- an attacker on the line between them ---
def changed_on_the_way(stage):
    part, port = stage.left("--key", stage.key)
    between = Between(port)
    same_hash(stage.hub(between.port))
    old = {"to_part": between.there.records, "to_hub": between.back.records}
    rng = generator(4)

    def hold(way, record):
        way.held = getattr(way, "held", [])
        way.held.append(record)
        return [] if len(way.held) == 1 else [record, way.held[0]] if len(way.held) == 2 else [record]

    def once(number, data):
        return lambda way, record: data(way, record) if len(way.records) == number else [record]

    attacks = {
        "changed": lambda d: at(9, lambda way, record: [flipped(record, rng)]),
        "changed once": lambda d: once(20, lambda way, record: [flipped(record, rng)]),
        "repeated": lambda d: once(7, lambda way, record: [record, record]),
        "left out": lambda d: once(8, lambda way, record: []),
        "in another order": lambda d: at(6, hold),
        "reflected": lambda d: once(5, lambda way, record: [way.other.records[-1]]),
        "of an earlier session": lambda d: at(4, lambda way, record: [old[d][len(way.records) - 1]]),
        "one more": lambda d: once(11, lambda way, record: [record, b"\x05\0" + sampled(rng, 22)]),
        "the longest": lambda d: once(3, lambda way, record: [b"\xff\xff" + sampled(rng, 70_000)]),
        "an end": lambda d: once(12, lambda way, record: [b"\0\0" + sampled(rng, 17)]),
        "10,000 more": lambda d: once(5, lambda way, record: [b"\x08\0" + sampled(rng, 25) for _ in range(MANY)]),
        "cut": lambda d: once(10, lambda way, record: [record[:9], None]),
    }
    for name, attack in attacks.items():
        for direction in ("to_part", "to_hub"):
            part, port = stage.left("--key", stage.key)
            between = Between(port, **{direction: attack(direction)})
            hub = stage.hub(between.port)
            try:
                nothing_applied(stage, hub, "error: the line to part `left` is closed")
                code = part.wait()
                if name == "cut":
                    check("it was cut" in hub.said(), "it is said", hub.said())
                elif direction == "to_part":
                    check(code == 3 and "a third party changed, repeated or removed data" in part.said(), "the part says it", part.said())
                else:
                    check("a third party changed, repeated or removed data" in hub.said(), "the hub says it", hub.said())
            except AssertionError as problem:
                raise AssertionError(f"{name}, {direction}: {problem}") from problem
            print(f"     {name}, {direction}: refused")


# --- the file, and the library ---
def files_that_are_no_key(stage):
    path = os.path.join(stage.scratch, "a.key")

    def refused(what, option):
        hub = stage.hub(1, "--key", option, key=False)
        check(hub.wait() in (2, 3) and what in hub.said(), what, hub.said())
        if "=" not in option:
            part = stage.start([*stage.program("left"), "--listen", "127.0.0.1:0", "--key", option])
            check(part.wait() == 3 and "cannot use the key" in part.said() and what in part.said(), what, part.said())

    refused("No such file or directory\nhelp: `eagerx-gen key new FILE` writes one", path)
    shutil.copy(stage.key, path)
    os.chmod(path, 0o644)
    refused("others can read it, or write it\nhelp: chmod 600 " + path, path)
    os.chmod(path, 0o600)
    with open(path, "a", encoding="ascii") as file:
        file.write("\n")
    refused("it is not a key: it has 83 bytes or more, a key has 82", path)
    with open(path, "w", encoding="ascii") as file:
        file.write("x" * 82)
    refused("it is not a key: a key is a line `eagerx-gen key 1 ` and 64 of the digits", path)
    if os.geteuid() == 0:
        os.chown(path, 65534, 65534)
        refused("it belongs to another user", path)
    refused("error: `--key right=" + path + "` does nothing", "right=" + path)
    hub = stage.hub(1, "--key", "left=" + stage.key)
    check(hub.wait() == 2 and "error: two keys for one line" in hub.said(), "two keys", hub.said())
    part = stage.start([*stage.program("left"), "--listen", "unix:" + path + "s", "--key", stage.key])
    check(part.wait() == 3 and "does nothing: it is for TCP" in part.said(), "no key for a unix socket", part.said())
    # An existing file stays.
    before = open(stage.key, encoding="ascii").read()
    again = subprocess.run([GENERATOR, "key", "new", stage.key], capture_output=True, text=True)
    check(again.returncode == 3 and "there is a file of this name" in again.stderr, "not over a file", again.stderr)
    check(open(stage.key, encoding="ascii").read() == before, "as it was")
    output = stage.hub(1, "--csv", stage.key)
    check(output.wait() == 2 and "are one file" in output.said(), "no output over a key", output.said())


def without_the_library(stage):
    library = subprocess.run(["ldconfig", "-p"], capture_output=True, text=True, env={"PATH": "/usr/sbin:/sbin"}).stdout
    path = next(line.split()[-1] for line in library.splitlines() if "libsodium.so.23" in line)
    hide = ["unshare", "-m", "sh", "-c", f'mount --bind /dev/null {path} && exec "$@"', "sh"]
    if subprocess.run([*hide, "true"], capture_output=True).returncode:
        print("SKIPPED: a program without libsodium, as nothing can be mounted here")
        return
    hub = stage.hub(1, before=hide)
    check(hub.wait() == 3 and "help: apt install libsodium23" in hub.said(), "it says what to install", hub.said())
    part = stage.start([*hide, *stage.program("left"), "--listen", "127.0.0.1:0", "--key", stage.key])
    check(part.wait() == 3 and "help: apt install libsodium23" in part.said(), "so does a part", part.said())
    port = stage.left()[1]
    same_hash(stage.hub(port, key=False, before=hide))
    made = subprocess.run([*hide, GENERATOR, "key", "new", os.path.join(stage.scratch, "b.key")], capture_output=True)
    check(made.returncode == 0, "a key is made without it", made.stderr)


CHECKS = [the_hash_is_the_same, beyond_this_machine, no_allocation_in_a_step, a_second_implementation, another_key,
          a_key_on_one_side, of_another_graph, slow_greetings, many_hostile_connections, hostile_answers, changed_on_the_way,
          files_that_are_no_key, without_the_library, cost_of_a_step]

for name in ("good", "other"):
    if not os.path.exists(os.path.join(WORK, name + ".key")):
        subprocess.run([GENERATOR, "key", "new", os.path.join(WORK, name + ".key"), "-q"], check=True)
WHOLE = os.path.join(WORK, "whole.trace")
EXPECTED = hash_in(subprocess.run([os.path.join(WORK, "programs", "whole.elf"), *RUN, "--hash", "--trace", WHOLE], check=True,
                                  capture_output=True, text=True).stdout)
with open(WHOLE, encoding="utf-8") as whole:
    WHOLE_TRACE = whole.read().splitlines()
failed = 0
for each in CHECKS:
    if sys.argv[3:] and each.__name__ not in sys.argv[3:]:
        continue
    stage = Stage(WORK)
    try:
        each(stage)
        print("ok   " + each.__name__.replace("_", " "), flush=True)
    except (AssertionError, OSError, subprocess.SubprocessError):
        failed += 1
        print("FAIL " + each.__name__.replace("_", " "), flush=True)
        traceback.print_exc(file=sys.stdout)
    finally:
        stage.close()
        shutil.rmtree(stage.scratch, ignore_errors=True)
sys.exit(f"{failed} failed" if failed else 0)
