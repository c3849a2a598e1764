"""Connection to the hub: a socket, with or without a key, or a serial line.

The end of the connection raises LinkClosed, and data on an encrypted connection that the hub did not send LinkForged.
"""
import errno
import fcntl
import os
import select
import socket
import stat
import sys
import termios
import time

from eagerx_key import MOST_BYTES, Forged, Greeting, Stranger

GREETING_S = 5  # time for a peer to send its first bytes, or to prove that it has the key
WRITE_S = 1  # time after which bytes that the peer does not accept are dropped
MOST_UNKNOWN = 16  # connections that have not yet proved that they have the key
NEEDS_KEY = ("beyond this machine TCP needs a key\n"
             "help: `eagerx-gen key new FILE` writes one; both sides take it with `--key FILE`")
_READ_BYTES = 65536


class LinkClosed(Exception):
    """The connection has ended."""


class LinkForged(LinkClosed):
    """A third party changes the data."""


def say(text):
    print(text, file=sys.stderr, flush=True)


class Port:
    """Byte stream over a socket or a serial line."""

    def __init__(self, file, knows_peer, keep=None):
        self.file, self._keep = file, keep
        self.knows_peer = knows_peer  # only the peer can be at the other end
        os.set_blocking(file, False)

    def read(self):
        """Waits for bytes and returns them."""
        while True:
            select.select([self.file], [], [])
            try:
                data = os.read(self.file, _READ_BYTES)
            except BlockingIOError:
                continue
            except OSError as error:
                raise LinkClosed(error.strerror) from None
            if not data:
                raise LinkClosed("the other end hung up")
            return data

    def send(self, data, until):
        """Sends bytes until a time of time.monotonic(). Returns those that it could not send."""
        while data:
            try:
                data = data[os.write(self.file, data):]
            except BlockingIOError:
                left = until - time.monotonic()
                if left <= 0:
                    break
                select.select([], [self.file], [], left)
            except OSError as error:
                raise LinkClosed(error.strerror) from None
        return data

    def write(self, data):
        """Drops bytes that the peer does not accept in time: the hub sends its request again."""
        self.send(data, time.monotonic() + WRITE_S)

    def close(self):
        """Sends nothing: this connection has no announced end."""


class SealedPort:
    """Socket between two peers that share a key."""

    def __init__(self, port, records):
        self._port, self._records, self.knows_peer = port, records, True
        self._rest = b""  # of an encrypted record: records have a fixed order, so the rest is sent first

    def read(self):
        while True:
            try:
                data = self._records.open()
            except Forged:
                raise LinkForged("a third party changed, repeated or removed data") from None
            if data is not None:
                if not data:
                    raise LinkClosed("the other end hung up")
                return data
            try:
                self._records.take(self._port.read())
            except LinkClosed as end:
                raise LinkClosed(f"it was cut, without an announced end: {end}") from None

    def write(self, data):
        """Drops data that is late before encryption, because encrypted records must arrive without gaps."""
        until = time.monotonic() + WRITE_S
        for begin in range(0, len(data), MOST_BYTES):
            self._rest = self._port.send(self._rest, until)
            if self._rest:
                return
            self._rest = self._port.send(self._records.seal(data[begin:begin + MOST_BYTES]), until)

    def close(self):
        """Announces a regular end, as opposed to an interrupted connection."""
        if self._rest:
            return
        try:
            self._port.send(self._records.seal(b""), 0)
        except LinkClosed:
            pass


def _first_that_speaks(listener):
    """First peer that sends anything; later peers are rejected."""
    while True:
        peer, _ = listener.accept()
        ready, _, _ = select.select([peer], [], [], GREETING_S)
        try:
            if ready and peer.recv(1, socket.MSG_PEEK):
                listener.close()
                return Port(peer.fileno(), False, peer)
        except OSError:
            pass
        say("note: a peer hung up before it sent anything" if ready else
            f"note: a peer said nothing for {GREETING_S} s and was dropped")
        peer.close()


class _Door:
    """Accepts the first peer that has the key."""

    def __init__(self, listener, key):
        self._listener, self._key = listener, key
        self._unknown = {}  # socket → (deadline, Greeting), oldest first
        self._dropped, self._next_note = 0, 1
        listener.setblocking(False)

    def wait(self):
        """SealedPort to the peer."""
        try:
            while True:
                left = min((until for until, _ in self._unknown.values()), default=None)
                ready, _, _ = select.select([self._listener, *self._unknown], [], [],
                                            left and max(0, left - time.monotonic()))
                for peer in ready:
                    if peer in self._unknown and self._is_known(peer):
                        return SealedPort(Port(peer.fileno(), True, peer), self._unknown.pop(peer)[1].go_on())
                self._drop_late()
                if self._listener in ready:
                    self._let_in()
        finally:
            for peer in self._unknown:
                peer.close()
            self._listener.close()

    def _is_known(self, peer):
        greeting = self._unknown[peer][1]
        try:
            data = peer.recv(greeting.wanted())
            answer = greeting.take(data) if data else b""
            if data and peer.send(answer) == len(answer):  # a new connection has room for it
                return greeting.is_done
            self._drop(peer, "hung up before it authenticated")
        except BlockingIOError:
            pass
        except Stranger:
            self._drop(peer, "does not have the key")
        except OSError:
            self._drop(peer, "hung up before it authenticated")
        return False

    def _drop_late(self):
        now = time.monotonic()
        for peer in [peer for peer, (until, _) in self._unknown.items() if until <= now]:
            self._drop(peer, f"did not authenticate within {GREETING_S} s")

    def _drop(self, peer, why):
        peer.close()
        del self._unknown[peer]
        self._dropped += 1
        if self._dropped == self._next_note:  # limits the log that repeated connections write
            self._next_note *= 10
            say(f"note: dropped a peer that {why}" +
                ("" if self._dropped == 1 else f"; {self._dropped} dropped so far"))

    def _let_in(self):
        try:
            peer, _ = self._listener.accept()
        except OSError:
            return  # a failed connection does not affect the listener
        if len(self._unknown) == MOST_UNKNOWN:
            self._drop(next(iter(self._unknown)), "waited longest of too many")
        peer.setblocking(False)
        self._unknown[peer] = (time.monotonic() + GREETING_S, Greeting(self._key))


def _is_alive(path):
    """True if a program listens on this socket: connecting a datagram socket to it fails, but only a dead one
    refuses."""
    with socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM) as probe:
        try:
            probe.connect(path)
        except ConnectionRefusedError:
            return False
        except OSError:
            return True
        return True


def _listen_unix(path):
    listener = socket.socket(socket.AF_UNIX, socket.SOCK_STREAM)
    folder = os.open(os.path.dirname(path) or ".", os.O_RDONLY | os.O_DIRECTORY)
    try:
        fcntl.flock(folder, fcntl.LOCK_EX)  # two programs must not remove each other's socket
        if os.path.lexists(path):
            if not stat.S_ISSOCK(os.lstat(path).st_mode) or _is_alive(path):
                raise OSError(errno.EADDRINUSE, "another program listens on it, or it is not a socket")
            os.unlink(path)
        if os.path.lexists(path + "~") and stat.S_ISSOCK(os.lstat(path + "~").st_mode):
            os.unlink(path + "~")
        os.fchmod(listener.fileno(), 0o600)  # only its owner can connect, from the beginning
        listener.bind(path + "~")
        listener.listen(1)
        os.rename(path + "~", path)  # a peer can connect as soon as the socket is visible
    finally:
        os.close(folder)
    say(f"listens on unix:{path}")
    return _first_that_speaks(listener)


def _is_of_this_machine(host):
    return host.startswith("127.") or host.startswith("::ffff:127.") or host == "::1"


def _tcp_listener(address, key):
    host, _, port = address.rpartition(":")
    if not port.isdecimal() or int(port) > 65535:
        raise OSError(errno.EINVAL, "it is neither unix:PATH nor HOST:PORT")
    problem = None
    for family, kind, protocol, _, where in socket.getaddrinfo(host.strip("[]") or "localhost", int(port),
                                                               type=socket.SOCK_STREAM):
        if key is None and not _is_of_this_machine(where[0]):
            raise OSError(errno.EACCES, NEEDS_KEY)
        try:
            listener = socket.socket(family, kind, protocol)
            listener.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
            listener.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)  # accepted sockets inherit it
            listener.bind(where)
            listener.listen(1 if key is None else 128)
            return listener
        except OSError as error:
            problem = error
    raise problem


def _listen_tcp(address, key):
    listener = _tcp_listener(address, key)
    host, port = listener.getsockname()[:2]
    said = f"[{host}]" if ":" in host else host
    say(f"listens on {said}:{port}, " + ("for this machine only" if key is None else "for holders of the key"))
    return _first_that_speaks(listener) if key is None else _Door(listener, key).wait()


def is_tcp_address(address):
    """True if an address has the form HOST:PORT."""
    return not address.startswith("unix:") and "/" not in address and ":" in address


def listen(address, key=None):
    """Waits for the only peer at `unix:PATH`, `:PORT` of this machine, or HOST:PORT, which needs a Key beyond this
    machine."""
    return _listen_unix(address[5:]) if address.startswith("unix:") else _listen_tcp(address, key)


def open_serial(path, baud):
    """Port over a serial line, with exclusive access."""
    speed = getattr(termios, f"B{baud}", 0)
    if speed == 0:
        raise OSError(errno.EINVAL, "Linux has no such baud rate")
    file = os.open(path, os.O_RDWR | os.O_NOCTTY | os.O_NONBLOCK)
    try:
        settings = termios.tcgetattr(file)
    except termios.error:
        raise OSError(errno.ENOTTY, "it is not a serial line") from None
    try:
        fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)  # also excludes root, to which TIOCEXCL does not apply
    except BlockingIOError:
        raise OSError(errno.EBUSY, "another program uses it") from None
    fcntl.ioctl(file, termios.TIOCEXCL)
    settings[0] = settings[1] = settings[3] = 0
    settings[2] = termios.CS8 | termios.CLOCAL | termios.CREAD
    settings[4] = settings[5] = speed
    settings[6][termios.VMIN], settings[6][termios.VTIME] = 1, 0
    termios.tcsetattr(file, termios.TCSANOW, settings)
    termios.tcflush(file, termios.TCIOFLUSH)
    return Port(file, True)
