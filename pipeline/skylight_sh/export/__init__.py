"""Export: tables as C, NPZ and other targets, one file a target."""
