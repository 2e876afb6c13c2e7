package badlog.samples.generated.fault

/**
 * A team's way of logging, which decides how much of a fault can be seen.
 *
 * @property id its name in file names and on the command line.
 * @property isBag whether its file is a bag; otherwise a WPILOG.
 */
enum class Naming(val id: String, val isBag: Boolean) {
    /** AdvantageKit: all inputs and outputs of the robot's code, once per loop, only changes. */
    ADVANTAGEKIT("advantagekit", false),

    /** WPILib's `DataLogManager`: the Driver Station, the team's dashboard values, and the console. */
    WPILIB("wpilib", false),

    /** A `hoot` log of Phoenix 6's signal logger, converted: each status signal of each CTRE device, and the state of the drive. */
    PHOENIX("phoenix", false),

    /** A `revlog` of REVLib's status logger, merged with the Driver Station's part of WPILib's log: each status signal of each Spark. */
    REV("rev", false),

    /** A bag, with names as teams gave them in badlog's first years. */
    BADLOG("badlog", true),
}
