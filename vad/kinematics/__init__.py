"""How a mechanism moves: loops, four closed forms, rates by one crossing, lazy results."""
