"""The documentation: its pages, what is made for them, and the site.

``python -m docs`` builds the site.  `docs.site` puts it together, `docs.examples` reads and runs
the examples of a page, `docs.made` writes the pages that follow from the code.
"""
