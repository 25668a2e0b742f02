"""What holds for all tests."""

import signal

# A shell lets what it starts in the background ignore an interrupt, and that is inherited.
if signal.getsignal(signal.SIGINT) is signal.SIG_IGN:
    signal.signal(signal.SIGINT, signal.default_int_handler)
