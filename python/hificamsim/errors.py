"""What can go wrong."""


class Error(Exception):
    """Anything that this package says."""


class InputError(Error, ValueError):
    """A setting, file or action is wrong; the message is the line that the command line prints."""


class JavaError(Error, RuntimeError):
    """There is no Java to run on, or it cannot be used as things are."""


class WorkerDied(Error, RuntimeError):
    """The Java process of an environment ended, or was killed."""


class Closed(Error, RuntimeError):
    """The environment was closed, or belongs to another process."""
