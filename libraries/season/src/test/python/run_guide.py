"""Runs the Python examples of a guide, each by itself. Prints as JSON what each says of the lowest voltage of each log."""
import contextlib
import json
import re
import sys

import duckdb
import pandas
import polars
import pyarrow


def pairs_of(lowest):
    if isinstance(lowest, pandas.Series):
        return lowest.items()
    if isinstance(lowest, polars.DataFrame):
        return lowest.rows()
    if isinstance(lowest, duckdb.DuckDBPyRelation):
        return lowest.fetchall()
    assert isinstance(lowest, pyarrow.Table)
    return [tuple(row.values()) for row in lowest.select(["log", "System/Battery Voltage_min"]).to_pylist()]


found = {}
with open(sys.argv[1], encoding="utf-8") as guide:
    blocks = re.findall(r"```python\n(.*?)```", guide.read(), re.DOTALL)
for block in blocks:
    names = {}
    with contextlib.redirect_stdout(sys.stderr):
        exec(compile(block, "season.md", "exec"), names)
    lowest = names["lowest"]
    found[type(lowest).__module__.split(".")[0].lstrip("_")] = {log: low for log, low in pairs_of(lowest) if low is not None}
print(json.dumps(found))
