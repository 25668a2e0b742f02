"""Cases with thirty digits, for any program that solves mechanisms: see README.md beside it."""
