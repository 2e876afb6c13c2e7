"""Prints what WPILib's own reader finds in a WPILOG, one line a record. A line has name, type, time in us and value, separated by tabs."""
import sys

from wpiutil.log import DataLogReader



def in_hex(record):
    return bytes(record.getRaw()).hex()


READ = {
    "boolean": lambda record: str(record.getBoolean()).lower(),
    "int64": lambda record: str(record.getInteger()),
    "float": lambda record: float(record.getFloat()).hex(),
    "double": lambda record: float(record.getDouble()).hex(),
    "string": lambda record: record.getString().encode().hex(),
    "json": lambda record: record.getString().encode().hex(),
    "structschema": lambda record: record.getString().encode().hex(),
}

reader = DataLogReader(sys.argv[1])
if not reader.isValid():
    sys.exit("The reader calls the file invalid.")
entries = {}
for record in reader:
    if record.isStart():
        start = record.getStartData()
        entries[start.entry] = (start.name, start.type)
        print("start", start.name, start.type, start.metadata, sep="\t")
    elif not record.isControl():
        name, kind = entries[record.getEntry()]
        print("data", name, kind, record.getTimestamp(), READ.get(kind, in_hex)(record), sep="\t")
