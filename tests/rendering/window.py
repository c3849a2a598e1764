#!/usr/bin/env python3
"""The window of a program under Xvfb: window.py PROGRAM FOLDER

It loads no drivers of OpenGL. What it shows is one of the pictures FOLDER/0.png, 1.png, ...; when it is closed, the
program ends with exit code 0 and a summary."""
import ctypes
import os
import pathlib
import subprocess
import sys
import time

import pixels

X = ctypes.CDLL("libX11.so.6")
X.XOpenDisplay.restype = X.XDefaultRootWindow.restype = X.XInternAtom.restype = X.XGetPixel.restype = ctypes.c_ulong
X.XGetImage.restype = ctypes.c_void_p
P, L = ctypes.c_void_p, ctypes.c_ulong


class Message(ctypes.Structure):
    _fields_ = [("type", ctypes.c_int), ("serial", L), ("send_event", ctypes.c_int), ("display", P), ("window", L),
                ("message_type", L), ("format", ctypes.c_int), ("data", ctypes.c_long * 5), ("room", ctypes.c_long * 16)]


def find(display, window, title):
    name = ctypes.c_char_p()
    if X.XFetchName(P(display), L(window), ctypes.byref(name)) and name.value == title:
        return window
    root, parent, children, count = L(), L(), ctypes.POINTER(L)(), ctypes.c_uint()
    X.XQueryTree(P(display), L(window), ctypes.byref(root), ctypes.byref(parent), ctypes.byref(children),
                 ctypes.byref(count))
    for i in range(count.value):
        found = find(display, children[i], title)
        if found:
            return found
    return None


def rows_of(display, window):
    """Every 16th row of the window, 480x480."""
    image = X.XGetImage(P(display), L(window), 0, 0, 480, 480, L(0xFFFFFFFF), 2)
    rows = [[X.XGetPixel(P(image), x, y) & 0xFFFFFF for x in range(480)] for y in range(0, 480, 16)]
    return [b"".join(p.to_bytes(3, "big") for p in row) for row in rows]


def wait(what, seconds=20.0):
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        found = what()
        if found:
            return found
        time.sleep(0.05)
    raise SystemExit("no window appeared")


def main():
    program, folder = sys.argv[1], pathlib.Path(sys.argv[2])
    known = [pixels.read(folder / f"{i}.png")[2][::16] for i in range(len(list(folder.iterdir())))]
    read, write = os.pipe()
    server = subprocess.Popen(["Xvfb", "-displayfd", str(write), "-screen", "0", "640x640x24", "-nolisten", "tcp"],
                              pass_fds=[write], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    shown = None
    try:
        os.environ["DISPLAY"] = ":" + os.read(read, 16).decode().strip()
        # So slow that a busy machine has looked before the run ends and the window is gone.
        shown = subprocess.Popen([program, "--steps", "30", "--render", "window", "--real-time-factor", "0.01"],
                                 stdout=subprocess.PIPE, text=True)
        display = wait(lambda: X.XOpenDisplay(None))
        root = X.XDefaultRootWindow(P(display))
        window = wait(lambda: find(display, root, b"tutorial_7"))
        wait(lambda: rows_of(display, window) in known[1:])
        loaded = pathlib.Path(f"/proc/{shown.pid}/maps").read_text()
        assert "libSDL2" in loaded and "_dri.so" not in loaded and "libGL" not in loaded, "OpenGL's drivers are loaded"
        atom = lambda name: X.XInternAtom(P(display), name, 0)
        message = Message(type=33, window=window, message_type=atom(b"WM_PROTOCOLS"), format=32)
        message.data[0] = atom(b"WM_DELETE_WINDOW")
        X.XSendEvent(P(display), L(window), 0, ctypes.c_long(0), ctypes.byref(message))
        X.XFlush(P(display))
        text, _ = shown.communicate(timeout=10)
        assert shown.returncode == 0, shown.returncode
        steps = int(next(line for line in text.splitlines() if line.startswith("steps ")).split()[1])
        assert 0 < steps < 30, text
    finally:
        for process in (shown, server):
            if process is not None and process.poll() is None:
                process.kill()
                process.wait()


main()
