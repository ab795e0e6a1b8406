"""What the tables' errors mean for lit surfaces: what E_mean and E_max promise, and what irradiance really loses."""
