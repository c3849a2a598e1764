"""A client of the Language Server Protocol, of the standard library."""
import json
import os
import pathlib
import subprocess

ROOT = pathlib.Path(__file__).resolve().parents[2]


class Client:
    """Starts `eagerx-gen lsp`. `diagnostics`: {uri: the last list}, with their `versions`."""

    def __init__(self, eagerx_gen, *options):
        self.process = subprocess.Popen([eagerx_gen, "lsp", *options], stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                                        env={**os.environ, "EAGERX_HOME": str(ROOT)})
        self.diagnostics, self.versions, self.calls = {}, {}, 0

    def __enter__(self):
        self.capabilities = self.ask("initialize", processId=None, rootUri=None, capabilities={})["capabilities"]
        self.tell("initialized")
        return self

    def __exit__(self, *problem):
        self.process.kill()
        self.process.communicate()

    def send(self, content):
        content = content if isinstance(content, bytes) else json.dumps(content).encode()
        self.process.stdin.write(b"Content-Length: %d\r\n\r\n" % len(content) + content)
        self.process.stdin.flush()

    def receive(self):
        length = 0
        while line := self.process.stdout.readline().strip():
            name, value = line.split(b": ")
            assert name == b"Content-Length", line
            length = int(value)
        if length == 0:
            raise EOFError("the server has ended")
        message = json.loads(self.process.stdout.read(length))
        assert message["jsonrpc"] == "2.0", message
        if message.get("method") == "textDocument/publishDiagnostics":
            params = message["params"]
            self.diagnostics[params["uri"]] = params["diagnostics"]
            self.versions[params["uri"]] = params.get("version")
        return message

    def tell(self, method, **params):
        self.send({"jsonrpc": "2.0", "method": method, "params": params})

    def call(self, method, **params):
        """The whole answer."""
        self.calls += 1
        self.send({"jsonrpc": "2.0", "id": self.calls, "method": method, "params": params})
        while (message := self.receive()).get("id") != self.calls:
            pass
        return message

    def ask(self, method, **params):
        answer = self.call(method, **params)
        assert "error" not in answer, answer
        return answer["result"]

    def open(self, path, text=None, version=1):
        """The URI of a file whose text need not be what the disk has."""
        uri = pathlib.Path(path).resolve().as_uri()
        self.tell("textDocument/didOpen", textDocument={"uri": uri, "languageId": "yaml", "version": version,
                                                        "text": pathlib.Path(path).read_text() if text is None else text})
        return uri

    def change(self, uri, version, *changes):
        """Each the whole text, or (start, end, text) with (line, character)."""
        def position(at):
            return {"line": at[0], "character": at[1]}
        self.tell("textDocument/didChange", textDocument={"uri": uri, "version": version}, contentChanges=[
            {"text": each} if isinstance(each, str) else
            {"range": {"start": position(each[0]), "end": position(each[1])}, "text": each[2]} for each in changes])

    def at(self, method, uri, line, character, **params):
        return self.ask(f"textDocument/{method}", textDocument={"uri": uri}, position={"line": line, "character": character}, **params)

    def complete(self, uri, line, character):
        return [item["label"] for item in self.at("completion", uri, line, character)["items"]]

    def checked(self, uri, version=1):
        """The diagnostics of this version of a document."""
        while self.versions.get(uri) != version:
            self.receive()
        return self.diagnostics[uri]

    def end(self):
        assert self.ask("shutdown") is None
        self.tell("exit")
        assert self.process.wait(10) == 0, self.process.returncode
