"""WPILOG, the log of WPILib's DataLog, read by the rules of `docs/wpilog.md`."""
