# Prints what another reader of Driver Station logs finds. That reader is the module `oracle` beside real logs, in the folder given first.
import sys

sys.path.insert(0, sys.argv[1])
import oracle

if sys.argv[2].endswith(".dslog"):
    version, start, records = oracle.log(sys.argv[2])
    print(start)
    for r in records:
        numbers = [r["trip_ms"], r["loss"], r["volts"], r["cpu"], r["status"], r["can"]] + r.get("amps", [])
        print(*[repr(number) for number in numbers])
else:
    version, start, entries = oracle.events(sys.argv[2])
    for time, text in entries:
        print(repr(time - start), text.encode("latin1").hex() or "-")
