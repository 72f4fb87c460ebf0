"""Many files or designs at once, on many processors or machines."""
