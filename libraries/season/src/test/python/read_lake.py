"""Reads a lake by pandas, pyarrow and Polars, each by its own reader, and prints the results as JSON."""
import json
import sys

import pandas
import polars
import pyarrow.dataset
import pyarrow.parquet

lake = sys.argv[1]
NAME = "System/Battery Voltage"

matches = pandas.read_parquet(f"{lake}/matches")
arrow = pyarrow.dataset.dataset(f"{lake}/samples", partitioning="hive").to_table(columns=["log", "number", NAME]).to_pandas()
scan = polars.scan_parquet(f"{lake}/samples/**/*.parquet", hive_partitioning=True)
lowest = scan.group_by("event", "number").agg(polars.col(NAME).min().alias("low")).sort("number").collect()
file = next(iter(pyarrow.dataset.dataset(f"{lake}/samples").files))
told = json.loads(pyarrow.parquet.read_metadata(file).metadata[b"badlog"])
print(json.dumps({
    "pandas": sorted(f"{row.title} {row.season} {row.start.isoformat()}" for row in matches.itertuples()),
    "pyarrow": arrow.groupby("number")[NAME].min().to_dict(),
    "polars": [list(row) for row in lowest.rows()],
    "unit": told["columns"][NAME]["unit"],
    "attributes": told["columns"][NAME]["attributes"],
}))
