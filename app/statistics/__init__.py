"""Statistics: arrays in, small frozen results out. Knows nothing of studies, pages or databases."""
