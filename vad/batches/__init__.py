"""Many at once: sheets by the hundred, and sweeps over arrays larger than memory.

In comes a file that says what a class is to get, out go numbered problems and keys in a folder.
joblib and Dask are loaded when they are used.
"""
