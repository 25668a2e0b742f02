"""The window: a mechanism in the browser, turned by hand, solved and drawn in Python.

In come questions as JSON, out go poses, lessons and files.  The browser knows no mechanism: it
turns a pointer into a number and shows what is answered.  Nothing is kept between questions but
caches.
"""
