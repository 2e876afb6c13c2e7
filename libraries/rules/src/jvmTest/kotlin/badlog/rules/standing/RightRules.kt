package badlog.rules.standing

/** Rules about the effects of a robot that draws too much current on its battery. */
private val LOAD = setOf(
    "Browned out", "Below the brownout voltage", "Low battery", "Weak battery", "Too much at once", "Main breaker", "High total current",
    "Current too long", "High current", "Motor hot", "Motor too hot",
)
private val BATTERY = setOf(
    "Browned out",
    "Below the brownout voltage",
    "Low battery",
    "Weak battery",
    "Battery not charged",
    "High battery resistance",
    "Raised battery resistance",
)
private val BLOCKED = setOf(
    "Motor stalled", "Still at stall current", "Motor does not turn", "Driven without moving", "Position stands still", "Output without effect", "Away from its setpoint", "Speed not reached",
    "Output saturated", "Moves harder", "Current too long", "High current", "Too much at once", "Motor hot", "Motor too hot", "Side stands still",
)
private val CAN = setOf(
    "CAN errors", "CAN bus full", "One CAN bus full", "CAN utilization high", "CAN bus off", "Values frozen", "Device without values", "Device lost",
    "Sensor lost", "Error logged", "Motor fault",
)
private val LINK = setOf(
    "Link lost",
    "Packets late",
    "Packets very late",
    "Packets lost",
    "Many packets lost",
    "Very weak radio signal",
    "Weak radio signal",
    "Error logged",
)
private val SLOW = setOf(
    "Loop blocked", "Loop overrun", "Slow loops", "Loop overruns reported", "Gap in time", "Long garbage collection",
    "Frequent garbage collection", "CPU busy", "CPU overloaded",
)
private val RESTARTED = setOf("Restarted in the match", "Log begins in teleop", "Ended in the match", "Code restarted", "Code crashed", "Error logged", "Gap in time")
private val ENCODER = setOf(
    "Encoder frozen", "Encoder stopped", "Position stands still", "Encoders disagree", "Linked speeds differ", "Away from its setpoint", "Output without effect", "Flat sensor",
    "Sensor lost", "Device lost", "Side stands still", "Output saturated", "Values frozen", "Motor and mechanism disagree", "Module does not turn",
)
private val GYRO = setOf("Heading jumped", "Gyro drifts", "Pose jumped", "Sensor lost", "Device lost", "Left the plan", "Flat sensor")
private val MODULE = setOf("Module does not turn", "Module lags", "Module draws less current", "Channel lost its share", "Away from its setpoint")
private val UNPOWERED = setOf(
    "Breaker open", "Channel rests alone", "Device without values", "Device lost", "Output without voltage", "Linked motor without current",
    "Linked motors unequal", "Channel lost its share", "Module draws less current", "Module does not turn", "Motor fault", "Values frozen",
    "Away from its setpoint", "Speed not reached", "Encoder frozen", "Output without effect", "Side needs more output", "Sensor lost", "Error logged",
)
private val AIR = setOf("Stored air falls", "Low air pressure", "Compressor without effect")

/** Rules that repeat faults that the robot's computer reported of itself: true in any match. */
internal val FACTS: Set<String> = setOf("Browned out", "Below the brownout voltage", "CAN bus off", "Code crashed")

/** Rules that repeat messages: true wherever something is wrong, whatever the cause of it. */
internal val MESSAGES: Set<String> = setOf("Error logged", "Loop overruns reported")

/**
 * Returns the rules with a finding that says something true about a match with [fault]. A simulator by another author planted it; the
 * finding names its cause, or what follows from it. Null for a fault that is unknown here.
 */
internal fun rightRulesFor(fault: String): Set<String>? = RIGHT[fault]

/** The rules that are right about some fault. */
internal val ALL_RIGHT: Set<String> get() = RIGHT.values.flatten().toSet()

private val RIGHT = mapOf(
    // The second simulator.
    "brownout" to LOAD + BLOCKED,
    "lead" to BATTERY + RESTARTED + LINK + "Bad battery contact" + "Radio lost power",
    "stall" to BLOCKED,
    "can" to CAN,
    "vision" to SLOW + setOf("Loop and vision late together", "Vision in the loop", "Vision jumps", "Late pictures", "No new pictures"),
    "encoder" to ENCODER,
    "gyro" to GYRO,
    "radio" to LINK + setOf("Radio lost power", "Controller unplugged"),
    "air" to AIR,
    "module" to MODULE,
    "restart" to RESTARTED,
    "jam" to BLOCKED,
    // The third.
    "battery_tired" to BATTERY + LOAD,
    "battery_lead_loose" to BATTERY + RESTARTED + LINK + "Bad battery contact" + "Radio lost power",
    "breaker_trips" to UNPOWERED,
    "drive_motor_lost" to UNPOWERED + CAN,
    "module_offset" to MODULE,
    "mechanism_jammed" to BLOCKED,
    "encoder_lost" to ENCODER + BLOCKED,
    "gyro_lost" to GYRO,
    "slow_loops" to SLOW,
    "link_lost" to LINK + setOf("Radio lost power", "Controller unplugged"),
    "can_bus_fault" to CAN,
    "code_crash" to RESTARTED,
    "controller_unplugged" to setOf("Controller unplugged", "Error logged"),
    "air_leak" to AIR,
    "setpoint_not_held" to setOf(
        "Overshoot",
        "Away from its setpoint",
        "Position oscillates",
        "Speed oscillates",
        "Speed not reached",
        "Output saturated",
        "Motor and mechanism disagree",
        "Driven without moving",
    ),
    "motor_overheats" to LOAD + BLOCKED,
    // The fifth says itself in which words a finding is right. A module that points aside also drives against the others.
    "abs_slip" to MODULE + LOAD,
)
