"""The first use: the core is built here, or taken from a binary."""
