"""A board that follows the hand: one pose, on which nothing jumps from one to the next."""
