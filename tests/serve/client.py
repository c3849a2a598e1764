"""A client of `eagerx-gen serve`, of the standard library."""
import json
import os
import pathlib
import re
import signal
import socket
import subprocess
import sys
import urllib.error
import urllib.request

ROOT = pathlib.Path(__file__).resolve().parents[2]
LEFT_OUT = 77


class Server:
    """Serves a graph while it is entered. `state`: the last one that was answered."""

    def __init__(self, eagerx_gen, graph, *options):
        self.command = [eagerx_gen, "serve", str(graph), *options]
        self.graph = pathlib.Path(graph)

    def __enter__(self):
        self.process = subprocess.Popen(self.command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                                        env={**os.environ, "EAGERX_HOME": str(ROOT)})
        self.address = self.process.stdout.readline().strip()
        match = re.fullmatch(r"http://127\.0\.0\.1:(\d+)/([0-9a-f]{32})/", self.address)
        if match is None:
            error = self.process.communicate(timeout=10)[1]
            if "libcpp-httplib-dev" in error:
                print(f"SKIPPED: there is no cpp-httplib (toolchains/install-packages serve)")
                sys.exit(LEFT_OUT)
            raise AssertionError(f"{self.address!r} {error}")
        self.port, self.token = int(match[1]), match[2]
        self.update()
        return self

    def __exit__(self, *problem):
        if self.process.poll() is None:
            self.process.send_signal(signal.SIGTERM)
        try:
            self.process.communicate(timeout=20)
        except subprocess.TimeoutExpired:
            self.process.kill()
            raise

    def request(self, what, body=None, path=None, **headers):
        """(status, headers, bytes) of an address below the page's, or of a whole path."""
        url = f"http://127.0.0.1:{self.port}{path}" if path is not None else self.address + what
        data = body if body is None or isinstance(body, bytes) else json.dumps(body).encode()
        if data is not None:
            headers = {"Content-Type": "application/json", **headers}
        asked = urllib.request.Request(url, data, {name.replace("_", "-"): value for name, value in headers.items()})
        try:
            with urllib.request.urlopen(asked, timeout=40) as answer:
                return answer.status, answer.headers, answer.read()
        except urllib.error.HTTPError as answer:
            return answer.code, answer.headers, answer.read()
        except urllib.error.URLError as error:
            if not isinstance(error.reason, (BrokenPipeError, ConnectionResetError)):
                raise
            return 0, {}, b""  # refused while the body was still on its way

    def get(self, what):
        status, _, body = self.request(what)
        assert status == 200, (what, status, body)
        return json.loads(body)

    def post(self, what, **keys):
        """(status, JSON)"""
        status, _, body = self.request(what, keys)
        return status, json.loads(body)

    def update(self):
        self.state = self.get("state")
        return self.state

    def change(self, what, **keys):
        """Of the newest revision. Returns the status; of 200 the state is the new one."""
        status, answer = self.post(what, revision=self.state["revision"], **keys)
        self.answer = answer
        if status == 200:
            self.state = answer
            assert self.graph.read_bytes().decode("utf-8-sig" if answer["text"][:1] != "\ufeff" else "utf-8") == \
                answer["text"], "the file is not what the state says"
        return status

    def edit(self, *edits):
        return self.change("edit", edits=list(edits))

    def raw(self, data, timeout=20):
        """The server's answer to these bytes until it closes."""
        with socket.create_connection(("127.0.0.1", self.port), timeout=timeout) as peer:
            received = b""
            try:
                peer.sendall(data)
            except (BrokenPipeError, ConnectionResetError):
                pass  # it has refused what came first
            try:
                while part := peer.recv(65536):
                    received += part
            except ConnectionResetError:
                pass
            return received
