"""confine - the sandbox between hostile code and this machine: the programs in C, and their callers."""
