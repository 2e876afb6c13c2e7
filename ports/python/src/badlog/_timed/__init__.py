"""Topics that have times of their own, as in logs without rows."""
