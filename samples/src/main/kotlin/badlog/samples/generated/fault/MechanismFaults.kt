package badlog.samples.generated.fault

import badlog.samples.generated.fault.Naming.REV

private const val NO_SETPOINT = "Setpoints are not logged: how high or fast it should be is not known."

internal val MECHANISM_FAULTS = listOf(
    fault("elevator-short", "The elevator cannot lift its load: it stops below its setpoint with its motors at the current limit.") {
        causes(
            "elevator weak|load|heavy|overloaded|torque|lift|short|below|reach",
            "load|weight heavy",
            "motor weak|saturated",
        )
        symptoms(
            "error large|steady|persistent|setpoint|position|closed",
            "setpoint|target missed|reached|not|never",
            "stall|stalled|stalls|current high",
        )
        strength(
            "Its force is enough for 55 % of its load above half its height at 1 (a snagged rope, an added mechanism), for 93 % at 0.3.",
        )
        starts(15.0, 60.0)
        needs(Need.ELEVATOR)
        shownBy(Signal.MEASURED, Signal.MOTOR_CURRENT, Signal.MOTOR_POSITION, Signal.CHANNEL_CURRENT, Signal.SUPPLY_CURRENT)
        onlySymptom(REV, because = NO_SETPOINT)
    },
    fault("seized-mechanism", "The elevator is jammed: its motors stall against the blockage under their current limit.") {
        causes(
            "jam|jams|jammed",
            "block|blocked|blocks|blockage",
            "stall|stalls|stalled|stalling",
            "seized|seizes|binding|binds|bind",
            "obstruct|obstructed|obstruction",
        )
        symptoms(
            "current high|limit|more",
            "setpoint|target missed|reached|not|never",
            "error large|persistent|position|closed",
            "moving|move|moves not|slow",
        )
        strength("A friction of 100 % of what its motors can give at their limit at 1, of 50 % at 0.3; from then on at all heights.")
        starts(15.0, 80.0)
        needs(Need.ELEVATOR)
        shownBy(Signal.MEASURED, Signal.MOTOR_CURRENT, Signal.MOTOR_VELOCITY, Signal.CHANNEL_CURRENT, Signal.SUPPLY_CURRENT)
    },
    fault("limit-switch-stuck", "The elevator's bottom limit switch is stuck: it reads pressed when the elevator is up.") {
        causes(
            "limit switch|switches",
            "switch stuck|pressed|closed|jammed|broken|wiring",
            "limit pressed|active|reached|triggered|stuck while|although|always|up|height|never",
        )
        symptoms(
            "down|lower|lowering not|refuses|cannot|stays|stuck",
            "setpoint|target missed|reached|not|never",
            "error large|persistent|position|closed",
            "homed|zero|zeroed|position jumps|wrong|reset|resets",
        )
        strength("Stuck for the rest of the match at 1, for 30 % of the time, in stretches of 1 to 5 s, at 0.3.")
        starts(15.0, 80.0)
        needs(Need.ELEVATOR)
        shownBy(Signal.LIMIT_SWITCH, Signal.MEASURED)
    },
    fault("shooter-slow", "The shooter does not reach its speed: something rubs on its wheels, or one of its motors is weak.") {
        causes(
            "shooter|flywheel slow|reach|reaches|friction|weak|rub|rubs|drag|below|short",
            "friction shooter|flywheel|wheel",
            "motor weak",
            "speed|velocity below|reach|short",
        )
        symptoms(
            "velocity|speed below|low|error|short",
            "setpoint|target missed|reached|not|never",
            "current high|more",
            "output full|saturated|maximum",
        )
        strength("A drag that limits it to 65 % of its speed at 1, to 90 % at 0.3.")
        starts(5.0, 50.0)
        needs(Need.SHOOTER)
        shownBy(Signal.MOTOR_VELOCITY, Signal.MOTOR_CURRENT, Signal.MEASURED, Signal.CHANNEL_CURRENT, Signal.SUPPLY_CURRENT)
        onlySymptom(REV, because = NO_SETPOINT)
    },
    fault("oscillating-controller", "The shooter's speed controller oscillates: its gain is too high.") {
        causes(
            "shooter|flywheel|speed|velocity oscillat",
            "shooter|flywheel|speed|velocity gain|kp|pid|tuning|tuned",
            "unstable|instability",
            "hunting|hunts|ringing",
        )
        symptoms("velocity|speed|output|current noisy|varies|uneven|fluctuates|unsteady|swings|noise", "error large|setpoint")
        strength("The speed swings by about 9 % at 1, by 3 % at 0.3, at 1 to 2 Hz, whenever it should hold.")
        starts(0.0, 40.0)
        needs(Need.SHOOTER)
        shownBy(Signal.MOTOR_VELOCITY, Signal.MOTOR_OUTPUT, Signal.MEASURED)
    },
    fault("intake-jam", "A game piece jams in the intake: its motor stalls again and again.") {
        causes(
            "jam|jams|jammed",
            "intake|roller stall|stalls|stalled|stuck|blocked|blocks|stopped",
            "game piece|ball|note|coral stuck|wedged",
            "stall|stalls|stalled intake|roller|motor",
        )
        symptoms("current high|limit|more|peak|peaks", "intake slow|stops|velocity|speed|current", "velocity|speed zero|low|no")
        strength("Each piece jams for 3 s at 1, for 0.9 s at 0.3.")
        starts(15.0, 50.0)
        needs(Need.INTAKE)
        shownBy(Signal.MOTOR_CURRENT, Signal.MOTOR_VELOCITY, Signal.CHANNEL_CURRENT, Signal.SUPPLY_CURRENT)
    },
)
