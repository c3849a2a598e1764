"""A package's files with PlatformIO's own readers: platformio.py PLATFORMIO_CORE TREE NAME"""
import pathlib
import sys


def main(core, tree, name):
    sys.path.insert(0, core)
    from platformio.package.manifest.parser import ManifestParserFactory
    from platformio.package.manifest.schema import ManifestSchema
    from platformio.package.meta import PackageSpec
    from platformio.project.config import ProjectConfig

    tree = pathlib.Path(tree)
    config = ProjectConfig(str(tree / "platformio/platformio.ini"))
    config.validate()
    for env in config.envs():
        spec = PackageSpec(config.get(f"env:{env}", "platform"))
        assert spec.requirements or "#" in spec.uri or "/releases/download/" in spec.uri, f"{env}: {spec} is not pinned"
        assert "-std=gnu++20" in " ".join(config.get(f"env:{env}", "build_flags")), env
    for file in (tree / f"platformio/lib/{name}/library.json", tree / "library.properties"):
        if file.exists():
            manifest = ManifestSchema().load_manifest(ManifestParserFactory.new_from_file(str(file)).as_dict())
            assert manifest["name"] == name, file
    print(f"ok   {name}: PlatformIO's own readers")


if __name__ == "__main__":
    main(*sys.argv[1:])
