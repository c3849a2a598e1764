"""The other side of DDS: peer.c, a program of Cyclone DDS's own headers."""
import os
import pathlib
import shutil
import subprocess

HERE = pathlib.Path(__file__).resolve().parent
DDS = HERE.parents[2] / "runtime/host/dds"
DOMAIN = 1 + os.getpid() % 100  # tests that run at the same time do not hear each other
LOOPBACK = ('<CycloneDDS><Domain Id="any"><General><Interfaces><NetworkInterface address="127.0.0.1"/></Interfaces>'
            "<AllowMulticast>false</AllowMulticast></General><Discovery><ParticipantIndex>auto</ParticipantIndex>"
            '<MaxAutoParticipantIndex>32</MaxAutoParticipantIndex><Peers><Peer address="127.0.0.1"/></Peers>'
            "</Discovery></Domain></CycloneDDS>")


class Peer:
    """peer.c, from when it has its topics on."""
    program = None

    def __init__(self, *arguments):
        self.process = subprocess.Popen([self.program, arguments[0], str(DOMAIN), *map(str, arguments[1:])], text=True,
                                        stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                                        env={**os.environ, "CYCLONEDDS_URI": LOOPBACK})
        assert self.process.stdout.readline() == "ready\n"

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.process.kill()
        self.process.communicate()

    def wait_for_answer(self):
        assert self.process.stdout.readline() == "answered\n"

    def end(self):
        """[(topic, words)] of a reader."""
        lines = self.process.communicate("end\n", timeout=30)[0].splitlines()
        return [(topic, words) for topic, *words in map(str.split, lines)]


def build(work):
    """Whether there is what peer.c needs; then it is compiled."""
    if shutil.which("idlc") is None or not pathlib.Path("/usr/include/dds/dds.h").exists():
        return False
    subprocess.run(["idlc", "-t", "-f", "case-sensitive", "-W", "no-implicit-extensibility", "-o", work,
                    DDS / "messages.idl"], check=True, stdout=subprocess.DEVNULL)
    Peer.program = work / "peer"
    subprocess.run(["gcc", "-O1", f"-I{work}", HERE / "peer.c", work / "messages.c", "-lddsc", "-lm", "-o", Peer.program],
                   check=True)
    return True
