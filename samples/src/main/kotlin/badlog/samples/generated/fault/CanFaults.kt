package badlog.samples.generated.fault

import badlog.samples.generated.fault.Naming.BADLOG
import badlog.samples.generated.fault.Naming.PHOENIX
import badlog.samples.generated.fault.Naming.REV
import badlog.samples.generated.fault.Naming.WPILIB

internal val CAN_FAULTS = listOf(
    fault("can-dropout", "A motor controller drops off the CAN bus: its wire is loose, and its values freeze.") {
        causes(
            "can device|wire|wiring|connection|dropout|dropped|drops|loose|disconnected|offline",
            "motor|controller|device|talon|talonfx|spark|module disconnected|dropout|unreachable|offline",
            "lost contact|communication motor|device|controller",
        )
        symptoms(
            "value|values|reading|readings|signal|signals|samples frozen|freeze|freezes|stale|constant|stop|stops|stuck|gap|gaps",
            "motor not running|responding|moving|stopped",
            "frozen|stale",
        )
        strength("Off the bus for all of the rest at 1, for 30 % of the time, in stretches of 0.5 to 3 s, at 0.3.")
        starts(20.0, 90.0)
        shownBy(
            Signal.MOTOR_CONNECTED,
            Signal.CONSOLE,
            Signal.MOTOR_CURRENT,
            Signal.MOTOR_VELOCITY,
            Signal.MOTOR_POSITION,
            Signal.SUPPLY_CURRENT,
            Signal.MEASURED,
            Signal.CHANNEL_CURRENT,
        )
        onlySymptom(BADLOG, because = "Values freeze and the current is 0, without a word about the bus; a dead controller looks the same.")
    },
    fault("can-overload", "The CAN bus is overloaded: frames are late or lost.") {
        causes(
            "can utilization|utilisation|load|overloaded|full|busy|saturated|traffic|bandwidth|usage",
            "bus utilization|overloaded|saturated|load|full|busy",
            "status frames|frame rate|period|periods",
        )
        symptoms(
            "can error|errors|timeout|timeouts|late|lost|stale|frames",
            "value|values|reading|readings|signal|signals|sample|samples stale|late|old|delayed|missing|gap|gaps",
        )
        strength("Utilization 100 % and 45 % of frames lost at 1; 88 % and 12 % lost at 0.3. Healthy: 45 to 70 %.")
        shownBy(Signal.CAN_UTILIZATION, Signal.CAN_ERRORS, Signal.CONSOLE, Signal.MOTOR_VELOCITY)
        onlySymptom(WPILIB, because = "Utilization is not logged; the console has CAN timeouts of several devices.")
        onlySymptom(PHOENIX, REV, because = "Utilization is not logged; frames of all devices are missing now and then.")
    },
)
