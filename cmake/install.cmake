# Installation is described here; filled in with the package configuration.
