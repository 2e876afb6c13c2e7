package badlog.samples.generated.fault

import badlog.samples.generated.fault.Naming.ADVANTAGEKIT
import badlog.samples.generated.fault.Naming.BADLOG
import badlog.samples.generated.fault.Naming.PHOENIX
import badlog.samples.generated.fault.Naming.REV
import badlog.samples.generated.fault.Naming.WPILIB

private const val DEVICES_ONLY = "Devices are logged by a thread and clocks of their own, which a late loop does not disturb."

internal val COMPUTER_FAULTS = listOf(
    fault("garbage-collection", "Java's garbage collector stops the loop again and again: the code allocates too much for the memory.") {
        causes(
            "garbage",
            "gc|collector|collection pause|pauses|time|java|stops",
            "memory full|low|pressure|allocates|allocation|heap",
            "allocat",
        )
        symptoms("loop overrun|overruns|slow|late|long|time|period", "cycle long|slow|late|overrun", "gap|gaps rows|samples|log|recording")
        strength("A pause of 250 ms each 2.5 s at 1; of 75 ms each 6 s at 0.3.")
        starts(5.0, 40.0)
        shownBy(Signal.LOOP_TIME, Signal.COLLECTION_TIME, Signal.CONSOLE, Signal.TIME)
        onlySymptom(WPILIB, because = "Overrun messages blame whatever code ran during the pause.")
        onlySymptom(BADLOG, because = "Only the loop's time is logged, not what it was spent on.")
        notSeen(PHOENIX, REV, because = DEVICES_ONLY)
    },
    fault("blocking-call", "The vision code waits for its camera inside the loop, so loops overrun.") {
        causes(
            "vision slow|blocks|blocking|waits|long|time|takes|took|overrun|periodic",
            "camera slow|blocks|blocking|waits|read|call",
            "blocking|blocks|blocked call|read|code|loop",
            "user code slow|long|time|ms",
        )
        symptoms("loop overrun|overruns|slow|late|long|time|period", "cycle long|slow|late|overrun", "gap|gaps rows|samples|log|recording")
        strength("Each new frame of the camera (15 per s) costs 60 ms at 1, 18 ms at 0.3, in the loop that reads it.")
        starts(5.0, 40.0)
        needs(Need.VISION)
        shownBy(Signal.LOOP_TIME, Signal.VISION_TIME, Signal.CONSOLE, Signal.TIME)
        onlySymptom(BADLOG, because = "Only the loop's time is logged, not what it was spent on.")
        notSeen(PHOENIX, REV, because = DEVICES_ONLY)
    },
    fault("cpu-overload", "The processor is overloaded by other programs on the robot, so all loops are late and uneven.") {
        causes(
            "cpu|processor load|overloaded|busy|full|usage|percent|high|100",
            "processes|threads|programs cpu|processor|other",
            "overloaded computer|roborio|cpu|processor",
        )
        symptoms(
            "loop overrun|overruns|slow|late|long|time|period|jitter|uneven",
            "cycle long|slow|late|overrun|jitter",
            "gap|gaps rows|samples|log|recording",
        )
        strength("Load 100 % and loops of 20 to 45 ms at 1; load 82 % and loops of 20 to 27 ms at 0.3.")
        starts(5.0, 40.0)
        shownBy(Signal.LOOP_TIME, Signal.CPU_LOAD, Signal.CONSOLE, Signal.TIME)
        onlySymptom(ADVANTAGEKIT, WPILIB, because = "The load of the processor is not logged, only that all parts of the loop take longer.")
        notSeen(PHOENIX, REV, because = DEVICES_ONLY)
    },
    fault("code-crash", "The robot's code crashed with an exception, and the log ends where it did.") {
        causes("crash|crashes|crashed", "exception", "code restart|restarted|died|dies|quit|stopped", "nullpointer|null", "unhandled")
        symptoms(
            "log|recording|file ends|end|stops|cut|short|truncated|incomplete",
            "ended enabled|early|match|middle",
            "disabled match|teleop|unexpectedly|middle",
        )
        strength("The log lacks the last 90 s of the match at 1, the last 27 s at 0.3.")
        starts(60.0, 126.0)
        shownBy(Signal.CONSOLE, Signal.ENABLED)
        onlySymptom(PHOENIX, REV, BADLOG, because = "No console: the log ends while enabled, as it would if the power was cut.")
    },
)
