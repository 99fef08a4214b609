"""Use cases: each function is one unit of work that loads, decides, saves and commits."""
