#!/usr/bin/env python3
"""Writes a policy of sampled weights, 3-WIDTH-WIDTH-1, as safetensors: tests/large_policy/make.py FILE WIDTH [SEED]"""
import array
import json
import random
import struct
import sys


def main():
    path, width, seed = sys.argv[1], int(sys.argv[2]), int(sys.argv[3]) if len(sys.argv) > 3 else 1
    sample = random.Random(seed).random
    sizes = [3, width, width, 1]
    header, tables = {"__metadata__": {"activation": "relu"}}, []
    offset = 0
    for i, (inputs, outputs) in enumerate(zip(sizes, sizes[1:])):
        for name, shape in (("weight", [outputs, inputs]), ("bias", [outputs])):
            count = outputs * inputs if name == "weight" else outputs
            bound = inputs**-0.5
            tables.append(array.array("f", (bound * (2 * sample() - 1) for _ in range(count))).tobytes())
            header[f"{2 * i}.{name}"] = {"dtype": "F32", "shape": shape, "data_offsets": [offset, offset + 4 * count]}
            offset += 4 * count
    text = json.dumps(header).encode()
    with open(path, "wb") as file:
        file.write(struct.pack("<Q", len(text)) + text + b"".join(tables))


main()
