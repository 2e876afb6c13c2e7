"""Writes CSV files in random dialects, and compares the values that badlog and pandas read; pandas is given each dialect.

`csv_dialects.py write FOLDER SEED COUNT` writes the files into FOLDER, and their dialects into FOLDER/dialects.json. `csv_dialects.py compare FOLDER
RESULTS` prints the number of equal values, or fails with the first difference."""
import datetime
import json
import pathlib
import random
import sys

import pandas as pd

START = datetime.datetime(2024, 3, 16, 10, 11, 32)
GROUPS = {".": ",", ",": "."}


def written(value, dialect):
    if isinstance(value, bool):
        text = str(value).lower()
    elif isinstance(value, str):
        text = value
    else:
        whole, _, part = f"{abs(value)}".partition(".")
        if dialect["between"]:
            whole = f"{int(whole):,}".replace(",", dialect["between"])
        text = "-" * (value < 0) + whole + (dialect["point"] + part if part else "")
    return f'"{text}"' if dialect["quoted"] else text


def write(folder, seed, count):
    chance = random.Random(seed)
    dialects = {}
    for number in range(count):
        separator = chance.choice(",;\t")
        point = "." if separator == "," else chance.choice(".,")
        group = GROUPS[point]
        dialect = {
            "separator": separator,
            "point": point,
            "between": group if group != separator and chance.random() < 0.25 else None,
            "named": chance.random() < 0.25,
            "units": chance.random() < 0.25,
            "marked": chance.random() < 0.3,
            "quoted": chance.random() < 0.3,
            "x": chance.choice(["row", "s", "iso"]),
        }
        columns = chance.randrange(1, 6)
        values = [
            lambda: round(chance.uniform(-10, 14), 3),
            lambda: chance.randrange(-5000, 2_000_000),
            lambda: chance.random() < 0.5,
            lambda: round(chance.uniform(1000, 90000), 2),
        ]
        times = {"row": lambda row: row, "s": lambda row: round(row * 0.02, 2)}
        times["iso"] = lambda row: (START + datetime.timedelta(milliseconds=20 * row)).isoformat(timespec="milliseconds")
        rows = [
            [times[dialect["x"]](row)] + [values[(number + column) % 4]() for column in range(columns)]
            for row in range(chance.randrange(5, 200))
        ]
        lines = [[chance.choice(["Time", "Timestamp", "time"])] + [f"Column {column}" for column in range(columns)]]
        units = ["" if dialect["x"] == "iso" else "s"] + ["" if isinstance(value, bool) else "V" for value in rows[0][1:]]
        dialect["units"] = dialect["units"] and any(units)
        if dialect["units"]:
            lines.append(units)
        lines += [[written(value, dialect) for value in row] for row in rows]
        text = [separator.join(line) for line in lines]
        if dialect["named"]:
            text.insert(0, f"sep={separator}")
        end = chance.choice(["\n", "\r\n"])
        name = f"{number:03}.csv"
        mark = "\ufeff" if dialect["marked"] else ""
        (folder / name).write_bytes((mark + end.join(text) + end).encode())
        dialects[name] = dialect
    (folder / "dialects.json").write_text(json.dumps(dialects))


def read(file, dialect):
    first = 1 if dialect["named"] else 0
    skipped = [*range(first), first + 1] if dialect["units"] else [*range(first)]
    return pd.read_csv(
        file, sep=dialect["separator"], decimal=dialect["point"], thousands=dialect["between"], skiprows=skipped, encoding="utf-8-sig"
    )


def compare(folder, results):
    equal = 0
    for name, dialect in json.loads((folder / "dialects.json").read_text()).items():
        wanted = read(folder / name, dialect)
        found = pd.read_parquet((results / name).with_suffix(".parquet"))
        for index, title in enumerate(wanted.columns):
            # A log's file has a column with this name of its own.
            column = f"{title} (2)" if title.lower() == "timestamp" else title
            numbers = wanted[title]
            if index == 0 and dialect["x"] == "iso":
                numbers = pd.to_datetime(numbers).sub(pd.Timestamp(START)).dt.total_seconds()
            if index == 0 and column not in found.columns:
                column = "t"
            if column not in found.columns:
                sys.exit(f"{name} {dialect}: {title} is not in the result, which has {[*found.columns]}")
            own = found[column].tolist()
            if len(own) != len(numbers):
                sys.exit(f"{name} {dialect}: {title} has {len(own)} values, not {len(numbers)}")
            for row, (one, other) in enumerate(zip(numbers, own)):
                if one != other and not (index == 0 and dialect["x"] == "iso" and abs(one - other) < 1e-9):
                    sys.exit(f"{name} {dialect}: {title} is {other} in row {row}, not {one}")
            equal += len(own)
    print(equal)


if sys.argv[1] == "write":
    write(pathlib.Path(sys.argv[2]), int(sys.argv[3]), int(sys.argv[4]))
else:
    compare(pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3]))
