"""Writes what WPILib's own client receives from a server: python listen.py PORT TOPICS

Lines of JSON on standard output: each topic as it is announced, "ready" once TOPICS of them are known, each value with the
server's time in microseconds, and "lost" when the connection is. Ends when standard input does.
"""
import json
import sys
import threading
import time

import ntcore

port, topics = int(sys.argv[1]), int(sys.argv[2])
network = ntcore.NetworkTableInstance.create()
options = ntcore.PubSubOptions(sendAll=True, keepDuplicates=True, periodic=0.01)
everything = ntcore.MultiSubscriber(network, [""], options)
poller = ntcore.NetworkTableListenerPoller(network)
poller.addListener(everything, ntcore.EventFlags.kTopic | ntcore.EventFlags.kValueAll)
poller.addConnectionListener(False)
network.startClient4("listen.py")
network.setServer("127.0.0.1", port)


def write(**line):
    print(json.dumps(line), flush=True)


ended = threading.Event()
threading.Thread(target=lambda: (sys.stdin.read(), ended.set()), daemon=True).start()
known = set()
last_round = False
while not last_round:
    last_round = ended.is_set()
    for event in poller.readQueue():
        if event.is_(ntcore.EventFlags.kPublish):
            info = event.data
            write(topic=info.name, type=info.type_str, properties=json.loads(info.properties))
            known.add(info.name)
            if len(known) == topics:
                write(ready=True)
        elif event.is_(ntcore.EventFlags.kValueAll):
            value = event.data.value
            plain = value.value()
            write(
                value=list(plain) if isinstance(plain, bytes) else plain, of=event.data.topic.getName(),
                micros=value.server_time(),
            )
        elif event.is_(ntcore.EventFlags.kDisconnected):
            write(lost=True)
    time.sleep(0.005)
