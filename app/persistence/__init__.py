"""Engine, models and queries: the only home of ``select``. It flushes and never commits."""
