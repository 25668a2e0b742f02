"""The window: a mechanism in the browser, turned by hand, solved and drawn in Python.

Questions come as JSON; the answers are poses, lessons and files.  The browser knows no mechanism:
it turns the place of a pointer into a number, and shows the answer.  Between questions nothing is
kept, except in caches.
"""
