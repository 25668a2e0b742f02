"""The command ``vad``: the words of a command line become text, files and an exit code.

`vad.cli.main` is the process, `vad.cli.process` its signals and streams, `vad.cli.run` one call,
`vad.cli.app` the commands; nothing heavy is imported until the words have been read.
"""

from vad.cli.main import main

__all__ = ["main"]
