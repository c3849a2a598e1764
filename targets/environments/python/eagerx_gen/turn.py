"""One thread at a time, wherever an interrupt comes."""
from __future__ import annotations

import itertools
import threading

from .errors import Error

BUSY = "another thread is in a call with these environments"


class _Taken(dict):
    def __missing__(self, _taken):
        raise Error(BUSY)


def turn():
    """`with` it: of the thread that is in a call; for another one, an Error at once. The same one may come again.

    Python looks for signals behind each call that its code makes. So a lock that Python code takes, or `try` behind
    acquire(), stays locked when Ctrl-C comes between the two. `with` has no such place as long as nothing that enters and
    leaves is Python code: acquire(False) and a look at what it gave are one call of a `map`.
    """
    lock = threading.RLock()
    take = map(_Taken({True: None}).__getitem__, map(lock.acquire, itertools.repeat(False)))
    return type("Turn", (), {"__enter__": take.__next__, "__exit__": lock.__exit__})()
