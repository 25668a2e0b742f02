"""A sheet as data: JSON that holds everything, written and read by one table."""
