package badlog.lib

import java.io.File
import java.util.function.BooleanSupplier
import java.util.function.DoubleSupplier
import java.util.function.Supplier

/**
 * How [RobotLog.start] logs. All that it asks the robot for is asked from WPILib, whichever season's, unless a supplier
 * is set here; without WPILib the robot counts as enabled, and event, match and battery as unknown.
 */
public class RobotLogOptions {
    private val wpilib = Wpilib.find(RobotLogOptions::class.java.classLoader)

    /** Where to log; null for a USB stick if there is one, else the robot's own folder, else `logs` where it runs. */
    public var folder: File? = null

    /** Whether to write gzip files, a third of the size for a little more of the robot's time. */
    public var isCompressed: Boolean = false

    /** Whether to create the topics `Time`, `Robot/Enabled`, `Robot/Battery Voltage` and `Robot/Events`. */
    public var hasStandardTopics: Boolean = true

    /** Seconds after which the header is written though neither a driver station is there nor the robot enabled. */
    public var headerTimeout: Double = 60.0

    /** Seconds from row to row while the robot is disabled. */
    public var disabledPeriod: Double = 0.25

    /** Whether the robot is enabled. Asked in each [RobotLog.periodic]. */
    public var isEnabled: BooleanSupplier = wpilib.isEnabled

    /** Whether a driver station is connected. Asked in each [RobotLog.periodic] until logging begins. */
    public var isDriverStationAttached: BooleanSupplier = wpilib.isDriverStationAttached

    /** Whether the clock is right; on a robot, a driver station has to set it. Asked by another thread. */
    public var isClockSet: BooleanSupplier = wpilib.isClockSet

    /** The event's name, or an empty text as long as it is unknown. Asked by another thread. */
    public var event: Supplier<String> = wpilib.event

    /** The match, such as `Q42`, `P3`, `E7`, or an empty text as long as it is unknown. Asked by another thread. */
    public var match: Supplier<String> = wpilib.match

    /** The battery's voltage; null for no topic. */
    public var batteryVoltage: DoubleSupplier? = wpilib.batteryVoltage

    /** Free bytes where a folder is. */
    internal var freeBytes: (File) -> Long = File::getUsableSpace
}
