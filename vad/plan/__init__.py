"""Where everything stands on a page: geometry, labels, table, equations."""
