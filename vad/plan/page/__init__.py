"""What stands about the panels: title, heads, equations, results and captions."""
