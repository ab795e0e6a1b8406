"""Ground truth: quadrature of SH weights, one file a rule. Pure numerics."""
