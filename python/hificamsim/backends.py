"""The two ways to the simulator: a JVM in this process, or one in a process of its own."""

from __future__ import annotations

import atexit
import contextlib
import gc
import json
import mmap
import os
import shutil
import signal
import struct
import subprocess
import sys
import tempfile
import threading
import time
import weakref
from collections.abc import Callable, Iterator
from types import FrameType
from typing import IO, Any, Protocol

from . import java
from .errors import Closed, Error, InputError, InUse, JavaError, NoEpisode, WorkerDied, line, shown


FAULTS: dict[bytes, type[Error]] = {b"i": InputError, b"n": NoEpisode}  # by the letter of a worker's reply
JAVA_FAULTS: dict[str, type[Error]] = {"InputException": InputError, "EpisodeOverException": NoEpisode}
LONGEST_WAIT = 5.0  # seconds, for calls that are under way when the process ends


class Backend(Protocol):
    """Worlds that are open on the Java side, and share ``memory`` with this process."""

    description: dict[str, Any]
    memory: Any

    def step(self) -> None: ...

    def reset(self, world: int, seed: int, fresh: bool) -> None: ...

    def state(self) -> None: ...

    def save(self) -> bytes: ...

    def restore(self, state: bytes) -> None: ...

    def seed(self) -> int: ...

    def picture(self, world: int, width: int) -> bytes: ...

    def close(self) -> None: ...


def open_backend(name: str | None, settings: dict[str, Any]) -> Backend:
    """Opens worlds by the backend ``jvm`` or ``process``, or by the first of these that is available. A forked process
    cannot use the JVM of its parent.
    """
    if name is None:
        name = "jvm" if _has_jpype() and not _Jvm.is_parents() else "process"
    backends: dict[str, Callable[[dict[str, Any]], Backend]] = {"jvm": JvmBackend, "process": ProcessBackend}
    if isinstance(name, str) and name in backends:
        return backends[name](settings)
    raise InputError(f"backend is {shown(name)}, expected 'jvm' or 'process'")


def _has_jpype() -> bool:
    try:
        import jpype  # noqa: F401
    except ImportError:
        return False
    return True


class _Jvm:
    """The JVM of this process: started once, and never stopped before the process ends."""

    lock = threading.Lock()
    process: int | None = None
    ends = False
    calls: weakref.WeakSet[threading.Lock] = weakref.WeakSet()  # each held while a call is under way

    fault: type[Exception] = Exception

    @classmethod
    def start(cls) -> None:
        try:
            import jpype
        except ImportError as e:
            raise JavaError("backend 'jvm' needs JPype: pip install JPype1, or backend='process'") from e
        with cls.lock:
            if cls.process is None:
                cls._start(jpype)
            cls.check()

    @staticmethod
    def session() -> Any:
        """The class of sessions."""
        import jpype

        return jpype.JClass("org.hificamsim.python.Session")

    @classmethod
    def _start(cls, jpype: Any) -> None:
        if jpype.isJVMStarted():  # by somebody else
            for jar in java.class_path():
                jpype.addClassPath(jar)
        else:
            cls._start_jvm(jpype)
        atexit.register(cls._wait_for_calls)  # before JPype's own, which was registered before
        cls.fault = jpype.JException
        cls.process = os.getpid()
        if hasattr(os, "register_at_fork"):
            _Fork.register()

    @staticmethod
    def _start_jvm(jpype: Any) -> None:
        """Starts the JVM in a thread of its own, which detaches from it: the process waits at its end for the thread
        that started the JVM, and a user's thread may have ended by then without detaching.
        """
        java.check_options()
        # -Xrs: all signals stay Python's; without it Java, or with interrupt=False JPype, takes INT and TERM
        options = ["-Xrs", *java.options()]
        library, class_path = java.library(), java.class_path()
        faults: list[Exception] = []

        def start() -> None:
            try:
                jpype.startJVM(library, *options, classpath=class_path, interrupt=True)
                jpype.java.lang.Thread.detach()
            except Exception as fault:
                faults.append(fault)

        starter = threading.Thread(target=start, name="start of the JVM")
        starter.start()
        starter.join()
        if faults:
            raise JavaError(f"Java does not start: {line(str(faults[0]))}{java.given_options()}") from faults[0]

    @classmethod
    def _wait_for_calls(cls) -> None:
        """Waits at the end of the process until daemon threads have returned from Java, and lets them call it no more: a
        thread that returned later would find Python gone.
        """
        if not cls.is_parents():
            cls.ends = True
            until = time.monotonic() + LONGEST_WAIT
            for call in list(cls.calls):
                call.acquire(timeout=max(0.0, until - time.monotonic()))

    @classmethod
    def hold_at_end(cls) -> None:
        """Stops a daemon thread that would call Java while the process ends."""
        if cls.ends and threading.current_thread() is not threading.main_thread():
            while True:
                time.sleep(LONGEST_WAIT)

    @classmethod
    def is_parents(cls) -> bool:
        """Whether the JVM was started before this process was forked."""
        return cls.process is not None and cls.process != os.getpid()

    @classmethod
    def check(cls) -> None:
        if cls.is_parents():
            raise JavaError(
                f"the JVM was started in process {cls.process} before this one was forked from it:"
                " use backend='process', or multiprocessing's 'spawn'"
            )


class _Fork:
    """Keeps forked processes from calling the JVM, which has no threads there, so that a call would never return.
    JPype calls the JVM whenever Python collects garbage, and when the process ends. Therefore no garbage is collected from
    before the fork until the child has left the JVM.
    """

    collects = True

    @classmethod
    def register(cls) -> None:
        os.register_at_fork(before=cls._pause, after_in_parent=cls._resume, after_in_child=cls._leave_jvm)

    @classmethod
    def _pause(cls) -> None:
        cls.collects = gc.isenabled()
        gc.disable()

    @classmethod
    def _resume(cls) -> None:
        if cls.collects:
            gc.enable()

    @classmethod
    def _leave_jvm(cls) -> None:
        import jpype

        gc.callbacks[:] = [callback for callback in gc.callbacks if getattr(callback, "__module__", "") != "_jpype"]
        gc.freeze()
        terminate = getattr(jpype._core, "_JTerminate", None)
        if terminate is not None:
            atexit.unregister(terminate)
        cls._resume()


def _enter(busy: threading.Lock) -> None:
    """Lets one thread at a time into an environment; the simulator is not thread-safe."""
    if not busy.acquire(blocking=False):
        _Jvm.hold_at_end()
        raise InUse("another thread is in a call of this environment, expected one environment for each thread")


class _JavaCalls:
    """Calls the JVM for one environment, one call at a time, and translates faults into those of this package."""

    def __init__(self) -> None:
        self._busy = threading.Lock()
        _Jvm.calls.add(self._busy)

    def __call__(self, method: Callable[..., Any], *arguments: Any) -> Any:
        _enter(self._busy)
        try:
            _Jvm.hold_at_end()
            return method(*arguments)
        except _Jvm.fault as e:
            message = _Jvm.session().message(e)
            raise _translated(str(e.getClass().getName()), str(message), e) from None
        finally:
            self._busy.release()


class JvmBackend:
    """Worlds in a JVM in this process; their memory is the JVM's own."""

    def __init__(self, settings: dict[str, Any]) -> None:
        _Jvm.start()
        self._call = _JavaCalls()
        self._call(self._begin, json.dumps(settings))
        self._closer = weakref.finalize(self, self._call, self._session.close)
        self._closer.atexit = False  # the JVM may be gone by then

    def _begin(self, settings: str) -> None:
        self._session = _Jvm.session().open(settings)
        self.description = json.loads(str(self._session.description()))
        self.memory = memoryview(self._session.memory())

    def _open(self) -> Any:
        _Jvm.check()
        if self._session is None:
            raise Closed("the environment was closed, expected a new one")
        return self._session

    def step(self) -> None:
        self._call(self._open().step)

    def reset(self, world: int, seed: int, fresh: bool) -> None:
        self._call(self._open().reset, world, seed, fresh)

    def state(self) -> None:
        self._call(self._open().state)

    def save(self) -> bytes:
        return bytes(self._call(self._open().save))

    def restore(self, state: bytes) -> None:
        self._call(self._open().restore, state)

    def seed(self) -> int:
        return int(self._open().seed())

    def picture(self, world: int, width: int) -> bytes:
        return bytes(self._call(self._open().picture, world, width))

    def close(self) -> None:
        """Ends the worlds. The JVM stays: it cannot be started twice in a process."""
        if self._session is not None and _Jvm.process == os.getpid() and not _Jvm.ends:
            self._call(self._session.close)
            self._closer.detach()
        self._session = None


def _translated(kind: str, message: str, cause: BaseException) -> Exception:
    for name, fault in JAVA_FAULTS.items():
        if kind.endswith("." + name):
            return fault(line(message))
    trace = getattr(cause, "stacktrace", lambda: "")()
    return Error(f"{kind}: {message}\n{trace}")


class ProcessBackend:
    """Worlds in a JVM of their own, which maps the same file as this process and receives requests by a pipe."""

    def __init__(self, settings: dict[str, Any]) -> None:
        self._process = os.getpid()
        self._busy = threading.Lock()
        self._errors = tempfile.TemporaryFile()
        folder = "/dev/shm" if os.access("/dev/shm", os.W_OK) else None
        descriptor, file = tempfile.mkstemp(prefix="hificamsim-", dir=folder)
        free_bytes = shutil.disk_usage(file).free
        inherited = f"/proc/self/fd/{descriptor}"
        unlinked = os.path.exists(inherited)
        if unlinked:
            os.unlink(file)  # the worker opens the inherited file; no file is left even if this process is killed
        try:
            self._worker = self._start(inherited if unlinked else file, free_bytes, descriptor)
            self._closer = weakref.finalize(self, _end, self._worker, self._errors, self._process)
            self.description = json.loads(self._open_worlds(settings))
            untracked: dict[str, Any] = {"trackfd": False} if sys.version_info >= (3, 13) else {}
            self.memory = memoryview(mmap.mmap(descriptor, self.description["bytes"], **untracked))
        except BaseException:
            self.close()
            raise
        finally:
            os.close(descriptor)
            if not unlinked:
                os.unlink(file)  # both sides have mapped it

    def _start(self, file: str, free_bytes: int, descriptor: int) -> subprocess.Popen[bytes]:
        command = [java.executable(), *java.options(), "-cp", os.pathsep.join(java.class_path())]
        return subprocess.Popen(
            [*command, "org.hificamsim.python.Server", file, str(free_bytes), str(os.getpid())],
            pass_fds=(descriptor,),
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=self._errors,
            bufsize=0,
            start_new_session=True,  # Ctrl-C is for Python alone
        )

    def _open_worlds(self, settings: dict[str, Any]) -> bytes:
        try:
            return self._ask(b"o", json.dumps(settings).encode())
        except WorkerDied as fault:
            raise JavaError(f"Java does not start: {line(str(fault))}{java.given_options()}") from fault

    def _ask(self, letter: bytes, message: bytes = b"") -> bytes:
        self._check()
        _enter(self._busy)
        try:
            with _uninterrupted():
                kind, answer = self._exchange(letter, message)
        finally:
            self._busy.release()
        if kind == b"k":
            return answer
        text = answer.decode(errors="replace")
        if kind in FAULTS:
            raise FAULTS[kind](line(text))
        raise Error(text + "\n" + self._error_output())

    def _exchange(self, letter: bytes, message: bytes) -> tuple[bytes, bytes]:
        """Sends a request and reads its answer. An interrupted exchange ends the worker, which could not continue."""
        assert self._worker.stdin is not None
        try:
            self._worker.stdin.write(letter + struct.pack(">i", len(message)) + message)
            head = self._read(5)
            return head[:1], self._read(struct.unpack(">i", head[1:])[0])
        except (BrokenPipeError, EOFError):
            raise self._death() from None
        except BaseException:
            self._worker.kill()
            self.close()
            raise

    def _read(self, count: int) -> bytes:
        assert self._worker.stdout is not None
        data = b""
        while len(data) < count:
            part = self._worker.stdout.read(count - len(data))
            if not part:
                raise EOFError
            data += part
        return data

    def _check(self) -> None:
        if self._process != os.getpid():
            raise Closed(
                f"the environment belongs to process {self._process}, from which this one was forked:"
                " make one here"
            )
        if not self._closer.alive:
            raise Closed("the environment was closed, expected a new one")

    def _death(self) -> WorkerDied:
        with contextlib.suppress(subprocess.TimeoutExpired):
            self._worker.wait(timeout=5)
        output = self._error_output()
        self.close()
        code = self._worker.returncode
        reason = signal.Signals(-code).name if code is not None and code < 0 else f"code {code}"
        return WorkerDied(f"the environment's Java process ended ({reason}), make a new one\n{output}".strip())

    def _error_output(self) -> str:
        self._errors.seek(0)
        return self._errors.read().decode(errors="replace")[-4000:]

    def step(self) -> None:
        self._ask(b"s")

    def reset(self, world: int, seed: int, fresh: bool) -> None:
        self._ask(b"r", struct.pack(">iqb", world, seed, fresh))

    def state(self) -> None:
        self._ask(b"t")

    def save(self) -> bytes:
        return self._ask(b"v")

    def restore(self, state: bytes) -> None:
        self._ask(b"w", state)

    def seed(self) -> int:
        return int(struct.unpack(">q", self._ask(b"n"))[0])

    def picture(self, world: int, width: int) -> bytes:
        return self._ask(b"p", struct.pack(">ii", world, width))

    def close(self) -> None:
        """Ends the worlds and their process."""
        if self._process == os.getpid() and hasattr(self, "_closer"):
            self._closer()
        self.memory = memoryview(b"")


@contextlib.contextmanager
def _uninterrupted() -> Iterator[None]:
    """Delays Ctrl-C until an exchange has ended; a second Ctrl-C interrupts the exchange, and ends the worker."""
    before = signal.getsignal(signal.SIGINT)
    if threading.current_thread() is not threading.main_thread() or not callable(before):
        yield
        return
    waiting: list[FrameType | None] = []

    def wait(number: int, frame: FrameType | None) -> None:
        if waiting:
            before(number, frame)
        waiting.append(frame)

    signal.signal(signal.SIGINT, wait)
    try:
        yield
    finally:
        signal.signal(signal.SIGINT, before)
    if waiting:
        before(signal.SIGINT, waiting[0])


def _end(worker: subprocess.Popen[bytes], errors: IO[bytes], process: int) -> None:
    """Closes the input of the worker, which ends it; a worker that does not end is killed."""
    if process != os.getpid():
        return
    for file in (worker.stdin, worker.stdout, errors):
        assert file is not None
        file.close()
    try:
        worker.wait(timeout=5)
    except subprocess.TimeoutExpired:
        worker.kill()
        worker.wait()
