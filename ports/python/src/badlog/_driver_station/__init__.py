"""The logs of the FRC Driver Station, `.dslog` and `.dsevents`, read by the rules of `docs/driver-station.md`."""
