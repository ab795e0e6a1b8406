"""The artifact store: content-addressed HDF5 files."""
