"""A client of Foxglove's WebSocket protocol (RFC 6455 and https://github.com/foxglove/ws-protocol), of the standard library."""
import base64
import json
import os
import socket
import struct
import time

PATIENCE_S = 10


class Refused(Exception):
    pass


def connected(port, receive_buffer=None):
    """To a program that may have only just begun."""
    give_up = time.monotonic() + PATIENCE_S
    while True:
        here = socket.socket()
        if receive_buffer:
            here.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, receive_buffer)
        here.settimeout(PATIENCE_S)
        try:
            here.connect(("127.0.0.1", port))
            return here
        except ConnectionRefusedError:
            here.close()
            if time.monotonic() > give_up:
                raise
            time.sleep(0.01)


class WebSocket:
    def __init__(self, port, path="/", protocol="foxglove.websocket.v1", headers=(), receive_buffer=None, after=b""):
        """`after`: what is sent with the handshake."""
        self.socket = connected(port, receive_buffer)
        lines = [f"GET {path} HTTP/1.1", f"Host: 127.0.0.1:{port}", "Upgrade: websocket", "Connection: Upgrade",
                 f"Sec-WebSocket-Key: {base64.b64encode(os.urandom(16)).decode()}", "Sec-WebSocket-Version: 13", *headers]
        if protocol:
            lines.append(f"Sec-WebSocket-Protocol: {protocol}")
        self.socket.sendall(("\r\n".join(lines) + "\r\n\r\n").encode() + after)
        self.buffer = b""
        try:
            while b"\r\n\r\n" not in self.buffer:
                self.read_more()
        except (ConnectionError, TimeoutError) as error:
            raise Refused() from error
        head, self.buffer = bytes(self.buffer).split(b"\r\n\r\n", 1)
        self.at = 0  # of the buffer: what comes before is taken
        if b" 101 " not in head.split(b"\r\n")[0]:
            raise Refused(head)

    def read_more(self):
        more = self.socket.recv(1 << 16)
        if not more:
            raise ConnectionError("closed")
        self.buffer += more

    def read(self, size):
        if len(self.buffer) - self.at < size:
            self.buffer, self.at = self.buffer[self.at :], 0
            while len(self.buffer) < size:
                self.read_more()
        self.at += size
        return self.buffer[self.at - size : self.at]

    def receive_frame(self):
        """(first byte, bytes) of the next frame; ConnectionError when there is none."""
        first, size = self.read(2)
        assert size < 128, "a server's frame is masked"
        if size == 126:
            size = struct.unpack(">H", self.read(2))[0]
        elif size == 127:
            size = struct.unpack(">Q", self.read(8))[0]
        return first, self.read(size)

    def reason(self):
        """The number in the frame that closes."""
        while True:
            first, data = self.receive_frame()
            if first & 15 == 8:
                return struct.unpack(">H", data[:2])[0]

    def receive(self):
        """(opcode, bytes) of the next message; ConnectionError when there is none."""
        whole, opcode = b"", 0
        while True:
            first, data = self.receive_frame()
            if first & 15 == 8:
                raise ConnectionError(f"closed, {struct.unpack('>H', data[:2])[0] if data else 'without a reason'}")
            if first & 15 == 9:
                self.send(data, 10)
                continue
            if first & 15 == 10:
                continue
            opcode = first & 15 or opcode
            whole += data
            if first & 128:
                return opcode, whole

    def send(self, data, opcode=1, final=True, size=None):
        """`size`: what the frame says that it has."""
        data = data.encode() if isinstance(data, str) else data
        size = len(data) if size is None else size
        head = bytes([opcode | (128 if final else 0)])
        if size < 126:
            head += bytes([128 | size])
        elif size < 65536:
            head += bytes([128 | 126]) + struct.pack(">H", size)
        else:
            head += bytes([128 | 127]) + struct.pack(">Q", size)
        mask = os.urandom(4)
        self.socket.sendall(head + mask + bytes(b ^ mask[i % 4] for i, b in enumerate(data)))

    def is_closed_within(self, seconds):
        """Whatever else comes."""
        give_up = time.monotonic() + seconds
        self.socket.settimeout(seconds)
        try:
            while time.monotonic() < give_up:
                self.receive()
        except ConnectionError:
            self.close()
            return True
        except TimeoutError:
            pass
        return False

    def close(self):
        self.socket.close()


class Foxglove(WebSocket):
    """The data received so far: `channels` {topic: …}, `services` {name: …}, `messages` {topic: [(time in ns, JSON)]}, `times`,
    `parameters` {name: value}, `problems` [text], `answers` {call: JSON or text}."""

    def __init__(self, port, **options):
        super().__init__(port, **options)
        self.info, self.channels, self.services, self.parameters = {}, {}, {}, {}
        self.messages, self.times, self.problems, self.answers, self.values = {}, [], [], {}, {}
        self.topics, self.order, self.calls = {}, [], 0
        self.until(lambda: self.channels or "channels" in self.info)

    def say(self, op, **members):
        self.send(json.dumps({"op": op, **members}))

    def take(self):
        opcode, data = self.receive()
        if opcode == 2:
            return self.take_bytes(data)
        said = json.loads(data)
        op = said["op"]
        if op == "serverInfo":
            self.info = said
        elif op == "advertise":
            self.channels = {channel["topic"]: channel for channel in said["channels"]}
            self.info["channels"] = True
        elif op == "advertiseServices":
            self.services = {service["name"]: service for service in said["services"]}
        elif op == "parameterValues":
            self.parameters |= {each["name"]: each.get("value") for each in said["parameters"]}
            self.values[said.get("id")] = said["parameters"]
        elif op == "status":
            self.problems.append(said["message"])
        elif op == "serviceCallFailure":
            self.answers[said["callId"]] = said["message"]
        else:
            raise AssertionError(said)

    def take_bytes(self, data):
        if data[0] == 1:
            subscription, when = struct.unpack_from("<IQ", data, 1)
            topic = self.topics[subscription]
            self.messages.setdefault(topic, []).append((when, json.loads(data[13:])))
            self.order.append(topic)
        elif data[0] == 2:
            self.times.append(struct.unpack_from("<Q", data, 1)[0])
        elif data[0] == 3:
            _, call, size = struct.unpack_from("<III", data, 1)
            assert data[13 : 13 + size] == b"json"
            self.answers[call] = json.loads(data[13 + size :])
        else:
            raise AssertionError(data)

    def until(self, condition):
        give_up = time.monotonic() + PATIENCE_S
        while not condition():
            assert time.monotonic() < give_up, (condition, self.problems)
            self.take()

    def to_the_end(self):
        try:
            while True:
                self.take()
        except ConnectionError:
            self.close()

    def subscribe(self, topics):
        """Numbers of subscriptions are not those of channels."""
        first = 100 + len(self.topics)
        ids = dict(enumerate(topics, first))
        self.topics |= ids
        self.say("subscribe", subscriptions=[{"id": i, "channelId": self.channels[t]["id"]} for i, t in ids.items()])

    def call(self, name, request=b"{}"):
        """The answer, JSON or the text of a failure."""
        self.calls += 1
        service = self.services[name]["id"]
        self.send(struct.pack("<BIII", 2, service, self.calls, 4) + b"json" + request, 2)
        number = self.calls
        self.until(lambda: number in self.answers)
        return self.answers[number]

    def get(self, *names):
        """{name: value}, asked for anew."""
        self.calls += 1
        key = f"get{self.calls}"
        self.say("getParameters", parameterNames=names, id=key)
        self.until(lambda: key in self.values)
        return {each["name"]: each.get("value") for each in self.values[key]}

    def set(self, **values):
        """Names with `__` for a dot; None: no longer set. What the server then says that they are."""
        return self.set_named({name.replace("__", "."): value for name, value in values.items()})

    def set_named(self, values):
        self.calls += 1
        key = f"set{self.calls}"
        parameters = [{"name": n} if v is None else {"name": n, "value": v} for n, v in values.items()]
        self.say("setParameters", parameters=parameters, id=key)
        self.until(lambda: key in self.values)
        return {each["name"]: each.get("value") for each in self.values[key]}
