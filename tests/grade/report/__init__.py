"""report - everything that is written of marked submissions."""
