package badlog.lib

import java.io.File
import java.util.function.BooleanSupplier
import java.util.function.DoubleSupplier
import java.util.function.Supplier

/**
 * Options of [RobotLog.start]. Everything about the robot comes from WPILib, of any season, unless a supplier is set here. Without WPILib,
 * the robot counts as enabled, and event, match and battery voltage as unknown.
 */
public class RobotLogOptions {
    private val wpilib = Wpilib.find(RobotLogOptions::class.java.classLoader)

    /**
     * The folder to log to. Default: null, which means a USB stick if there is one, otherwise the robot's own folder, otherwise `logs` in
     * the working directory.
     */
    public var folder: File? = null

    /** Whether to write gzip files: a third of the size, for a little more of the robot's time. Default: false. */
    public var isCompressed: Boolean = false

    /** Whether to create the topics `Time`, `Robot/Enabled`, `Robot/Battery Voltage` and `Robot/Events`. */
    public var hasStandardTopics: Boolean = true

    /** Seconds after which the header is written even if no driver station is connected and the robot is not enabled. */
    public var headerTimeout: Double = 60.0

    /** Seconds between rows while the robot is disabled. */
    public var disabledPeriod: Double = 0.25

    /** Whether the robot is enabled. Called in each [RobotLog.periodic]. */
    public var isEnabled: BooleanSupplier = wpilib.isEnabled

    /** Whether a driver station is connected. Called in each [RobotLog.periodic] until logging begins. */
    public var isDriverStationAttached: BooleanSupplier = wpilib.isDriverStationAttached

    /** Whether the clock is right; on a robot, a driver station must set it first. Called from another thread. */
    public var isClockSet: BooleanSupplier = wpilib.isClockSet

    /** The event's name, or an empty text while it is unknown. Called from another thread. */
    public var event: Supplier<String> = wpilib.event

    /** The match, such as `Q42`, `P3`, `E7`, or an empty text while it is unknown. Called from another thread. */
    public var match: Supplier<String> = wpilib.match

    /** The battery voltage in volts; null for no topic. */
    public var batteryVoltage: DoubleSupplier? = wpilib.batteryVoltage

    /** Returns the free bytes on the disk of a folder. */
    internal var freeBytes: (File) -> Long = File::getUsableSpace

    /** Renames a file. Returns false if the system cannot. */
    internal var move: (from: File, to: File) -> Boolean = File::renameTo

    /** The clock of the log's pauses. */
    internal var time: LogTime = LogTime()
}
