"""Kconfig of a module with an application's prj.conf, as Zephyr takes it: what is assigned and does not get its value is
an error. kconfig.py MODULE PRJ_CONF HAS_FPU OUTPUT.cmake"""
import pathlib
import sys
import tempfile

import kconfiglib
import yaml

# As lib/cpp/Kconfig, arch/Kconfig, kernel/Kconfig and drivers/watchdog/Kconfig of Zephyr say it, for an STM32.
ZEPHYR = """
config CPP
	bool "C++"
if CPP
choice STD_CPP
	prompt "C++ standard"
	default STD_CPP11
config STD_CPP11
	bool "C++ 11"
config STD_CPP20
	bool "C++ 20"
config STD_CPP2B
	bool "C++ 2b"
endchoice
config REQUIRES_FULL_LIBCPP
	bool "complete C++ standard library"
endif
config CPU_HAS_FPU
	def_bool {fpu}
config FPU
	bool "FPU"
	depends on CPU_HAS_FPU
config FPU_SHARING
	bool "FPU register sharing"
	depends on FPU
config WATCHDOG
	bool "watchdog drivers"
config HWINFO
	bool "hardware information"
config IWDG_STM32
	def_bool y
	depends on WATCHDOG
	select HAS_WDT_DISABLE_AT_BOOT
config HAS_WDT_DISABLE_AT_BOOT
	bool
config WDT_DISABLE_AT_BOOT
	bool "disable at boot"
	depends on WATCHDOG && HAS_WDT_DISABLE_AT_BOOT
config MAIN_STACK_SIZE
	int "stack of the main thread"
	default 1024
source "{module}"
"""


def main(module, conf, fpu, output):
    description = yaml.safe_load((pathlib.Path(module) / "zephyr/module.yml").read_text())
    with tempfile.NamedTemporaryFile("w", suffix="Kconfig") as file:
        file.write(ZEPHYR.format(fpu=fpu, module=pathlib.Path(module) / description["build"]["kconfig"]))
        file.flush()
        kconfig = kconfiglib.Kconfig(file.name, warn_to_stderr=False)
        kconfig.load_config(conf)
    for line in pathlib.Path(conf).read_text().splitlines():
        if not line or line.startswith("#"):
            continue
        name, wanted = line.removeprefix("CONFIG_").split("=")
        assert name in kconfig.syms, f"there is no {name}"
        assert kconfig.syms[name].str_value == wanted, f"{name} is {kconfig.syms[name].str_value}, not {wanted}"
    assert not kconfig.warnings, kconfig.warnings
    forced = {"FPU": fpu, "FPU_SHARING": fpu, "REQUIRES_FULL_LIBCPP": "y"}
    if kconfig.syms["WATCHDOG"].str_value == "y":
        forced["WDT_DISABLE_AT_BOOT"] = "y"
    for name, wanted in forced.items():
        assert kconfig.syms[name].str_value == wanted, f"{name} is not {wanted}"
    lines = [f'set(MODULE_CMAKE {description["build"]["cmake"]})']
    lines += [f"set(CONFIG_{name} y)" for name, symbol in kconfig.syms.items() if symbol.str_value == "y"]
    pathlib.Path(output).write_text("\n".join(lines) + "\n")


if __name__ == "__main__":
    main(*sys.argv[1:])
