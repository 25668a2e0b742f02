"""The drawings of mechanisms in space: one script for each, which its mechanism names."""
