package badlog.signals

import badlog.core.analysis.Series
import badlog.signals.derived.BusDevice
import badlog.signals.derived.BusSignal
import badlog.signals.derived.Following
import badlog.signals.derived.Side
import badlog.signals.derived.busSilence
import badlog.signals.derived.correlation
import badlog.signals.derived.coupledMotor
import badlog.signals.derived.couplingError
import badlog.signals.derived.currentShares
import badlog.signals.derived.frictionRise
import badlog.signals.derived.frozenWhileTurning
import badlog.signals.derived.fullCurrentOf
import badlog.signals.derived.hasDirection
import badlog.signals.derived.heldAt
import badlog.signals.derived.heldSpeeds
import badlog.signals.derived.largestOf
import badlog.signals.derived.longPressed
import badlog.signals.derived.moduleSpeedShares
import badlog.signals.derived.rangeOf
import badlog.signals.derived.scaled
import badlog.signals.derived.sideFriction
import badlog.signals.derived.stall
import badlog.signals.derived.suppliedCurrent
import badlog.signals.derived.switchError
import badlog.signals.derived.timesOf
import badlog.signals.swerve.ModuleTopics
import kotlin.math.abs

/**
 * Signals of [devices] on the CAN bus that are named by their ids alone. Their mechanism is inferred from their behavior, so a signal may
 * turn out to have no samples; findings name the device.
 */
internal class BusSignals(private val devices: List<BusDevice>, private val modules: List<ModuleTopics>) {
    private val motors = devices.filter { it.isMotor }

    /** Motors that log only their supply current, not the current of their windings. */
    private val supplied = devices.filter { device -> !device.isMotor && SUPPLIED.all { it in device } }

    val signals: List<DerivedSignal>
        get() = standingAlone(
            devices.map(::silent) + devices.flatMap(::coupling) + motors.flatMap(::ofMotor) + supplied.map(::blocked) +
                devices.mapNotNull(::standstill),
        )

    /**
     * Returns the total current of the motors; null if there are too few. It has no samples unless [battery] falls with it, since other
     * devices then draw most of the current.
     */
    fun totalCurrent(battery: (NamedSamples) -> Series): DerivedSignal? {
        val known = motors.filter { BusSignal.SUPPLY_CURRENT in it || BusSignal.OUTPUT in it }
        if (known.size < MIN_MOTORS) return null
        val topics = known.map { checkNotNull(it.topic(BusSignal.SUPPLY_CURRENT) ?: it.topic(BusSignal.CURRENT)) }
        return DerivedSignal("total current", "A", "", topics) { samples ->
            val motion = samples.motion()
            val sum = DoubleArray(motion.times.size)
            for (motor in known) {
                val own = suppliedTo(motor, motion)
                for (i in sum.indices) if (own[i].isFinite()) sum[i] += own[i]
            }
            val isKnown = correlation(sum, battery(samples).heldAt(motion.times)) < EXPLAINED
            if (isKnown) Series(motion.times, sum) else NOTHING
        }
    }

    /** The highest battery current of a motor at each time; null if no motor logs its current. */
    val largestCurrent: DerivedSignal? = motors.filter { BusSignal.SUPPLY_CURRENT in it || BusSignal.OUTPUT in it }.let { known ->
        val topics = known.map { checkNotNull(it.topic(BusSignal.SUPPLY_CURRENT) ?: it.topic(BusSignal.CURRENT)) }
        if (known.isEmpty()) return@let null
        DerivedSignal("largest current", "A", "", topics) { samples ->
            val motion = samples.motion()
            Series(motion.times, largestOf(known.map { suppliedTo(it, motion) }))
        }
    }

    /**
     * Returns the current that [motor] takes from the battery. It is as logged, or from its windings and output; negative while it brakes.
     */
    private fun suppliedTo(motor: BusDevice, motion: BusMotion): DoubleArray {
        if (BusSignal.SUPPLY_CURRENT in motor) return motion.valuesOf(motor, BusSignal.SUPPLY_CURRENT)
        return suppliedCurrent(
            motion.valuesOf(motor, BusSignal.CURRENT),
            motion.valuesOf(motor, BusSignal.OUTPUT),
            motion.valuesOf(motor, BusSignal.VELOCITY),
        )
    }

    /** Returns the drive motors in the order of the modules; null if their assignment is unknown. */
    fun driversOfModules(samples: NamedSamples): List<BusDevice>? {
        if (modules.isEmpty() || motors.size < modules.size) return null
        val motion = samples.motion()
        return motion.driversOf(modules.map { motion.valuesOf(it.speed) })
    }

    private fun NamedSamples.motion() = busMotion ?: BusMotion(devices, this).also { busMotion = it }

    private fun silent(device: BusDevice): DerivedSignal {
        val others = devices.filter { it !== device }
        return DerivedSignal("device silent", "s", device.label, device.names) { samples ->
            fun busiest(of: BusDevice) = of.names.map(samples::raw).maxByOrNull { it.size } ?: NOTHING
            busSilence(device.names.map(samples::raw), others.map(::busiest)) { samples.enabledAt(doubleArrayOf(it))[0] }
        }
    }

    private fun ofMotor(motor: BusDevice): List<DerivedSignal> = listOfNotNull(
        derived("module current share", "", motor, BusSignal.CURRENT, BusSignal.SUPPLY_CURRENT, BusSignal.VELOCITY) { motion ->
            val currents = motion.drive.map { motion.valuesOf(it, BusSignal.CURRENT) }
            val shares = if (currents.size == 4) currentShares(motion.times, currents, motion.isEnabled) else null
            once(motion.times, shares?.getOrNull(motion.drive.indexOf(motor)))
        },
        speedShare(motor).takeIf { modules.isNotEmpty() },
        friction(motor).takeIf { BusSignal.OUTPUT in motor },
        jam(motor),
        swing(motor).takeIf { BusSignal.OUTPUT in motor && BusSignal.REFERENCE !in motor },
        switch(motor),
        frictionOfMechanism(motor),
    ) + following(motor)

    private fun derived(name: String, unit: String, device: BusDevice, vararg shown: BusSignal, calculated: (BusMotion) -> Series) =
        DerivedSignal(name, unit, device.label, shown.mapNotNull(device::topic)) { calculated(it.motion()) }

    private fun frictionOfMechanism(motor: BusDevice): DerivedSignal? {
        val position = motor.topic(BusSignal.POSITION) ?: return null
        val topics = listOfNotNull(motor.topic(BusSignal.CURRENT), motor.topic(BusSignal.OUTPUT), position, motor.topic(BusSignal.VELOCITY))
        return DerivedSignal("friction rise", "", motor.label, topics) { samples ->
            val motion = samples.motion()
            // Of motors on one shaft, one stands for all.
            if (!motion.isOfMechanism(motor)) return@DerivedSignal NOTHING
            val current = motion.valuesOf(motor, BusSignal.CURRENT)
            val effort = if (hasDirection(current)) current else motor.topic(BusSignal.OUTPUT)?.let(motion::valuesOf)
            once(motion.times, effort?.let { frictionRise(motion.times, motion.valuesOf(position), it, motion.isEnabled) })
        }
    }

    private fun speedShare(motor: BusDevice) = DerivedSignal(
        "module speed share",
        "",
        motor.label,
        listOfNotNull(motor.topic(BusSignal.VELOCITY), motor.topic(BusSignal.CURRENT)) + modules.map { it.speed },
    ) { samples ->
        val at = driversOfModules(samples)?.indexOf(motor) ?: -1
        val motion = samples.motion()
        val shares = if (at < 0) {
            null
        } else {
            moduleSpeedShares(
                modules.map { motion.valuesOf(it.speed) },
                modules.map { scaled(motion.valuesOf(it.angle), it.radians) },
            )
        }
        once(motion.times, shares?.get(at))
    }

    private fun friction(motor: BusDevice) =
        derived("side friction", "", motor, BusSignal.CURRENT, BusSignal.VELOCITY, BusSignal.SUPPLY_CURRENT) { motion ->
            val drive = motion.drive.takeIf { it.size == 2 && motor in it }?.sortedBy { it !== motor }
            val currents = drive?.map { motion.valuesOf(it, BusSignal.CURRENT) }?.takeIf { it.all(::hasDirection) }
            val full = currents?.let(::fullCurrentOf)
            val sides = drive?.mapIndexed { at, side ->
                val output = if (currents != null && full != null) {
                    scaled(currents[at], 1 / full)
                } else {
                    motion.valuesOf(side, BusSignal.OUTPUT)
                }
                Side(output, motion.valuesOf(side, BusSignal.VELOCITY))
            }
            once(motion.times, sides?.let { (one, other) -> sideFriction(motion.times, one, other) })
        }

    private fun jam(motor: BusDevice) = DerivedSignal("stall", "", motor.label, JAMMED.mapNotNull(motor::topic)) { samples ->
        val motion = samples.motion()
        // What holds a place stands still under load.
        val holds = if (BusSignal.REFERENCE in motor) isPlace(motor, motion) else BusSignal.ABSOLUTE in motor
        if (holds || hasEnds(motor, motion) || !motion.isOfMechanism(motor)) {
            NOTHING
        } else {
            val (speed, current) = JAMMED.map { motion.valuesOf(motor, it) }
            val outputs = motor.topic(BusSignal.OUTPUT)?.let(motion::valuesOf)
            unlessHanging(stall(motion.times, speed, current, JAM_AMPERES, outputs), samples)
        }
    }

    /** Whether [device] hardly turns at more than half of full output and [BLOCKED_AMPERES]. */
    private fun blocked(device: BusDevice): DerivedSignal {
        val topics = SUPPLIED.mapNotNull(device::topic)
        return DerivedSignal("stall", "", device.label, topics) { samples ->
            val series = topics.map(samples::raw)
            val times = series[0].x
            val half = 0.5 * fullOf(series[1])
            val (speed, output, current) = series.map { it.heldAt(times) }
            val hard = DoubleArray(times.size) { if (abs(output[it]) > half) current[it] else 0.0 }
            unlessHanging(stall(times, speed, hard, BLOCKED_AMPERES, output), samples)
        }
    }

    /** Whether what [device] moved before stands still now, by its own encoder. */
    private fun standstill(device: BusDevice): DerivedSignal? {
        val place = device.topic(BusSignal.POSITION) ?: return null
        val output = device.topic(BusSignal.OUTPUT) ?: return null
        val topics = listOfNotNull(place, output, device.topic(BusSignal.CURRENT) ?: device.topic(BusSignal.SUPPLY_CURRENT))
        return DerivedSignal("standstill", "", device.label, topics) { samples -> standstillOf(topics, samples, ::fullOf) }
    }

    /** Returns whether a limit switch of [motor] was ever pressed. What travels between ends may stand at one of them under load. */
    private fun hasEnds(motor: BusDevice, motion: BusMotion): Boolean {
        fun reads(signal: BusSignal, pressed: Double) =
            motor.topic(signal)?.let { name -> motion.valuesOf(name).any { it == pressed } } == true
        return reads(BusSignal.PRESSED, 1.0) || reads(BusSignal.OPEN, 0.0)
    }

    private fun swing(motor: BusDevice) = derived("speed swing", "%", motor, BusSignal.VELOCITY, BusSignal.OUTPUT) { motion ->
        if (!motion.isOfMechanism(motor)) return@derived NOTHING
        val speed = motion.valuesOf(motor, BusSignal.VELOCITY)
        val held = heldSpeeds(motion.times, speed, motion.valuesOf(motor, BusSignal.OUTPUT))
        val swing = Following(motion.times, held, speed, motion.isEnabled).swing()
        // One that oscillates does so whenever it holds its speed.
        if (swing.y.count { it > SWING_PERCENT } * BusMotion.STEP_SECONDS < SWING_SECONDS) NOTHING else swing
    }

    private fun switch(motor: BusDevice): DerivedSignal? {
        val pressed = motor.topic(BusSignal.PRESSED)
        val topic = pressed ?: motor.topic(BusSignal.OPEN) ?: return null
        val position = motor.topic(BusSignal.POSITION) ?: return null
        return DerivedSignal("switch error", "%", motor.label, listOf(position, topic)) { samples ->
            val place = samples.raw(position)
            val switch = samples.raw(topic).heldAt(place.x)
            // A motor that is too weak to move may not have gone as far as it should.
            val wanted = motor.topic(BusSignal.REFERENCE)?.let { samples.raw(it).y } ?: place.y
            val range = maxOf(rangeOf(wanted), rangeOf(place.y))
            val isPressed = DoubleArray(switch.size) { if (pressed == null) 1 - switch[it] else switch[it] }
            switchError(place.x, place.y, longPressed(place.x, isPressed), range)
        }
    }

    private fun following(motor: BusDevice): List<DerivedSignal> {
        val reference = motor.topic(BusSignal.REFERENCE) ?: return emptyList()
        val error = motor.topic(BusSignal.ERROR) ?: return emptyList()
        fun following(samples: NamedSamples, ofPlaces: Boolean): Following {
            if (isPlace(motor, samples.motion()) != ofPlaces) return NOWHERE
            return samples.followings.getOrPut(reference) {
                val series = listOf(reference, error).map(samples::raw)
                val times = timesOf(series)
                val (wanted, missed) = series.map { it.heldAt(times) }
                Following(times, wanted, DoubleArray(times.size) { wanted[it] - missed[it] }, samples.enabledAt(times))
            }
        }
        val topics = listOfNotNull(error, reference) +
            listOf(BusSignal.CURRENT, BusSignal.OUTPUT, BusSignal.POSITION, BusSignal.VELOCITY).mapNotNull(motor::topic)
        val output = motor.topic(BusSignal.OUTPUT)
        val effort = DerivedSignal("output without effect", "", motor.label, topics) { samples ->
            effort(following(samples, ofPlaces = true).missedOrStill(), samples.raw(checkNotNull(output)), 1.0)
        }
        return placeSignals(motor.label, topics) { following(it, ofPlaces = true) } + listOfNotNull(effort.takeIf { output != null }) +
            speedSignals(motor.label, topics) { following(it, ofPlaces = false) }
    }

    /** Returns whether the controller of [motor] holds a place, not a speed: which of them follows its reference. */
    private fun isPlace(motor: BusDevice, motion: BusMotion): Boolean {
        val reference = motion.valuesOf(motor, BusSignal.REFERENCE)
        fun fit(signal: BusSignal) = motor.topic(signal)?.let { abs(correlation(motion.valuesOf(it), reference)) } ?: 0.0
        return fit(BusSignal.POSITION) >= fit(BusSignal.VELOCITY)
    }

    /** Whether an absolute encoder agrees with the motor that moves it. */
    private fun coupling(device: BusDevice): List<DerivedSignal> {
        val absolute = device.topic(BusSignal.ABSOLUTE) ?: return emptyList()
        val topics = listOfNotNull(absolute, device.topic(BusSignal.POSITION))
        fun derived(name: String, unit: String, calculated: (DoubleArray, DoubleArray, DoubleArray, BooleanArray) -> Series) =
            DerivedSignal(name, unit, device.label, topics) { samples ->
                val motion = samples.motion()
                val moved = motion.valuesOf(absolute)
                if (motion.isSteering(device)) return@DerivedSignal NOTHING
                val turned = (if (device.isMotor) listOf(device) else motors.filter(motion::isLeader))
                    .mapNotNull { motor -> motor.topic(BusSignal.POSITION)?.let(motion::valuesOf) }
                coupledMotor(motion.times, turned, moved, motion.isEnabled)?.let { calculated(motion.times, it, moved, motion.isEnabled) }
                    ?: NOTHING
            }
        return listOf(derived("coupling error", "%", ::couplingError), derived("encoder frozen", "", ::frozenWhileTurning))
    }

    private companion object {
        const val MIN_MOTORS = 4

        /** The correlation of total current and battery voltage below which the motors draw most of the battery's current. */
        const val EXPLAINED = -0.5
        const val SWING_PERCENT = 3.0
        const val SWING_SECONDS = 4.0
        const val JAM_AMPERES = 12.0
        val JAMMED = listOf(BusSignal.VELOCITY, BusSignal.CURRENT)
        val SUPPLIED = listOf(BusSignal.VELOCITY, BusSignal.OUTPUT, BusSignal.SUPPLY_CURRENT)
        const val BLOCKED_AMPERES = 20.0
        val NOTHING = Series(DoubleArray(0), DoubleArray(0))
        val NOWHERE = Following(DoubleArray(0), DoubleArray(0), DoubleArray(0), BooleanArray(0))
    }
}
