"""The sealed line of runtime/host/key/README.md, in Python: a second one besides that in C++, which the tests speak with.

    line = Sealed(socket, key_of("camera.key"), connects=True)
    line.send(bytes_of_the_link); data = line.receive()

libsodium is called through ctypes, so there is no package to install but libsodium23."""
import ctypes
import hashlib
import struct

TITLE = b"eagerx-key-link1"
FROM_LISTENER, FROM_CONNECTOR = b"eagerx link 1: from who listens.", b"eagerx link 1: from who connects"
PUBLIC, HEAD, SEAL, STATE, MOST = 32, 24, 17, 52, 4096
HELLO, PROOF = len(TITLE) + PUBLIC, HEAD + SEAL
ANSWER = PUBLIC + PROOF
MESSAGE, FINAL = 0, 3
STREAM = "crypto_secretstream_xchacha20poly1305_"

sodium = ctypes.CDLL("libsodium.so.23")
if sodium.sodium_init() < 0:
    raise RuntimeError("libsodium does not begin")


class Refused(Exception):
    """The peer does not have the key, or the data were changed on the way."""


def key_of(path):
    with open(path, encoding="ascii") as file:
        text = file.read()
    if not text.startswith("eagerx-gen key 1 ") or len(text) != 82:
        raise ValueError(path + " is not a key")
    return bytes.fromhex(text[17:81])


def receive_exactly(connection, size):
    data = b""
    while len(data) < size:
        more = connection.recv(size - len(data))
        if not more:
            raise Refused("hung up")
        data += more
    return data


class Out:
    def __init__(self, key):
        self.state = ctypes.create_string_buffer(STATE)
        head = ctypes.create_string_buffer(HEAD)
        sodium[STREAM + "init_push"](self.state, head, key)
        self.head = head.raw

    def seal(self, data, also, tag=MESSAGE):
        sealed = ctypes.create_string_buffer(len(data) + SEAL)
        sodium[STREAM + "push"](self.state, sealed, None, data, ctypes.c_ulonglong(len(data)), also,
                                ctypes.c_ulonglong(len(also)), ctypes.c_ubyte(tag))
        return sealed.raw


class In:
    def __init__(self, key, head):
        self.state = ctypes.create_string_buffer(STATE)
        sodium[STREAM + "init_pull"](self.state, head, key)

    def open(self, sealed, also):
        """(data, tag)"""
        data, tag = ctypes.create_string_buffer(max(1, len(sealed) - SEAL)), ctypes.c_ubyte()
        if sodium[STREAM + "pull"](self.state, data, None, ctypes.byref(tag), sealed, ctypes.c_ulonglong(len(sealed)),
                                   also, ctypes.c_ulonglong(len(also))):
            raise Refused("not what the other end sent")
        return data.raw[:len(sealed) - SEAL], tag.value


class Sealed:
    """A line to a peer that has the key; Refused for any other peer."""

    def __init__(self, connection, key, connects):
        self.connection = connection
        own, secret = ctypes.create_string_buffer(PUBLIC), ctypes.create_string_buffer(PUBLIC)
        sodium.crypto_kx_keypair(own, secret)
        own = own.raw
        if connects:
            connection.sendall(TITLE + own)
            other = receive_exactly(connection, PUBLIC)
        else:
            if receive_exactly(connection, len(TITLE)) != TITLE:
                raise Refused("another greeting")
            other = receive_exactly(connection, PUBLIC)
        said = TITLE + (own + other if connects else other + own)
        received, sent = ctypes.create_string_buffer(32), ctypes.create_string_buffer(32)
        exchange = sodium.crypto_kx_client_session_keys if connects else sodium.crypto_kx_server_session_keys
        if own == other or exchange(received, sent, own, secret, other):
            raise Refused("no peer generates such a number")

        def mix(direction, shared):
            return hashlib.blake2b(direction + shared.raw + said, key=key, digest_size=32).digest()

        out_of, into = (FROM_CONNECTOR, FROM_LISTENER) if connects else (FROM_LISTENER, FROM_CONNECTOR)
        self.out = Out(mix(out_of, sent))
        proof = self.out.head + self.out.seal(b"", said)
        if not connects:
            connection.sendall(own + proof)
        theirs = receive_exactly(connection, PROOF)
        self.into = In(mix(into, received), theirs[:HEAD])
        if self.into.open(theirs[HEAD:], said) != (b"", MESSAGE):
            raise Refused("no proof")
        if connects:
            connection.sendall(proof)

    def send(self, data):
        for begin in range(0, len(data), MOST):
            piece = data[begin:begin + MOST]
            length = struct.pack("<H", len(piece))
            self.connection.sendall(length + self.out.seal(piece, length))

    def receive(self):
        """The contents of one record; empty at the end."""
        length = receive_exactly(self.connection, 2)
        size = struct.unpack("<H", length)[0]
        data, tag = self.into.open(receive_exactly(self.connection, size + SEAL), length)
        if (tag == FINAL) != (not data) or tag not in (MESSAGE, FINAL):
            raise Refused("a record that is never sent")
        return data

    def end(self):
        """Says that nothing comes any more."""
        length = struct.pack("<H", 0)
        self.connection.sendall(length + self.out.seal(b"", length, FINAL))
