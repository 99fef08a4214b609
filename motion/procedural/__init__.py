"""Human walking made by code: bodies, gait signals, styles and the sample library."""
