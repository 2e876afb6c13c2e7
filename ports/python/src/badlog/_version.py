"""The version of the package, which equals the version of the whole project."""

VERSION = "3.0.0"
