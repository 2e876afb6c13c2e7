package badlog.signals

import badlog.core.analysis.Series
import badlog.signals.derived.Following
import badlog.signals.derived.PartTopic
import badlog.signals.derived.Quantity
import badlog.signals.derived.areCoupled
import badlog.signals.derived.couplingError
import badlog.signals.derived.deadReading
import badlog.signals.derived.frictionRise
import badlog.signals.derived.frozenWhileTurning
import badlog.signals.derived.hasDirection
import badlog.signals.derived.heldAt
import badlog.signals.derived.stall
import badlog.signals.derived.steppedTimes
import badlog.signals.derived.switchError
import badlog.signals.derived.timesOf
import badlog.signals.swerve.cornerOf
import badlog.signals.vocabulary.TARGET_WORDS
import badlog.signals.vocabulary.wordsOf

/** Signals of mechanisms: how they follow their targets, whether they stall, and whether their sensors agree. */
internal class MechanismSignals(private val robot: RobotParts, private val battery: ((NamedSamples) -> Series)?) {
    private val byPart get() = robot.byPart

    val signals: List<DerivedSignal> get() = standingAlone(following() + byPart.values.flatMap(::ofPart))

    /** The pairs of a target and what follows it. */
    private fun following(): List<DerivedSignal> = robot.mechanisms.filter { it.isTarget && it.quantity in TARGETS }
        .sortedWith(compareBy({ isSet(it) }, { "goal" in it.signal.name.lowercase() }, { it.quantity == Quantity.NONE }))
        .mapNotNull { target -> robot.measuredOf(target)?.let { target to it } }
        .distinctBy { (_, measured) -> measured.signal.name }
        .flatMap { (target, measured) -> ofPair(target, measured) }

    /** Returns whether “set” alone says that [topic] is a target: it may be the output of a motor instead. */
    private fun isSet(topic: PartTopic) = topic.isTarget && wordsOf(topic.signal.name).filter { it in TARGET_WORDS } == listOf("set")

    private fun ofPair(target: PartTopic, measured: PartTopic): List<DerivedSignal> {
        val topics = (listOf(measured, target) + beside(target.part, Quantity.CURRENT, Quantity.OUTPUT)).map { it.signal.name }.distinct()
        val scale = scaleOf(measured, target) ?: 1.0
        fun following(samples: NamedSamples) =
            samples.followings.getOrPut(measured.signal.name) { followingOf(samples, target, measured, scale) }
        if (measured.quantity == Quantity.VELOCITY) return speedSignals(target.label, topics, ::following)
        val dead = DerivedSignal("encoder frozen", "", target.label, topics) { samples ->
            val own = samples.raw(measured.signal.name)
            val outputs = beside(target.part, Quantity.VOLTAGE, Quantity.OUTPUT).map { samples.raw(it.signal.name) }
            deadReading(own.x, own.y, samples.enabledAt(own.x), outputs)
        }
        val ownDead = dead.takeIf { couplingIn(byPart[target.part].orEmpty()) == null }
        // A part with the name of a corner mostly steers a wheel. Its motor counts turns, and may turn the wheel backward instead.
        if (cornerOf(target.part) != null) return listOfNotNull(ownDead)
        return placeSignals(target.label, topics, ::following) +
            listOfNotNull(
                ownDead,
                effortOf(target, topics, ::following),
                heldBackOf(target, measured, scale),
                heldByLimit(target, measured, scale),
                friction(target.part, measured),
            )
    }

    /**
     * The rise of a part's friction. It is measured by its motor's current if that has a direction, otherwise by the voltage that it gets.
     */
    private fun friction(part: List<String>, measured: PartTopic): DerivedSignal? {
        val current = beside(part, Quantity.CURRENT).firstOrNull()
        val output = beside(part, Quantity.VOLTAGE, Quantity.OUTPUT).sortedBy { it.quantity }.firstOrNull()
        val shown = listOf(measured) + listOfNotNull(current, output).ifEmpty { return null }
        return DerivedSignal("friction rise", "", measured.label, shown.map { it.signal.name }) { samples ->
            val amperes = current?.let { samples.raw(it.signal.name) }?.takeIf { hasDirection(it.y) }
            val effort = amperes ?: output?.let { samples.raw(it.signal.name) } ?: return@DerivedSignal once(DoubleArray(0), null)
            val place = samples.raw(measured.signal.name)
            val times = timesOf(listOf(place, effort))
            val own = effort.heldAt(times)
            if (amperes == null && output?.quantity == Quantity.OUTPUT) {
                battery?.invoke(samples)?.heldAt(times)?.let { volts -> for (i in own.indices) own[i] *= volts[i] }
            }
            once(times, frictionRise(times, place.heldAt(times), own, samples.enabledAt(times)))
        }
    }

    /** The output of a part while it stays away from its target. */
    private fun effortOf(target: PartTopic, topics: List<String>, following: (NamedSamples) -> Following): DerivedSignal? {
        val output = beside(target.part, Quantity.OUTPUT, Quantity.VOLTAGE).firstOrNull() ?: return null
        return DerivedSignal("output without effect", "", target.label, topics.take(2) + output.signal.name) { samples ->
            val driven = samples.raw(output.signal.name)
            effort(following(samples).missedOrStill(), driven, fullOf(output, driven))
        }
    }

    /** Whether a part is driven hard toward its target and does not move. */
    private fun heldBackOf(target: PartTopic, measured: PartTopic, scale: Double): DerivedSignal? {
        if (isClimber(target)) return null
        val current = beside(target.part, Quantity.CURRENT, Quantity.SUPPLY_CURRENT).firstOrNull() ?: return null
        return DerivedSignal("stall", "", target.label, listOf(measured, target, current).map { it.signal.name }) { samples ->
            val drive = samples.raw(current.signal.name)
            val times = steppedTimes(listOf(measured, target).map { samples.raw(it.signal.name) } + drive, STEP_SECONDS)
            val away = followingOf(samples, target, measured, scale, times).standingAway()
            unlessHanging(heldBack(away, drive, BLOCKED_AMPERES), samples)
        }
    }

    private fun isClimber(topic: PartTopic) = topic.part.any { word -> CLIMBING.any(word::startsWith) }

    /**
     * How far a part stands from its target while the limit that is in its way is reached, in percent of its range. A limit that is reached
     * where the part is farthest from it is none, or is wired the other way. A part rests at its lower end, where a switch closes a little
     * early. A climber pulls itself against its limit.
     */
    private fun heldByLimit(target: PartTopic, measured: PartTopic, scale: Double): DerivedSignal? {
        if (isClimber(target)) return null
        val limits = byPart[target.part].orEmpty().filter { it.quantity == Quantity.SWITCH }
            .mapNotNull { limit -> wayOf(limit)?.let { way -> limit.signal.name to way } }.ifEmpty { return null }
        val topics = listOf(measured, target).map { it.signal.name } + limits.map { it.first }
        return DerivedSignal("held by limit", "%", target.label, topics) { samples ->
            val times = steppedTimes(topics.map(samples::raw), STEP_SECONDS)
            val away = followingOf(samples, target, measured, scale, times).missed()
            val wanted = samples.raw(target.signal.name).heldAt(times)
            val place = samples.raw(measured.signal.name).heldAt(times)
            val held = DoubleArray(away.size)
            for ((name, way) in limits) {
                val state = samples.raw(name).heldAt(times)
                val known = place.indices.filter { place[it].isFinite() && state[it].isFinite() }
                val farthest = known.minByOrNull { scale * place[it] * way } ?: continue
                if (state[farthest] != 0.0) continue
                val least = if (way > 0) 0.0 else EARLY_PERCENT
                for (i in held.indices) {
                    if (state[i] == 1.0 && (wanted[i] - scale * place[i]) * way > 0 && away.y[i] > least) held[i] = away.y[i]
                }
            }
            Series(away.x, held)
        }
    }

    /** Returns 1 for a limit at the upper end of its mechanism, -1 for one at the lower end; null if its name does not say. */
    private fun wayOf(limit: PartTopic): Double? {
        // “Upper Arm” is a part.
        val words = wordsOf(limit.signal.name.substringAfterLast('/'))
        val isUpper = words.any { it in FORWARD }
        val isLower = words.any { it in BACKWARD }
        return if (isUpper == isLower) {
            null
        } else if (isUpper) {
            1.0
        } else {
            -1.0
        }
    }

    private fun followingOf(
        samples: NamedSamples,
        target: PartTopic,
        measured: PartTopic,
        scale: Double,
        times: DoubleArray = steppedTimes(listOf(measured, target).map { samples.raw(it.signal.name) }, STEP_SECONDS),
    ): Following {
        val wanted = samples.raw(target.signal.name)
        val values = samples.raw(measured.signal.name).heldAt(times)
        for (i in values.indices) values[i] *= scale
        return Following(times, wanted.heldAt(times), values, samples.enabledAt(times))
    }

    private fun beside(part: List<String>, vararg quantities: Quantity) =
        byPart[part].orEmpty().filter { it.quantity in quantities && !it.isTarget }

    private fun ofPart(part: List<PartTopic>): List<DerivedSignal> =
        listOfNotNull(stall(part), standstill(part), switch(part)) + coupling(part)

    /** Whether a part that its motor moved before stands still now. */
    private fun standstill(part: List<PartTopic>): DerivedSignal? {
        if (isOfDrive(part)) return null
        val place = part.filter { it.quantity == Quantity.POSITION && !it.isTarget }.minByOrNull { it.isMotor } ?: return null
        val output = part.filter { (it.quantity == Quantity.OUTPUT || it.quantity == Quantity.VOLTAGE) && !it.isTarget }
            .minByOrNull { it.quantity == Quantity.VOLTAGE } ?: return null
        val current = part.find { it.quantity == Quantity.CURRENT || it.quantity == Quantity.SUPPLY_CURRENT }
        val topics = listOfNotNull(place, output, current).map { it.signal.name }
        return DerivedSignal("standstill", "", place.label, topics) { samples ->
            standstillOf(topics, samples) { fullOf(output, it) }
        }
    }

    /** Returns whether [part] is named as wheels of the drive are: a robot that pushes is not blocked. */
    private fun isOfDrive(part: List<PartTopic>) = part[0].part.all { it in WHEELS }

    private fun stall(part: List<PartTopic>): DerivedSignal? {
        if (part.any { it.isTarget && !isSet(it) && (it.quantity == Quantity.POSITION || it.quantity == Quantity.NONE) }) return null
        if (isOfDrive(part) || part.any { topic -> topic.part.any { word -> word in ARMS || HOLDING.any(word::startsWith) } }) return null
        val speed = part.find { it.quantity == Quantity.VELOCITY && !it.isTarget } ?: return null

        // Without a current, a motor without power looks like a blocked one.
        fun first(vararg quantities: Quantity) =
            quantities.firstNotNullOfOrNull { quantity -> part.find { it.quantity == quantity && !it.isTarget } }?.signal?.name
        val drive = first(Quantity.CURRENT, Quantity.SUPPLY_CURRENT) ?: return null
        val output = first(Quantity.OUTPUT, Quantity.VOLTAGE)
        return DerivedSignal("stall", "", speed.label, listOf(speed.signal.name, drive)) { samples ->
            val both = listOf(samples.raw(speed.signal.name), samples.raw(drive))
            val times = timesOf(both)
            val outputs = output?.let { samples.raw(it).heldAt(times) }
            stall(times, both[0].heldAt(times), both[1].heldAt(times), STALLED_AMPERES, outputs)
        }
    }

    private fun switch(part: List<PartTopic>): DerivedSignal? {
        val switch = part.find { it.quantity == Quantity.SWITCH } ?: return null
        val position = part.filter { it.isTarget }.firstNotNullOfOrNull(robot::measuredOf)?.takeIf { it.quantity == Quantity.POSITION }
            ?: part.filter { it.quantity == Quantity.POSITION && !it.isTarget }.minByOrNull { it.isMotor } ?: return null
        return DerivedSignal("switch error", "%", position.label, listOf(position, switch).map { it.signal.name }) { samples ->
            val both = listOf(samples.raw(position.signal.name), samples.raw(switch.signal.name))
            val times = timesOf(both)
            switchError(times, both[0].heldAt(times), both[1].heldAt(times))
        }
    }

    /** Returns the positions from a mechanism's own sensor and from its motor's; null without both. */
    private fun couplingIn(part: List<PartTopic>): Pair<PartTopic, PartTopic>? {
        val places = part.filter { it.quantity == Quantity.POSITION && !it.isTarget }
        if (places.size != 2) return null
        val moved = places.find { it.isAbsolute } ?: places.find { !it.isMotor && places.any { other -> other.isMotor } } ?: return null
        return moved to places.first { it !== moved }
    }

    private fun coupling(part: List<PartTopic>): List<DerivedSignal> {
        val (moved, turned) = couplingIn(part) ?: return emptyList()
        fun derived(name: String, unit: String, calculated: (DoubleArray, DoubleArray, DoubleArray, BooleanArray) -> Series) =
            DerivedSignal(name, unit, moved.label, listOf(moved, turned).map { it.signal.name }) { samples ->
                val both = listOf(samples.raw(turned.signal.name), samples.raw(moved.signal.name))
                val times = timesOf(both)
                calculated(times, both[0].heldAt(times), both[1].heldAt(times), samples.enabledAt(times))
            }
        return listOf(derived("coupling error", "%", ::couplingError), derived("encoder frozen", "", ::frozenIfCoupled))
    }

    /** An encoder that was never read, or that measures something else, is not one that stopped. */
    private fun frozenIfCoupled(times: DoubleArray, turned: DoubleArray, moved: DoubleArray, isEnabled: BooleanArray) =
        if (areCoupled(turned, moved, isEnabled)) frozenWhileTurning(times, turned, moved, isEnabled) else once(times, null)

    /** Returns the value of full output in [samples] of [topic]: 12 V for a voltage. */
    private fun fullOf(topic: PartTopic, samples: Series) = if (topic.quantity == Quantity.VOLTAGE) 12.0 else fullOf(samples)

    private companion object {
        val ARMS = setOf("arm", "arms")

        /** Mechanisms that stand still under power. They hold something up, shut or against a stop, or game pieces that wait. */
        val HOLDING = listOf(
            "elevator", "lift", "pivot", "wrist", "elbow", "shoulder", "climb", "hang", "winch", "telescop", "exten", "hood",
            "turret", "tilt", "claw", "grip", "grab", "deploy", "passover", "latch", "brake",
            "algae", "effector", "feed", "index", "hopper", "magazine", "conveyor", "kicker", "queue",
        )

        val WHEELS = setOf(
            "front", "back", "rear", "left", "right", "fl", "fr", "bl", "br", "rl", "rr", "modules", "wheel", "wheels",
            "leader", "follower", "master", "slave",
        )

        val FORWARD = setOf("forward", "fwd", "upper", "top")
        val BACKWARD = setOf("reverse", "rev", "lower", "bottom")

        /** The whole robot may hang on these. */
        val CLIMBING = listOf("climb", "hang", "winch")

        const val EARLY_PERCENT = 12.0

        /** More than holds something up that is not loaded. */
        const val BLOCKED_AMPERES = 20.0
        const val STEP_SECONDS = 0.05
        const val STALLED_AMPERES = 12.0
        val TARGETS = setOf(Quantity.POSITION, Quantity.VELOCITY, Quantity.NONE)
    }
}
