"""Design the other way round: from what is asked for to the mechanisms that do it."""
