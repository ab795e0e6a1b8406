"""`make stability`: what breaks, where, and what the pipeline does about it."""
