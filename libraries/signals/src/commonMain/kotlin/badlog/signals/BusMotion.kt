package badlog.signals

import badlog.core.analysis.Series
import badlog.signals.derived.BusDevice
import badlog.signals.derived.BusRoles
import badlog.signals.derived.BusSignal
import badlog.signals.derived.correlation
import badlog.signals.derived.heldAt
import badlog.signals.derived.turnsAround
import kotlin.math.abs

/** The movements and roles of the motors among [devices], by [samples]. All arrays have the same [times]. */
internal class BusMotion(devices: List<BusDevice>, private val samples: NamedSamples) {
    private val motors = devices.filter { it.isMotor }
    private val held = HashMap<String, DoubleArray>()

    val times: DoubleArray = motors.mapNotNull { raw(it, BusSignal.VELOCITY).range }.let { ranges ->
        val start = ranges.minOfOrNull { it.start } ?: 0.0
        val end = ranges.maxOfOrNull { it.endInclusive } ?: 0.0
        DoubleArray(((end - start) / STEP_SECONDS).toInt().coerceIn(0, MAX_STEPS)) { start + it * STEP_SECONDS }
    }

    val isEnabled: BooleanArray = samples.enabledAt(times)

    private val roles = BusRoles(
        motors.map { valuesOf(it, BusSignal.VELOCITY) },
        motors.map { motor -> motor.topic(BusSignal.POSITION)?.let(::valuesOf) ?: DoubleArray(0) },
        motors.map { motor ->
            // An encoder of a wheel that steers begins again after each turn. One that a motor controller reads may also be an arm's.
            val own = motor.topic(BusSignal.ABSOLUTE)
            if (own != null) turnsAround(valuesOf(own)) else devices.any { BusSignal.ABSOLUTE in it && it.id == motor.id }
        },
    )
    private val steering = roles.steering.map { motors[it].id }
    private val leaders = roles.leaders.map { motors[it] }
    private val mechanisms = roles.mechanisms.map { motors[it] }

    /** The drive motors: four of a swerve drive, two of a tank drive; empty if they are not known. */
    val drive: List<BusDevice> = roles.drive.map { motors[it] }

    fun isLeader(device: BusDevice): Boolean = device in leaders

    /** Returns whether [device] moves a mechanism, not the robot. */
    fun isOfMechanism(device: BusDevice): Boolean = device in mechanisms

    /** Returns whether [device] is a motor or an encoder for the steering of a module. */
    fun isSteering(device: BusDevice): Boolean = device.id in steering

    fun raw(device: BusDevice, signal: BusSignal): Series = samples.raw(checkNotNull(device.topic(signal)))

    fun valuesOf(device: BusDevice, signal: BusSignal): DoubleArray = valuesOf(checkNotNull(device.topic(signal)))

    /** Returns the values of the topic [name]. */
    fun valuesOf(name: String): DoubleArray = held.getOrPut(name) { samples.raw(name).heldAt(times) }

    /** Returns the drive motor for each of [speeds], the speeds of modules; null unless each has its own. */
    fun driversOf(speeds: List<DoubleArray>): List<BusDevice>? {
        if (drive.size != speeds.size) return null
        fun size(values: DoubleArray) = DoubleArray(values.size) { abs(values[it]) }
        val own = drive.map { size(valuesOf(it, BusSignal.VELOCITY)) }
        val best = speeds.map { speed ->
            val wanted = size(speed)
            drive.indices.maxByOrNull { correlation(own[it], wanted) } ?: return null
        }
        return if (best.distinct().size == best.size) best.map { drive[it] } else null
    }

    companion object {
        const val STEP_SECONDS = 0.02

        /** A log of an hour is judged by its first half hour. */
        private const val MAX_STEPS = 90_000
    }
}
