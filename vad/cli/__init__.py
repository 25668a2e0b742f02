"""The command ``vad``: in come the words of a command line, out go text, files and an exit code.

`vad.cli.process` is the process with its signals and streams, `vad.cli.run` one call,
`vad.cli.app` the commands; nothing heavy is imported until the words have been read.
"""

from vad.cli.process import main

__all__ = ["main"]
