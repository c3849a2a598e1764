"""The files that frameworks look for, against the forms that these document:
check_forms.py TREE NAME [library]

library.properties: Arduino library specification 1.5. library.json: PlatformIO's manifest, the fields used here.
module.yml: Zephyr's zephyr_module.py. idf_component.yml: ESP-IDF's component manager. Kconfig is parsed.
"""
import json
import pathlib
import re
import sys

import jsonschema
import kconfiglib
import yaml

VERSION = {"type": "string", "pattern": r"^\d+\.\d+\.\d+(-[\w.]+)?$"}
TEXT = {"type": "string", "minLength": 1}

LIBRARY_JSON = {
    "type": "object", "required": ["name", "version"], "additionalProperties": False,
    "properties": {
        "name": {"type": "string", "maxLength": 50, "pattern": r"^[^/@:]+$"},
        "version": VERSION, "description": {"type": "string", "maxLength": 255}, "headers": TEXT,
        "keywords": {"type": "array", "items": {"type": "string", "pattern": "^[a-z0-9+_-]+$", "maxLength": 50}},
        "frameworks": {"const": "*"}, "platforms": {"const": "*"},
        "build": {
            "type": "object", "additionalProperties": False,
            "properties": {"srcDir": TEXT, "includeDir": TEXT, "flags": {"type": "array", "items": TEXT},
                           "unflags": {"type": "array", "items": TEXT}}}}}

MODULE_YML = {
    "type": "object", "additionalProperties": False,
    "properties": {
        "name": TEXT,
        "build": {"type": "object", "additionalProperties": False, "properties": {"cmake": TEXT, "kconfig": TEXT}}}}

IDF_COMPONENT_YML = {
    "type": "object", "required": ["version"], "additionalProperties": False,
    "properties": {"version": VERSION, "description": TEXT,
                   "dependencies": {"type": "object", "properties": {"idf": TEXT}, "additionalProperties": False}}}

ARCHITECTURES = {"esp32", "rp2040", "stm32", "teensy"}  # with a compiler that has C++20
CATEGORIES = {"Display", "Communication", "Signal Input/Output", "Sensors", "Device Control", "Timing", "Data Storage",
              "Data Processing", "Other"}


def check_properties(text, tree):
    fields = dict(line.split("=", 1) for line in text.splitlines() if line)
    for key in ("name", "version", "author", "maintainer", "sentence", "paragraph", "category", "url", "architectures"):
        assert fields.get(key), f"library.properties has no {key}"
    assert re.fullmatch(r"[A-Za-z0-9][A-Za-z0-9 _.-]{0,62}", fields["name"])
    jsonschema.validate(fields["version"], VERSION)
    assert fields["category"] in CATEGORIES
    assert set(fields["architectures"].split(",")) <= ARCHITECTURES, fields["architectures"]
    for header in fields["includes"].split(","):
        assert (tree / "src" / header).is_file(), f"there is no {header}"


def main(tree, name, kind="program"):
    tree = pathlib.Path(tree)
    check_properties((tree / "library.properties").read_text(), tree)
    is_library = kind == "library"
    folder = tree / f"platformio/lib/{name}" if is_library else tree
    library = json.loads((folder / "library.json").read_text())
    jsonschema.validate(library, LIBRARY_JSON)
    assert (folder / library.get("build", {}).get("srcDir", "src") / library["headers"]).is_file()
    module = yaml.safe_load((tree / "zephyr/module.yml").read_text())
    jsonschema.validate(module, MODULE_YML)
    assert (tree / module["build"]["cmake"] / "CMakeLists.txt").is_file()
    component = tree / "esp-idf" / ("components" if is_library else "") / name / "idf_component.yml"
    jsonschema.validate(yaml.safe_load(component.read_text()), IDF_COMPONENT_YML)
    symbol = f"EAGERX_{name.upper()}"
    kconfig = kconfiglib.Kconfig(str(tree / module["build"]["kconfig"]), warn_to_stderr=False)
    assert symbol in kconfig.syms and kconfig.syms[symbol].type == kconfiglib.BOOL
    application = tree / "zephyr" / ("app" if is_library else "sample")
    assert f"CONFIG_{symbol}=y" in (application / "prj.conf").read_text()
    print("ok   forms of library.properties, library.json, module.yml, Kconfig, idf_component.yml")


if __name__ == "__main__":
    main(*sys.argv[1:])
