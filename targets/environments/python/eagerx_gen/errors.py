"""Exceptions of this package."""


class Error(RuntimeError):
    """A problem that a library or eagerx-gen reports."""


class RewardNotFinite(Error):
    """The reward of a step is not finite. The step has been made."""


def need(package, install):
    """Imports a package that only parts of this package need."""
    import importlib

    try:
        return importlib.import_module(package)
    except ImportError as problem:
        raise ImportError(f"eagerx_gen needs {package.split('.')[0]} for this: {install} ({problem})") from problem
