package badlog.samples.generated.robot

/**
 * A lead-acid battery of 18 Ah with its leads. It has a voltage that falls with the charge, a resistance, and a slow part that recovers.
 *
 * @param restVolts the voltage at rest, before the match.
 * @param resistance the resistance in Ω, including leads and breaker.
 */
internal class Battery(restVolts: Double, val resistance: Double) {
    private val fullVolts = restVolts
    private var used = 0.0
    private var slow = 0.0

    /** The resistance of a loose contact in its leads, in Ω; 0 if they are tight. */
    var contact = 0.0

    /** The difference to a fully charged battery, in V. */
    var missingVolts = 0.0

    /** The voltage at the robot, in V. */
    var volts = restVolts
        private set

    /** The current drawn by the robot, in A. */
    var current = 0.0
        private set

    /** The energy that left the battery's terminals, in J. */
    var energy = 0.0
        private set

    /** The energy that became heat in the battery and its leads, in J. */
    var heat = 0.0
        private set

    /** The voltage without a load, in V. */
    val openVolts: Double get() = fullVolts - missingVolts - used / CAPACITY * VOLTS_OVER_CHARGE - slow

    /** Draws [amperes] for [dt] s; [slope] is the change of the current per V, in A/V. */
    fun take(amperes: Double, slope: Double, dt: Double) {
        current = amperes
        used += amperes * dt
        slow += dt / SLOW_SECONDS * (amperes * SLOW_RESISTANCE - slow)
        val series = resistance + contact
        val target = openVolts - amperes * series
        volts += FOLLOWING * (target - volts) / (1 + series * slope)
        volts = volts.coerceIn(MIN_VOLTS, MAX_VOLTS)
        energy += volts * amperes * dt
        heat += (openVolts - volts) * amperes * dt
    }
}

// 18 Ah at the 20 h rate; at a robot's currents, about two thirds of that are available.
private const val CAPACITY = 18.0 * 3600 * 0.65
private const val VOLTS_OVER_CHARGE = 1.1
private const val SLOW_SECONDS = 12.0
private const val SLOW_RESISTANCE = 0.003

// The controllers' capacitors smooth the jump of a step.
private const val FOLLOWING = 0.7

// Below that, the roboRIO is off, and there would be no log.
private const val MIN_VOLTS = 4.8

// Controllers turn the energy of braking motors beyond this voltage into heat.
private const val MAX_VOLTS = 13.45
