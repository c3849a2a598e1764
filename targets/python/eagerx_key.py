"""Connection with a key, on the listening side: the key file, the greeting, and records, as specified in the section
"With a key" of targets/PROTOCOL.md. libsodium provides all cryptography, through ctypes.

This module handles bytes and opens no sockets. It raises KeyProblem for an unusable key, Stranger for a peer without
the key, and Forged for data that the peer did not send.
"""
import ctypes
import os
import stat
import struct

TITLE = b"eagerx-key-link1"
FROM_LISTENER, FROM_CONNECTOR = b"eagerx link 1: from who listens.", b"eagerx link 1: from who connects"
MOST_BYTES = 4096  # per record
_KEY_TITLE, _DIGITS = b"eagerx-gen key 1 ", b"0123456789abcdef"
_KEY_FILE_BYTES = len(_KEY_TITLE) + 64 + 1
_MAKE_ONE = "\nhelp: `eagerx-gen key new FILE` writes one"
# From the headers of libsodium 1.0.18, the version in Debian 12 and 13.
_LIBRARY = "libsodium.so.23"
_PUBLIC, _SECRET, _SHARED, _STREAM_KEY, _HEAD, _SEAL, _STATE = 32, 32, 32, 32, 24, 17, 52
_MESSAGE, _FINAL = 0, 3
_LENGTH = struct.Struct("<H")
_HELLO, _PROOF = len(TITLE) + _PUBLIC, _HEAD + _SEAL
_STREAM = "crypto_secretstream_xchacha20poly1305_"
_BYTES, _SIZE, _MANY, _TAG = ctypes.c_void_p, ctypes.c_size_t, ctypes.c_ulonglong, ctypes.c_ubyte
_FUNCTIONS = {  # name → argument types; each function returns an int, 0 for success
    "sodium_init": [],
    "crypto_kx_keypair": [_BYTES] * 2,
    "crypto_kx_server_session_keys": [_BYTES] * 5,
    "crypto_generichash": [_BYTES, _SIZE, _BYTES, _MANY, _BYTES, _SIZE],
    _STREAM + "init_push": [_BYTES] * 3,
    _STREAM + "init_pull": [_BYTES] * 3,
    _STREAM + "push": [_BYTES, _BYTES, _BYTES, _BYTES, _MANY, _BYTES, _MANY, _TAG],
    _STREAM + "pull": [_BYTES, _BYTES, _BYTES, _BYTES, _BYTES, _MANY, _BYTES, _MANY],
}
_SIZES = {_STREAM + "statebytes": _STATE, _STREAM + "headerbytes": _HEAD, _STREAM + "abytes": _SEAL}


class KeyProblem(Exception):
    """The key, or the library that it needs, is unusable."""


class Stranger(Exception):
    """The peer does not have the key."""


class Forged(Exception):
    """The bytes received are not the next ones that the peer sent."""


class _Sodium:
    """The library, loaded when a key is used."""

    def __init__(self):
        missing = KeyProblem(f"a key needs the library libsodium, `{_LIBRARY}`\nhelp: apt install libsodium23")
        try:
            library = ctypes.CDLL(_LIBRARY)
            for name, arguments in _FUNCTIONS.items():
                function = library[name]  # indexing returns a new object each time
                function.argtypes, function.restype = arguments, ctypes.c_int
                setattr(self, name.replace(_STREAM, ""), function)
            for name, size in _SIZES.items():
                function = library[name]
                function.argtypes, function.restype = [], _SIZE
                if function() != size:
                    raise missing
        except (OSError, AttributeError):
            raise missing from None
        if self.sodium_init() < 0:
            raise missing


def _room(size):
    return ctypes.create_string_buffer(size)


def _wipe(*rooms):
    for room in rooms:
        ctypes.memset(room, 0, len(room))


def _read_key(path):
    """Reads the 32 bytes of the key from a file that only this user can access."""
    file = os.open(path, os.O_RDONLY | os.O_CLOEXEC | os.O_NONBLOCK | os.O_NOCTTY)  # a FIFO would block
    try:
        status = os.fstat(file)
        if not stat.S_ISREG(status.st_mode):
            raise KeyProblem("it is not a file" + _MAKE_ONE)
        if status.st_uid != os.geteuid():
            raise KeyProblem("it belongs to another user\nhelp: make a copy for each user: `install -m 600 FILE COPY`")
        if status.st_mode & (stat.S_IRWXG | stat.S_IRWXO):
            raise KeyProblem(f"others can read it, or write it\nhelp: chmod 600 {path}; if others may have read it, "
                             "take a new key")
        text = os.read(file, _KEY_FILE_BYTES + 1)
    finally:
        os.close(file)
    if len(text) != _KEY_FILE_BYTES:
        more = " or more" if len(text) > _KEY_FILE_BYTES else ""
        raise KeyProblem(f"it is not a key: it has {len(text)} bytes{more}, a key has {_KEY_FILE_BYTES}{_MAKE_ONE}")
    digits = text[len(_KEY_TITLE):-1]
    if not text.startswith(_KEY_TITLE) or text[-1:] != b"\n" or digits.strip(_DIGITS):
        raise KeyProblem(f"it is not a key: a key is a line `{_KEY_TITLE.decode()}` and 64 of the digits {_DIGITS.decode()}"
                         + _MAKE_ONE)
    return bytes.fromhex(digits.decode("ascii"))


class Key:
    """Key from a file, and the library that uses it."""

    def __init__(self, path):
        self.sodium = _Sodium()
        try:
            self.bytes = _read_key(path)
        except OSError as error:
            raise KeyProblem(f"cannot use the key `{path}`: {error.strerror}"
                             + (_MAKE_ONE if isinstance(error, FileNotFoundError) else "")) from None
        except KeyProblem as problem:
            raise KeyProblem(f"cannot use the key `{path}`: {problem}") from None


class Greeting:
    """First bytes in each direction. `is_done`: the peer has proved that it has the key and is live."""

    def __init__(self, key):
        self._sodium, self._key = key.sodium, key.bytes
        self._own, self._secret = _room(_PUBLIC), _room(_SECRET)
        self._sodium.crypto_kx_keypair(self._own, self._secret)
        self._taken = b""
        self._said = None  # title and public keys of both sides: everything sent in plain text
        self._in_key, self._in, self._out = _room(_STREAM_KEY), _room(_STATE), _room(_STATE)
        self.is_done = False

    def wanted(self):
        """Number of bytes needed before the next action; 0 if the greeting reads no more."""
        return 0 if self.is_done else (_HELLO if self._said is None else _PROOF) - len(self._taken)

    def take(self, data):
        """Takes at most wanted() bytes and returns the bytes to send. Raises Stranger if the peer does not have the
        key."""
        self._taken += data
        if self._said is None and not self._taken.startswith(TITLE[:len(self._taken)]):
            raise Stranger  # a peer that begins differently is rejected at once
        if self.wanted() > 0:
            return b""
        taken, self._taken = self._taken, b""
        if self._said is None:
            return self._answer(taken[len(TITLE):])
        self._check_proof(taken)
        return b""

    def go_on(self):
        """Records that follow the greeting."""
        return Records(self._sodium, self._out, self._in)

    def _answer(self, other):
        own = self._own.raw
        received, sent = _room(_SHARED), _room(_SHARED)
        # Rejects our own public key sent back, and weak keys, which are never sampled.
        if own == other or self._sodium.crypto_kx_server_session_keys(received, sent, self._own, self._secret, other):
            raise Stranger
        self._said = TITLE + other + own
        out_key, head, proof = _room(_STREAM_KEY), _room(_HEAD), _room(_SEAL)
        self._mix(FROM_CONNECTOR, received, self._in_key)
        self._mix(FROM_LISTENER, sent, out_key)
        self._sodium.init_push(self._out, head, out_key)
        self._sodium.push(self._out, proof, None, b"", 0, self._said, len(self._said), _MESSAGE)
        _wipe(received, sent, out_key, self._secret)
        return own + head.raw + proof.raw

    def _mix(self, direction, shared, stream_key):
        """Derives the key of one direction, with the key of the file."""
        text = direction + shared.raw + self._said
        self._sodium.crypto_generichash(stream_key, _STREAM_KEY, text, len(text), self._key, len(self._key))

    def _check_proof(self, proof):
        tag, nothing = _TAG(), _room(1)
        refused = self._sodium.init_pull(self._in, proof[:_HEAD], self._in_key)
        _wipe(self._in_key)
        if refused or self._sodium.pull(self._in, nothing, None, ctypes.byref(tag), proof[_HEAD:], _SEAL, self._said,
                                        len(self._said)) or tag.value != _MESSAGE:
            raise Stranger
        self.is_done = True


class Records:
    """Records of at most MOST_BYTES in each direction, each encrypted and authenticated."""

    def __init__(self, sodium, out, into):
        self._sodium, self._out, self._in = sodium, out, into
        self._taken = bytearray()
        self._is_over = False

    def seal(self, data):
        """Encrypts one record. An empty record is the last one."""
        length = _LENGTH.pack(len(data))  # authenticated, too
        sealed = _room(len(data) + _SEAL)
        self._sodium.push(self._out, sealed, None, data, len(data), length, len(length), _MESSAGE if data else _FINAL)
        return length + sealed.raw

    def take(self, data):
        """Adds received bytes."""
        self._taken += data

    def open(self):
        """Returns the bytes of the next record, b"" if the peer announces the end, or None if the record is incomplete.
        Raises Forged if the peer did not send it, and reads nothing after it."""
        if self._is_over:
            raise Forged
        if len(self._taken) < _LENGTH.size:
            return None
        head = bytes(self._taken[:_LENGTH.size])
        size, = _LENGTH.unpack(head)
        self._is_over = size > MOST_BYTES
        whole = _LENGTH.size + size + _SEAL
        if self._is_over:
            raise Forged
        if len(self._taken) < whole:
            return None
        tag, data = _TAG(), _room(size or 1)
        refused = self._sodium.pull(self._in, data, None, ctypes.byref(tag), bytes(self._taken[_LENGTH.size:whole]),
                                    size + _SEAL, head, len(head))
        del self._taken[:whole]
        self._is_over = bool(refused) or size == 0 or tag.value != _MESSAGE
        if refused or (size == 0) != (tag.value == _FINAL) or tag.value not in (_MESSAGE, _FINAL):
            raise Forged
        return data.raw[:size]
