"""confine - what stands between hostile code and this machine: the programs in C, and who calls them."""
