#!/usr/bin/python3
"""Writes the files of libraries/ again as torch before 1.6 did (needs Debian's python3-torch):
    tests/data/policy/make_legacy.py
rsl_rl.pt becomes rsl_rl_legacy.pt, and td3.zip becomes td3_legacy.zip, whose policy.pth is in the old format. Their answers
are those of the files that they were made from.
"""
import io
import pathlib
import zipfile

import torch

LIBRARIES = pathlib.Path(__file__).resolve().parent / "libraries"


def legacy(content):
    file = io.BytesIO()
    torch.save(torch.load(io.BytesIO(content), map_location="cpu"), file, _use_new_zipfile_serialization=False)
    return file.getvalue()


(LIBRARIES / "rsl_rl_legacy.pt").write_bytes(legacy((LIBRARIES / "rsl_rl.pt").read_bytes()))
with zipfile.ZipFile(LIBRARIES / "td3.zip") as old, zipfile.ZipFile(LIBRARIES / "td3_legacy.zip", "w") as new:
    for entry in old.infolist():
        content = old.read(entry)
        info = zipfile.ZipInfo(entry.filename, (2020, 1, 1, 0, 0, 0))
        new.writestr(info, legacy(content) if entry.filename == "policy.pth" else content)
