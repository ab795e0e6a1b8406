"""What the README claims in figures: measured by a command, kept in files, and written into the README from there."""
