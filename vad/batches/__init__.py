"""Many at once: sheets by the hundred, and sweeps over arrays larger than memory.

A file says what a class is to get; a folder is filled with numbered problems and keys. joblib and
Dask are imported when they are used.
"""
