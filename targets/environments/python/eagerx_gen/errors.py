"""What goes wrong."""


class Error(RuntimeError):
    """What a library, or eagerx-gen, says is wrong."""


class RewardNotFinite(Error):
    """Of a step, which was made."""


def need(package, install):
    """Imports a package that only parts of this package need."""
    import importlib

    try:
        return importlib.import_module(package)
    except ImportError as problem:
        raise ImportError(f"eagerx_gen needs {package.split('.')[0]} for this: {install} ({problem})") from problem
