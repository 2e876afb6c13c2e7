"""The version of the package, which is that of the whole project."""

VERSION = "3.0.0"
