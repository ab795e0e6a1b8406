"""Golden values: constants and formulas held by sources other than the code they test, each named beside its value."""
