package badlog.samples.generated.fault

import badlog.samples.generated.fault.Naming.BADLOG
import badlog.samples.generated.fault.Naming.PHOENIX
import badlog.samples.generated.fault.Naming.REV
import badlog.samples.generated.fault.Naming.WPILIB

internal val POWER_FAULTS = listOf(
    fault("old-battery", "The battery is old: its internal resistance is too high, so the voltage sags under ordinary loads.") {
        causes(
            "internal resistance",
            "battery old|weak|worn|aged|bad|dying",
            "battery resistance high|too|rises|risen",
            "battery health",
        )
        symptoms("brownout|brown|browned", "voltage sag|sags|low|dip|dips|drop|drops", "battery low")
        strength("Its resistance, leads included, is 20 mΩ in a healthy robot: plus 50 mΩ at 1, plus 15 mΩ at 0.3.")
        shownBy(Signal.BATTERY_VOLTAGE, Signal.BROWNED_OUT)
    },
    fault("discharged-battery", "The battery was not charged before the match: its voltage is low even without a load.") {
        causes(
            "battery not charged|full|fully",
            "battery discharged|uncharged|empty|flat",
            "charge battery",
            "resting|rest|open|idle|unloaded voltage low",
            "started|starts|start voltage low",
        )
        symptoms("brownout|brown|browned", "voltage low|sag|sags|dip|dips|drop|drops", "battery low")
        strength("Its voltage at rest is 12.7 V when charged: 1.2 V less at 1, 0.36 V less at 0.3.")
        shownBy(Signal.BATTERY_VOLTAGE, Signal.BROWNED_OUT)
    },
    fault("loose-battery-lead", "A battery lead is loose: at bumps the voltage collapses for moments, whatever the current is.") {
        causes(
            "loose battery|lead|terminal|connector|power",
            "battery connection|connector|terminal|lead|contact|cable",
            "main breaker loose|connection|lug",
            "contact resistance",
            "intermittent power|connection|contact",
            "supply|power wiring|lugs",
        )
        symptoms("brownout|brown|browned", "voltage drop|drops|dip|dips|sag|sags|spike|spikes|collapse|collapses")
        strength("At a bump, and now and then between, 60 mΩ (0.3) to 200 mΩ (1) more for 30 to 250 ms.")
        starts(10.0, 60.0)
        shownBy(Signal.BATTERY_VOLTAGE, Signal.BROWNED_OUT)
    },
    fault("too-much-at-once", "Too many motors draw too much at once: their current limits are missing or too high for one battery.") {
        causes(
            "current limits|limiting",
            "supply|drive current limit",
            "total current",
            "at once motors|mechanisms|everything|subsystems|many",
            "same time motors|mechanisms|subsystems",
            "simultaneously",
            "draw|draws|demand too|much|heavy|exceeds|robot|everything",
        )
        symptoms("brownout|brown|browned", "voltage sag|sags|low|dip|dips|drop|drops", "battery low")
        strength("The drive's supply limits are 1.5 times (0.3) to 3 times (1) what they should be, and the driver drives harder.")
        shownBy(Signal.BATTERY_VOLTAGE, Signal.TOTAL_CURRENT, Signal.SUPPLY_CURRENT, Signal.CHANNEL_CURRENT, Signal.MOTOR_CURRENT)
    },
    fault("radio-power-loss", "The radio lost its power when the voltage dipped, and took half a minute to start again.") {
        causes("radio power|reboot|reboots|rebooted|restart|restarted|reset|brownout|voltage", "radio lost power")
        symptoms(
            "lost|loss|lose communication|comms|link|connection|radio",
            "disabled match|teleop|while|during|unexpectedly|middle",
            "driver station detached|disconnected|lost|attached",
            "voltage dip|dips|drop|drops|sag|sags",
        )
        strength("The dip lasts 0.3 s; the link is then away for 30 s at 1, for 9 s at 0.3 (a radio that was only disturbed).")
        starts(25.0, 90.0)
        shownBy(Signal.LINK, Signal.ENABLED, Signal.BATTERY_VOLTAGE)
        onlySymptom(WPILIB, PHOENIX, REV, BADLOG, because = "No topic of the link: the robot is disabled after a dip, whoever did it.")
    },
    fault("tripped-breaker", "The breaker of one motor tripped: its channel has no current although the motor is commanded.") {
        causes(
            "breaker",
            "channel trip|trips|tripped|open|dead|power|unpowered",
            "motor|controller lost|without|no power",
            "motor|channel fuse",
        )
        symptoms(
            "current zero|no|without|stops|stopped|0",
            "motor not running|responding|moving|driving",
            "disconnected|lost motor|device",
            "output current no|without",
        )
        strength("After a hard pull the channel is dead for 100 s at 1, for 30 s at 0.3; breakers close again as they cool.")
        starts(40.0, 80.0)
        shownBy(Signal.CHANNEL_CURRENT, Signal.BREAKER_FAULT, Signal.MOTOR_CURRENT, Signal.SUPPLY_CURRENT, Signal.MOTOR_CONNECTED)
        onlySymptom(PHOENIX, REV, because = "The device falls silent with its power; a broken CAN wire looks the same.")
    },
)
