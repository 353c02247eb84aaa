"""Puts the jars into the wheel: those of an sdist, of the folder HIFICAMSIM_JARS, or those that Gradle builds."""

import os
import pathlib
import shutil
import subprocess

from setuptools import setup
from setuptools.command.build_py import build_py

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent
BUILT = HERE / "build" / "wheel" / "jars"


def jars() -> pathlib.Path:
    """Returns the folder of jars, which are built if necessary."""
    given = os.environ.get("HIFICAMSIM_JARS") or (HERE / "jars" if (HERE / "jars").exists() else None)
    if given:
        return pathlib.Path(given)
    build = f'root="{ROOT}"; . "$root/tools/setup.sh"; build_if_stale "{BUILT}" :python:jars'
    subprocess.run(["sh", "-euc", build], check=True)
    return BUILT


class WithJars(build_py):
    """Builds the package with its jars and scenarios."""

    def run(self) -> None:
        package = (HERE if self.editable_mode else pathlib.Path(self.build_lib)) / "hificamsim"
        if not self.editable_mode:
            shutil.rmtree(package, ignore_errors=True)  # a module that is gone would stay in the wheel
        super().run()
        self.copy(jars().glob("*.jar"), package / "jars")
        scenarios = HERE / "scenarios" if (HERE / "scenarios").exists() else ROOT / "scenarios"
        self.copy(scenarios.glob("*"), package / "scenarios")

    def copy(self, files, folder: pathlib.Path) -> None:
        shutil.rmtree(folder, ignore_errors=True)
        folder.mkdir(parents=True)
        for file in files:
            if file.is_file():
                shutil.copy(file, folder)


setup(cmdclass={"build_py": WithJars})
