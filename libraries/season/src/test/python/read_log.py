"""Reads the Parquet file of a single log by pandas, and its metadata by pyarrow. Prints the results as JSON."""
import json
import sys

import pandas
import pyarrow.parquet

NAME = "System/Battery Voltage"
rows = pandas.read_parquet(sys.argv[1])
told = json.loads(pyarrow.parquet.read_metadata(sys.argv[1]).metadata[b"badlog"])
print(json.dumps({
    "columns": list(rows.columns),
    "lowest": rows[NAME].min(),
    "start": rows["timestamp"].min().isoformat(),
    "unit": told["columns"][NAME]["unit"],
}))
