"""Answers questions of docs/cookbook.md with pandas, as CookbookSpec compares them: one JSON object, question to number.

A sample holds until the next one, the last one until the end of the log."""
import json
import sys

import numpy as np
import pandas as pd

log = pd.read_csv(sys.argv[1], skiprows=1, low_memory=False)
time = log["Time"]
width = time.shift(-1).sub(time).fillna(0.0)
battery = log["System/Battery Voltage"]
current = log["PDP/Total Current"]
loop = log["System/Loop Time"]
state = log["Superstructure/State"]
events = log["System/Event Log"]
left = log["Drivetrain/Left Velocity"]
right = log["Drivetrain/Right Velocity"]


def flag(name):
    return log[name].astype(str).str.lower() == "true"


def mean(x):
    known = x.notna()
    return (x[known] * width[known]).sum() / width[known].sum()


def percentile(x, share):
    frame = pd.DataFrame({"x": x, "w": width}).dropna()
    weights = frame.groupby("x")["w"].sum().sort_index()
    return weights.index[np.searchsorted(weights.cumsum(), share * weights.sum())]


def spans(condition):
    """From and to of each run of true rows."""
    run = (condition != condition.shift()).cumsum()[condition]
    first = time[condition].groupby(run).first()
    last_row = pd.Series(condition.index[condition], index=run.values).groupby(level=0).last()
    end = [time[min(row + 1, len(time) - 1)] for row in last_row]
    return np.array(first), np.array(end)


def total(condition):
    return width[condition].sum()


def lengths(condition):
    begin, end = spans(condition)
    return end - begin


def slope(y, x):
    dx, dy = x - mean(x), y - mean(y)
    return mean(dx * dy) / mean(dx * dx)


def correlation(x, y):
    dx, dy = x - mean(x), y - mean(y)
    return mean(dx * dy) / np.sqrt(mean(dx * dx) * mean(dy * dy))


def steepest(x):
    changed = x[x != x.shift()]
    return (changed.diff() / time[changed.index].diff()).max()


scoring = state == "SCORING"
scoring_begins = spans(scoring)[0]
off = (log["Elevator/Position"] - log["Elevator/Setpoint"]).abs()
above = log["Arm/Angle"] > 90
scored = events.str.contains("scored", case=False, na=False)

answers = {
    "min(Battery Voltage)": battery.min(),
    "max(Total Current)": current.max(),
    "mean(Total Current)": mean(current),
    "sample_mean(Total Current)": current.mean(),
    "stddev(Battery Voltage)": np.sqrt(mean((battery - mean(battery)) ** 2)),
    "sample_stddev(Battery Voltage)": battery.std(),
    "median(Battery Voltage)": percentile(battery, 0.5),
    "percentile(Loop Time, 95)": percentile(loop, 0.95),
    "integral(Battery Voltage * Total Current) / 3600": (battery * current * width).sum() / 3600,
    "slope(Battery Voltage, Total Current)": slope(battery, current),
    "correlation(Left Velocity, Right Velocity)": correlation(left, right),
    "count(Browned Out)": len(spans(flag("System/Browned Out"))[0]),
    "total(Browned Out)": total(flag("System/Browned Out")),
    "total(enabled)": total(flag("System/Enabled")),
    "min(Battery Voltage when autonomous)": battery[flag("System/Enabled") & flag("System/Autonomous")].min(),
    "total(State == 'SCORING')": total(scoring),
    "count(State == 'SCORING')": len(scoring_begins),
    "count(changed(State))": ((state != state.shift()) & state.shift().notna()).sum(),
    "mean(cycle_times(State == 'SCORING'))": np.diff(scoring_begins).mean(),
    "max(lengths(Intake/Current > 10))": lengths(log["Intake/Current"] > 10).max(),
    "count(Loop Time > 20 ms)": len(spans(loop > 20)[0]),
    "max(derivative(Left Velocity))": steepest(left),
    "count(crosses(Arm/Angle, 90))": (above != above.shift()).sum() - 1,
    "total(abs(Elevator/Position - Elevator/Setpoint) > 10 cm)": total(off > 0.1),
    "total(Battery Voltage < 7.5 for 0.1 s)": lengths(battery < 7.5)[lengths(battery < 7.5) >= 0.1 - 1e-9].sum(),
    "count(Event Log contains 'scored')": scored.sum(),
    "mean(cycle_times(Event Log contains 'scored'))": time[scored].diff().mean(),
    "total(missing(Vision/Target X))": total(log["Vision/Target X"].isna()),
}
json.dump({question: float(answer) for question, answer in answers.items()}, sys.stdout)
