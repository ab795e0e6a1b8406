"""Tables: a winner packed, and its evaluation. Pure numerics."""
