"""How PDF writes shapes, type and files: the parts of the painter of `vad.painting.pdf_painter`."""
