"""Type: strings become runs, runs become glyphs that are measured by their ink."""
