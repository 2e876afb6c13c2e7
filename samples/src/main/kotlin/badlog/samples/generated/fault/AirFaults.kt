package badlog.samples.generated.fault

import badlog.samples.generated.fault.Naming.PHOENIX
import badlog.samples.generated.fault.Naming.REV

private const val NO_PNEUMATICS = "The pneumatics module is not among the devices that are logged."

internal val AIR_FAULTS = listOf(
    fault("air-leak", "The pneumatics leak: the compressor runs on and on to hold the pressure.") {
        causes(
            "leak|leaks|leaking|leakage",
            "compressor runs|running|on constantly|always|all|continuous|continuously|long|often|most|time|percent",
            "compressor duty|cycles|cycling",
            "pressure falls|drops|loses without|unused|standing|disabled|use",
        )
        symptoms("pressure low|falls|drops|falling|dropping", "compressor current|draw|on|runs")
        strength("It loses 4 psi/s at working pressure at 1, 1.2 psi/s at 0.3; a compressor gives about 1.5 psi/s there.")
        needs(Need.PNEUMATICS)
        shownBy(Signal.PRESSURE, Signal.COMPRESSOR, Signal.CHANNEL_CURRENT)
        notSeen(PHOENIX, REV, because = NO_PNEUMATICS)
    },
    fault("compressor-dead", "The compressor does not run although the pressure is low: its fuse, wire or relay is open.") {
        causes("compressor not|never|dead|off|fuse|wire|broken|disabled|stopped|stays")
        symptoms("pressure low|falls|drops|falling|dropping|refill|recovers|recover|rises")
        strength("It has run last 120 s before the end at 1, 40 s before it at 0.3.")
        starts(30.0, 110.0)
        needs(Need.PNEUMATICS)
        shownBy(Signal.PRESSURE, Signal.CHANNEL_CURRENT, Signal.COMPRESSOR)
        notSeen(PHOENIX, REV, because = NO_PNEUMATICS)
    },
)
