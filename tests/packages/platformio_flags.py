"""The flags that PlatformIO compiles a project of an environment with, after the framework's: platformio_flags.py INI ENV
FLAG… What `build_unflags` has goes, `build_flags` comes (Project Configuration File, build options)."""
import configparser
import re
import sys


def main(ini, env, *flags):
    config = configparser.ConfigParser(comment_prefixes=(";",), interpolation=None)
    config.read(ini)
    section = {**config["env"], **config[f"env:{env}"]}
    for option in ("platform", "board", "framework"):
        assert section.get(option), f"[env:{env}] has no {option}"
    pinned = r"@\d+\.\d+\.\d+$|#[0-9a-f]{40}$|/releases/download/\d+(\.\d+)+/"
    assert re.search(pinned, section["platform"]), f"[env:{env}] has no version of its platform"
    gone = section["build_unflags"].split()
    print(" ".join([flag for flag in flags if flag not in gone] + section["build_flags"].split()))


if __name__ == "__main__":
    main(*sys.argv[1:])
