package badlog.signals

import badlog.core.analysis.Series
import badlog.signals.derived.Following
import badlog.signals.derived.PartTopic
import badlog.signals.derived.Quantity
import badlog.signals.derived.Side
import badlog.signals.derived.SwerveModule
import badlog.signals.derived.airGain
import badlog.signals.derived.airLoss
import badlog.signals.derived.channelChanges
import badlog.signals.derived.couplingError
import badlog.signals.derived.currentShares
import badlog.signals.derived.deadReading
import badlog.signals.derived.frozenWhileTurning
import badlog.signals.derived.headingJump
import badlog.signals.derived.heldAt
import badlog.signals.derived.moduleAngleError
import badlog.signals.derived.moduleSpeedShares
import badlog.signals.derived.partTopicsOf
import badlog.signals.derived.quantile
import badlog.signals.derived.sideFriction
import badlog.signals.derived.sightError
import badlog.signals.derived.stall
import badlog.signals.derived.swerveModulesOf
import badlog.signals.derived.switchError
import badlog.signals.derived.timesOf
import badlog.signals.derived.unexplainedDrop
import badlog.signals.derived.wheelSlip
import badlog.signals.pose.SeenPath
import badlog.signals.vocabulary.SignalTopics
import badlog.signals.vocabulary.SignalVocabulary
import badlog.signals.vocabulary.unitScale
import badlog.signals.vocabulary.wordsOf
import kotlin.math.PI
import kotlin.math.abs
import kotlin.math.cos
import kotlin.math.sin

/** The names of all [DerivedSignal]s; true for those that a log has at most once. */
val DERIVED_NAMES: Map<String, Boolean> = mapOf(
    "voltage lost" to true, "setpoint error" to false, "speed shortfall" to false, "overshoot" to false, "speed swing" to false,
    "module angle error" to false, "module speed share" to false, "coupling error" to false, "encoder frozen" to false,
    "heading jump" to false, "sight error" to true, "air loss" to true, "air gain" to true, "stall" to false, "side friction" to false,
    "switch error" to false, "wheel slip" to true, "output without effect" to false, "module current share" to false,
    "channel change" to false,
)

/** Returns the signals that can be calculated in logs of the shape [shape], where [found] are the signals of [vocabulary]. */
fun derivedSignalsOf(shape: LogShape, vocabulary: SignalVocabulary, found: SignalTopics): List<DerivedSignal> =
    DerivedSearch(shape, vocabulary, found).signals

private class DerivedSearch(shape: LogShape, vocabulary: SignalVocabulary, private val found: SignalTopics) {
    private val names = shape.vocabulary.signals.filter { it.name != shape.timeTopic && it.name !in shape.empty }
    private val parts = partTopicsOf(names, vocabulary)
    private val mechanisms = parts.filter { part -> part.part.none { it in DRIVE_WORDS } }
    private val byPart = mechanisms.groupBy { it.part }
    private val modules = swerveModulesOf(names, parts)

    val signals: List<DerivedSignal> = listOfNotNull(voltageLost(), wheelSlip(), airLoss(), airGain(), shape.sight?.let(::sight)) +
        following() + ofModules() + channels() + byPart.values.flatMap(::ofPart) + headings() + sides()

    private fun named(signal: String): NamedSignal? {
        val topics = found.of(signal).ifEmpty { found.summandsOf(signal) }
        return if (topics.isEmpty()) null else NamedSignal.of(signal, topics)
    }

    private fun voltageLost(): DerivedSignal? {
        val battery = named("battery") ?: return null
        val current = named("total current") ?: return null
        val topics = battery.topics + current.topics.take(SHOWN)
        return DerivedSignal("voltage lost", "V", "", topics) { unexplainedDrop(it.of(battery), it.of(current)) }
    }

    private fun airLoss(): DerivedSignal? = ofAir("air loss", "psi/s", ::airLoss)

    private fun airGain(): DerivedSignal? = ofAir("air gain", "psi", ::airGain)

    private fun ofAir(name: String, unit: String, calculated: (Series, Series) -> Series): DerivedSignal? {
        val pressure = named("air pressure") ?: return null
        val compressor = named("compressor") ?: return null
        return DerivedSignal(name, unit, "", pressure.topics + compressor.topics) { calculated(it.of(pressure), it.of(compressor)) }
    }

    private fun sight(path: SeenPath) = DerivedSignal("sight error", "m", "", path.topics) {
        fun places(x: String, y: String) = it.raw(x) to it.raw(y)
        sightError(places(path.seen.x, path.seen.y), places(path.driven.x, path.driven.y))
    }

    /** The pairs of a target and what follows it. */
    private fun following(): List<DerivedSignal> = mechanisms.filter { it.isTarget && it.quantity in TARGETS }
        .sortedBy { "goal" in it.signal.name.lowercase() }
        .mapNotNull { target -> measuredOf(target)?.let { target to it } }
        .distinctBy { (_, measured) -> measured.signal.name }
        .flatMap { (target, measured) -> ofPair(target, measured) }

    private fun measuredOf(target: PartTopic): PartTopic? = byPart[target.part].orEmpty()
        .filter { !it.isTarget && (it.quantity == Quantity.POSITION || it.quantity == Quantity.VELOCITY) && scaleOf(it, target) != null }
        .filter { target.quantity == Quantity.NONE || it.quantity == target.quantity }
        .maxByOrNull { (if (it.unit == target.unit) 4 else 0) + (if (it.isAbsolute) 2 else 0) + (if (it.isMotor) 0 else 1) }

    private fun scaleOf(from: PartTopic, to: PartTopic): Double? =
        if (from.unit.isEmpty() || to.unit.isEmpty()) 1.0 else unitScale(from.unit, to.unit)

    private fun ofPair(target: PartTopic, measured: PartTopic): List<DerivedSignal> {
        val topics = (listOf(measured, target) + beside(target.part, Quantity.CURRENT, Quantity.OUTPUT)).map { it.signal.name }.distinct()
        val scale = scaleOf(measured, target) ?: 1.0
        fun derived(name: String, calculated: Following.() -> Series) = DerivedSignal(name, "%", target.label, topics) { samples ->
            samples.followings.getOrPut(measured.signal.name) { followingOf(samples, target, measured, scale) }.calculated()
        }
        return if (measured.quantity == Quantity.POSITION) {
            val dead = DerivedSignal("encoder frozen", "", target.label, topics) { samples ->
                val own = samples.raw(measured.signal.name)
                deadReading(own.x, own.y, samples.enabledAt(own.x))
            }
            listOfNotNull(
                derived("setpoint error") { missed() },
                derived("overshoot") { overshoot() },
                dead.takeIf { couplingIn(byPart[target.part].orEmpty()) == null },
                effortOf(target, measured, scale),
            )
        } else {
            listOf(derived("speed shortfall") { shortfall() }, derived("speed swing") { swing() })
        }
    }

    private fun channels(): List<DerivedSignal> {
        val topics = found.of("channel current").map { it.topic }
        if (modules.size != 4 || topics.size < 4) return emptyList()
        return topics.mapIndexed { at, topic ->
            DerivedSignal("channel change", "", topic, listOf(topic)) { samples ->
                val changes = samples.channelChanges.getOrPut("") {
                    val series = topics.map(samples::raw)
                    val times = timesOf(series)
                    channelChanges(times, series.map { it.heldAt(times) }, samples.enabledAt(times)).orEmpty()
                }
                once(samples.raw(topic).x, changes.getOrNull(at))
            }
        }
    }

    /** The output of a part while it stays away from its target. */
    private fun effortOf(target: PartTopic, measured: PartTopic, scale: Double): DerivedSignal? {
        val output = beside(target.part, Quantity.OUTPUT, Quantity.VOLTAGE).firstOrNull() ?: return null
        val topics = listOf(measured, target, output).map { it.signal.name }
        return DerivedSignal("output without effect", "", target.label, topics) { samples ->
            val missed = samples.followings.getOrPut(measured.signal.name) { followingOf(samples, target, measured, scale) }.missed()
            val driven = samples.raw(output.signal.name)
            val full = if (output.quantity == Quantity.VOLTAGE) 12.0 else fullOf(driven)
            val held = driven.heldAt(missed.x)
            Series(missed.x, DoubleArray(missed.size) { if (missed.y[it] > AWAY_PERCENT) abs(held[it]) / full else 0.0 })
        }
    }

    private fun followingOf(samples: NamedSamples, target: PartTopic, measured: PartTopic, scale: Double): Following {
        val own = samples.raw(measured.signal.name)
        val wanted = samples.raw(target.signal.name)
        val times = timesOf(listOf(own, wanted))
        val values = own.heldAt(times)
        for (i in values.indices) values[i] *= scale
        return Following(times, wanted.heldAt(times), values, samples.enabledAt(times))
    }

    private fun beside(part: List<String>, vararg quantities: Quantity) =
        byPart[part].orEmpty().filter { it.quantity in quantities && !it.isTarget }

    private fun ofModules(): List<DerivedSignal> = modules.indices.flatMap { at ->
        listOfNotNull(angleError(at).takeIf { modules.all { module -> module.targetAngle != null } }, speedShare(at), currentShare(at))
    }

    /** The topics of the drive motor of a module besides those of [SwerveModule]. */
    private fun driveTopicsOf(module: SwerveModule, vararg quantities: Quantity): List<PartTopic> {
        val words = wordsOf(module.label)
        return parts.filter { part ->
            part.quantity in quantities && !part.isTarget && part.part.containsAll(words) && part.part.none { it in STEER_WORDS }
        }
    }

    private fun currentShare(at: Int): DerivedSignal? {
        val currents = modules.map { driveTopicsOf(it, Quantity.CURRENT).firstOrNull()?.signal?.name ?: return null }
        val topics = listOf(currents[at]) + modules[at].topics.reversed()
        return DerivedSignal("module current share", "", modules[at].label, topics) { samples ->
            val series = currents.map(samples::raw)
            val times = timesOf(series)
            once(times, currentShares(times, series.map { it.heldAt(times) }, samples.enabledAt(times))?.get(at))
        }
    }

    private fun angleError(at: Int) = DerivedSignal("module angle error", "deg", modules[at].label, modules[at].topics) { samples ->
        val angles = modules.map { samples.raw(it.angle) }
        val targets = modules.map { samples.raw(checkNotNull(it.targetAngle)) }
        val times = timesOf(angles)
        fun radians(series: List<Series>) = series.mapIndexed { k, one -> scaled(one.heldAt(times), modules[k].radians) }
        val speeds = modules.map { samples.raw(it.targetSpeed ?: it.speed).heldAt(times) }
        moduleAngleError(at, times, radians(angles), radians(targets), speeds, samples.enabledAt(times))
    }

    private fun speedShare(at: Int) = DerivedSignal(
        "module speed share",
        "",
        modules[at].label,
        (modules[at].topics.reversed() + driveTopicsOf(modules[at], Quantity.VELOCITY, Quantity.CURRENT).map { it.signal.name }).distinct(),
    ) { samples ->
        val speeds = modules.map { samples.raw(it.speed) }
        val times = timesOf(speeds)
        val shares = moduleSpeedShares(
            speeds.map { it.heldAt(times) },
            modules.map { module: SwerveModule -> scaled(samples.raw(module.angle).heldAt(times), module.radians) },
        )
        once(times, shares?.get(at))
    }

    private fun ofPart(part: List<PartTopic>): List<DerivedSignal> = listOfNotNull(stall(part), switch(part)) + coupling(part)

    private fun stall(part: List<PartTopic>): DerivedSignal? {
        // A motor that is known by its id alone may drive the robot, and a robot that pushes another is not jammed.
        if (part[0].part.all { word -> word in DEVICE_WORDS || word.all { it in '0'..'9' } }) return null
        if (part.any { it.isTarget && (it.quantity == Quantity.POSITION || it.quantity == Quantity.NONE) }) return null
        val speed = part.find { it.quantity == Quantity.VELOCITY && !it.isTarget } ?: return null
        val drive = listOf(Quantity.CURRENT, Quantity.OUTPUT, Quantity.VOLTAGE).firstNotNullOfOrNull { quantity ->
            part.find { it.quantity == quantity && !it.isTarget }
        } ?: return null
        return DerivedSignal("stall", "", speed.label, listOf(speed.signal.name, drive.signal.name)) { samples ->
            val both = listOf(samples.raw(speed.signal.name), samples.raw(drive.signal.name))
            val times = timesOf(both)
            val drives = both[1].heldAt(times)
            stall(times, both[0].heldAt(times), drives, leastDrive(drive, drives))
        }
    }

    private fun leastDrive(drive: PartTopic, values: DoubleArray): Double = when (drive.quantity) {
        Quantity.CURRENT -> 12.0
        Quantity.VOLTAGE -> 3.0
        else -> if (values.any { it > 2 || it < -2 }) 25.0 else 0.25
    }

    private fun switch(part: List<PartTopic>): DerivedSignal? {
        val switch = part.find { it.quantity == Quantity.SWITCH } ?: return null
        val position = part.filter { it.isTarget }.firstNotNullOfOrNull(::measuredOf)?.takeIf { it.quantity == Quantity.POSITION }
            ?: part.filter { it.quantity == Quantity.POSITION && !it.isTarget }.minByOrNull { it.isMotor } ?: return null
        return DerivedSignal("switch error", "%", position.label, listOf(position, switch).map { it.signal.name }) { samples ->
            val both = listOf(samples.raw(position.signal.name), samples.raw(switch.signal.name))
            val times = timesOf(both)
            switchError(times, both[0].heldAt(times), both[1].heldAt(times))
        }
    }

    /** Returns what a mechanism's own sensor says and what its motor's does; null without both. */
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
        return listOf(derived("coupling error", "%", ::couplingError), derived("encoder frozen", "", ::frozenWhileTurning))
    }

    private fun headings(): List<DerivedSignal> = found.of("gyro angle").map { topic ->
        val heading = NamedSignal.of("gyro angle", listOf(topic))
        DerivedSignal("heading jump", "deg", topic.device, heading.topics) { headingJump(it.of(heading), 1.0) }
    }

    private fun sides(): List<DerivedSignal> {
        val drive = parts.filter { part -> part.part.any { it in DRIVE_WORDS } && part.part.count { it in CORNERS } == 1 && !part.isTarget }
        fun of(side: String, vararg quantities: Quantity) = quantities.firstNotNullOfOrNull { quantity ->
            drive.find { side in it.part && it.quantity == quantity }
        }
        val speeds = listOf("left", "right").map { of(it, Quantity.VELOCITY) ?: return emptyList() }
        val outputs = listOf("left", "right").map { of(it, Quantity.CURRENT, Quantity.VOLTAGE, Quantity.OUTPUT) ?: return emptyList() }
        return listOf(0, 1).map { at ->
            val topics = listOf(outputs[at], speeds[at], outputs[1 - at], speeds[1 - at]).map { it.signal.name }
            val side = listOf("left", "right")[at]
            val shown = topics + drive.filter { side in it.part && it.quantity == Quantity.CURRENT }.map { it.signal.name }
            DerivedSignal("side friction", "", speeds[at].label, shown) { samples ->
                val all = topics.map(samples::raw)
                val times = timesOf(all)
                val full = when (outputs[at].quantity) {
                    // At its limit, a current takes about a quarter of the output.
                    Quantity.CURRENT -> 4 * maxOf(amperesOf(all[0]), amperesOf(all[2]))

                    Quantity.VOLTAGE -> 12.0

                    else -> fullOf(all[0])
                }
                fun side(output: Int) = Side(scaled(all[output].heldAt(times), 1 / full), all[output + 1].heldAt(times))
                once(times, sideFriction(times, side(0), side(2)))
            }
        }
    }

    /** The current that a motor gets at most, but for moments. */
    private fun amperesOf(current: Series) = quantile(DoubleArray(current.size) { abs(current.y[it]) }, 0.99).coerceAtLeast(1.0)

    private fun fullOf(output: Series) = if (output.y.any { it > 2 || it < -2 }) 100.0 else 1.0

    private fun wheelSlip(): DerivedSignal? {
        val measured = named("acceleration") ?: return null
        val isTank = modules.isEmpty()
        val sides = parts.filter { part ->
            part.part.any { it in DRIVE_WORDS } && part.part.count { it in CORNERS } == 1 && part.quantity == Quantity.VELOCITY &&
                !part.isTarget
        }
        if (isTank && sides.size != 2) return null
        if (isTank && sides.any { it.unit != "m/s" && it.unit.isNotEmpty() }) return null
        val heading = found.of("gyro angle").firstOrNull()?.let { NamedSignal.of("gyro angle", listOf(it)) }
        val topics = if (isTank) sides.map { it.signal.name } else modules.map { it.speed }
        return DerivedSignal("wheel slip", "m/s²", "", topics + measured.topics) { samples ->
            val speeds = topics.map(samples::raw)
            val times = timesOf(speeds)
            val forward = DoubleArray(times.size)
            val left = DoubleArray(times.size)
            for ((k, speed) in speeds.withIndex()) {
                val own = speed.heldAt(times)
                val angle = if (isTank) null else scaled(samples.raw(modules[k].angle).heldAt(times), modules[k].radians)
                for (i in times.indices) {
                    forward[i] += own[i] * (angle?.let { cos(it[i]) } ?: 1.0) / speeds.size
                    left[i] += own[i] * (angle?.let { sin(it[i]) } ?: 0.0) / speeds.size
                }
            }
            val turned = heading?.let { scaled(samples.of(it).heldAt(times), PI / 180) } ?: DoubleArray(times.size)
            wheelSlip(times, forward, left, turned, samples.of(measured).heldAt(times))
        }
    }

    private fun scaled(values: DoubleArray, scale: Double) = DoubleArray(values.size) { values[it] * scale }

    /** A figure of the whole log, as a sample at its start. */
    private fun once(times: DoubleArray, value: Double?) = if (value == null || times.isEmpty()) {
        Series(DoubleArray(0), DoubleArray(0))
    } else {
        Series(doubleArrayOf(times[0]), doubleArrayOf(value))
    }

    private companion object {
        const val SHOWN = 4
        val TARGETS = setOf(Quantity.POSITION, Quantity.VELOCITY, Quantity.NONE)
        val DRIVE_WORDS = setOf("drive", "drivetrain", "drivebase", "module", "swerve", "chassis", "drive0")
        val STEER_WORDS = setOf("turn", "steer", "steering", "azimuth", "angle")

        /** In percent of the range. */
        const val AWAY_PERCENT = 12.0
        val DEVICE_WORDS = setOf("phoenix", "talon", "fx", "srx", "victor", "spx", "spark", "max", "flex", "rev", "ctre", "can", "id")
        val CORNERS = setOf("front", "back", "rear", "left", "right")
    }
}
