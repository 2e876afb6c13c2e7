"""A hook for badlog: finds the weakest moment of the battery. Needs nothing but Python 3.

Try it by hand:  python3 analyze.py header.json < log.csv
"""
import csv
import json
import os
import sys

header_path = sys.argv[1] if len(sys.argv) > 1 else os.environ["BADLOG_HEADER"]
with open(header_path, encoding="utf-8") as file:
    header = json.load(file)
units = {topic["name"]: topic.get("unit", "ul") for topic in header["topics"]}
x_names = [topic["name"] for topic in header["topics"] if "xaxis" in topic.get("attrs", [])]

# Standard input is the log as CSV in UTF-8. Each topic is a column; a cell is empty where there is no sample.
sys.stdin.reconfigure(encoding="utf-8", newline="")
rows = csv.reader(sys.stdin)
titles = next(rows, [])
battery = next((i for i, title in enumerate(titles) if "battery voltage" in title.lower()), None)
if battery is None or not x_names or x_names[0] not in titles:
    print(json.dumps({}))
    sys.exit()
time = titles.index(x_names[0])
samples = []
for row in rows:
    try:
        samples.append((float(row[time]), float(row[battery])))
    except ValueError:
        continue

worst_time, worst = min(samples, key=lambda sample: sample[1])

# The lowest voltage of each whole second, as a line and as a picture.
lowest = {}
for moment, voltage in samples:
    second = int(moment)
    lowest[second] = min(voltage, lowest.get(second, voltage))
x = sorted(lowest)
y = [lowest[second] for second in x]
points = " ".join(f"{10 + 580 * i / max(1, len(x) - 1):.1f},{190 - 180 * v / 14:.1f}" for i, v in enumerate(y))
svg = (
    '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 600 200">'
    f'<polyline points="{points}" fill="none" stroke="#d4501a" stroke-width="2"/></svg>'
)

findings = []
if worst < 7:
    findings.append({"severity": "warning", "text": f"The battery fell to {worst:g} V", "time": worst_time})
result = {
    "values": {"Lowest voltage": f"{worst:g} {units[titles[battery]]}"},
    "findings": findings,
    "series": [{"name": "Lowest voltage of each second", "unit": units[titles[battery]], "x": x, "y": y}],
    "figures": [{"title": "Lowest voltage of each second", "svg": svg}],
}
# Only plain ASCII, whatever encoding the system likes.
json.dump(result, sys.stdout)
