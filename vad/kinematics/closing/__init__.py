"""How loops close: closed forms for every pair of unknowns, and the rates by one crossing."""
