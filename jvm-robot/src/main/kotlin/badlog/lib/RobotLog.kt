package badlog.lib

import java.io.File
import java.util.function.BooleanSupplier

/**
 * A log that manages its own files: their folder, names and disk space. Between [start] and the first [periodic], the
 * robot's code creates topics and values with the functions of [BadLog]. It must not call
 * [BadLog.finishInitialization], [BadLog.updateTopics] or [BadLog.log].
 *
 * Nothing is written until a driver station is connected, the robot is enabled, or a minute has passed, so that a robot
 * that was only switched on leaves no file. At most a tenth of a second later, the log's own thread opens the file. It
 * renames the file as time, event and match become known.
 */
public class RobotLog private constructor(
    /** The log itself, for its counters and settings. */
    public val log: BadLog,
    private val session: LogSession,
    private val options: RobotLogOptions,
) : AutoCloseable {
    private val time = options.time
    private val keeper = LogKeeper(session, options)
    private val disabledNanos = (options.disabledPeriod * 1e9).toLong()
    private var lastRow = time.now - disabledNanos
    private var wasEnabled = false

    /** Whether the robot was enabled in the last [periodic]. */
    private var isEnabled = false

    /** The file being written, with its current name; null while there is none. */
    public val file: File? get() = session.file?.path

    /** Logs a row if one is due. Call it at the end of each loop of the robot; it never throws. */
    public fun periodic() {
        isEnabled = ask(options.isEnabled, "isEnabled")
        if (session.state == LogState.SETTING_UP) {
            keeper.mayBegin(isEnabled || ask(options.isDriverStationAttached, "isDriverStationAttached"))
            return
        }
        if (session.state == LogState.CLOSED) return
        val now = time.now
        if (isEnabled || wasEnabled || now - lastRow >= disabledNanos) {
            lastRow = now
            wasEnabled = isEnabled
            session.update()
            session.log()
        }
    }

    /** Closes the log. */
    override fun close() {
        session.close()
        keeper.finish()
    }

    private fun ask(supplier: BooleanSupplier, name: String): Boolean = try {
        supplier.asBoolean
    } catch (failure: Throwable) {
        session.faults.callIgnored(name) { "$name could not be read: ${describe(failure)}. It counts as false." }
        false
    }

    private fun createStandardTopics() {
        val began = time.now
        BadLog.createTopicDouble("Time", "s", { (time.now - began) * 1e-9 }, "xaxis", "hide")
        BadLog.createTopicBoolean("Robot/Enabled", BadLog.UNITLESS, { isEnabled })
        options.batteryVoltage?.let { BadLog.createTopicDouble("Robot/Battery Voltage", "V", it, "zero") }
        BadLog.createEvents("Robot/Events")
    }

    public companion object {
        /** Starts a log with the options that suit most robots. See [RobotLog]. */
        @JvmStatic
        public fun start(): RobotLog = start(RobotLogOptions())

        /** Starts a log; if there already is one, it is closed first. See [RobotLog]. */
        @JvmStatic
        public fun start(options: RobotLogOptions): RobotLog {
            val session = LogSession(flushesEachRow = true, options.time)
            val robotLog = RobotLog(BadLog.start(session), session, options)
            if (options.hasStandardTopics) robotLog.createStandardTopics()
            robotLog.keeper.start()
            return robotLog
        }
    }
}
