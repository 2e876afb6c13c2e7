"""Runs WPILib's own server: python serve.py PORT COMMAND [ARGUMENTS]. Prints "ready", and ends when standard input does.

types        publishes a topic of each type, twice each line of standard input.
load R S     for the first line of standard input, publishes R values a second for S seconds, then prints how many.
"""
import dataclasses
import sys
import time

import ntcore
from wpiutil import wpistruct


@wpistruct.make_wpistruct(name="Point")
@dataclasses.dataclass
class Point:
    x: wpistruct.double
    y: wpistruct.double


network = ntcore.NetworkTableInstance.create()
network.startServer("", "127.0.0.1", 0, int(sys.argv[1]))
always = ntcore.PubSubOptions(sendAll=True, keepDuplicates=True)


def types():
    topics = [
        (network.getBooleanTopic("/boolean").publish(always), True),
        (network.getIntegerTopic("/int").publish(always), 9007199254740993),
        (network.getDoubleTopic("/double").publish(always), 0.1),
        (network.getFloatTopic("/float").publish(always), 1.5),
        (network.getStringTopic("/string").publish(always), "größer"),
        (network.getStringTopic("/json").publishEx("json", {"unit": "V"}, always), '{"a":1}'),
        (network.getBooleanArrayTopic("/boolean[]").publish(always), [True, False]),
        (network.getIntegerArrayTopic("/int[]").publish(always), [1, -2]),
        (network.getDoubleArrayTopic("/double[]").publish(always), [0.1, 2.0]),
        (network.getFloatArrayTopic("/float[]").publish(always), [1.5]),
        (network.getStringArrayTopic("/string[]").publish(always), ["a", ""]),
        (network.getRawTopic("/raw").publish("raw", always), bytes([1, 2, 3])),
        (network.getRawTopic("/msgpack").publish("msgpack", always), bytes([0xC0])),
        (network.getStructTopic("/struct", Point).publish(always), Point(1.0, 2.0)),
        (network.getStructArrayTopic("/struct[]", Point).publish(always), [Point(1.0, 2.0), Point(3.0, 4.0)]),
        (network.getDoubleTopic("plain").publish(always), 3.0),
    ]
    network.getTopic("/double").setProperty("unit", "m")
    print("ready", flush=True)
    for line in sys.stdin:
        for publisher, value in topics:
            publisher.set(value)
            publisher.set(value)
        network.flush()
        print("sent", flush=True)


def load():
    rate, seconds = int(sys.argv[3]), float(sys.argv[4])
    publishers = [network.getDoubleTopic(f"/load/{i}").publish(always) for i in range(100)]
    print("ready", flush=True)
    sys.stdin.readline()
    begin = time.monotonic()
    sent = 0
    while sent < rate * seconds:
        due = min(rate * seconds, (time.monotonic() - begin) * rate)
        while sent < due:
            publishers[sent % 100].set(float(sent))
            sent += 1
        time.sleep(0.002)
    network.flush()
    print("sent", sent, flush=True)
    sys.stdin.read()


types() if sys.argv[2] == "types" else load()
