"""Letters and names beside what they name, where they touch nothing."""
