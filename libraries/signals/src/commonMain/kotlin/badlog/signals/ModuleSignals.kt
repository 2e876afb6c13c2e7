package badlog.signals

import badlog.core.analysis.Series
import badlog.signals.derived.PartTopic
import badlog.signals.derived.Quantity
import badlog.signals.derived.currentShares
import badlog.signals.derived.heldAt
import badlog.signals.derived.isSeldom
import badlog.signals.derived.moduleAngleError
import badlog.signals.derived.moduleAngleLags
import badlog.signals.derived.moduleSpeedShares
import badlog.signals.derived.scaled
import badlog.signals.derived.timesOf
import badlog.signals.swerve.ModuleTopics
import badlog.signals.swerve.STEER_WORDS
import badlog.signals.swerve.cornerOf
import badlog.signals.swerve.labelOfCorner
import badlog.signals.swerve.withoutCorner
import badlog.signals.vocabulary.wordsOf

/** Signals of the modules of a swerve drive. */
internal class ModuleSignals(private val robot: RobotParts, private val bus: BusSignals) {
    private val modules = robot.modules

    val signals: List<DerivedSignal> get() = modules.indices.flatMap { at ->
        val angles = if (modules.all { it.targetAngle != null }) listOf(angleLag(at), angleError(at)) else emptyList()
        angles + speedShare(at)
    } + wheels.indices.map(::currentShare)

    /** A wheel with a drive motor that logs its current; [topics] show it, the current first. */
    private class Wheel(val label: String, val topics: List<String>)

    /** The four wheels of the modules; a log that numbers its modules may name their motors by corners. */
    private val wheels: List<Wheel> =
        modules.mapNotNull(::wheelOf).takeIf { it.isNotEmpty() && it.size == modules.size } ?: wheelsByCorner()

    private fun wheelOf(module: ModuleTopics): Wheel? {
        val current = driveTopicsOf(module, Quantity.CURRENT).firstOrNull()?.signal?.name ?: return null
        return Wheel(module.label, listOf(current) + module.topics.reversed())
    }

    private fun wheelsByCorner(): List<Wheel> {
        val currents = robot.topics.filter { topic ->
            topic.quantity == Quantity.CURRENT && !topic.isTarget && isOfWheel(topic, DRIVE_WORDS)
        }
        for (alike in currents.groupBy { withoutCorner(it.part) }.values) {
            val byCorner = alike.mapNotNull { topic -> cornerOf(topic.part)?.let { it to topic } }.toMap()
            if (byCorner.size == CORNERS) {
                return byCorner.map { (corner, topic) -> Wheel(labelOfCorner(corner), listOf(topic.signal.name)) }
            }
        }
        return emptyList()
    }

    /** Returns whether [topic] is named by [words] and a corner alone, and not of a steering motor. A shooter may have corners, too. */
    private fun isOfWheel(topic: PartTopic, words: Set<String>): Boolean {
        // A single letter is a unit.
        val own = withoutCorner(topic.part).filter { it.length > 1 }
        return words.containsAll(own) && !isSteering(topic)
    }

    /** Returns whether [topic] is of a steering motor. “Angle” and “rotation” are quantities, too, which its part lacks. */
    private fun isSteering(topic: PartTopic): Boolean {
        val words = wordsOf(topic.signal.name)
        return words.any { it in STEER_WORDS || it == "rotation" } || topic.part.any { it in MORE_STEER_WORDS }
    }

    /** The targets and the measurements of a drive's modules. */
    private class Steering(
        val times: DoubleArray,
        val angles: List<DoubleArray>,
        val targets: List<DoubleArray>,
        val speeds: List<DoubleArray>,
        val isEnabled: BooleanArray,
    ) {
        /** The lag of each module, if it can be measured: rarely logged angles lag anyway. */
        val lags: List<Double?>? by lazy {
            val least = if (isSeldom(times, angles)) SELDOM_BEHIND else 0.0
            moduleAngleLags(times, angles, targets, speeds, isEnabled)?.map { lag -> lag?.takeIf { it > least } }
        }
    }

    /** The topics of a module's drive motor that [ModuleTopics] lacks. */
    private fun driveTopicsOf(module: ModuleTopics, vararg quantities: Quantity): List<PartTopic> {
        val words = wordsOf(module.label)
        val corner = cornerOf(words)
        val ofDrive = DRIVE_WORDS + wordsOf(module.speed) + wordsOf(module.angle)
        return robot.topics.filter { part ->
            val isOfModule = if (corner == null) {
                part.part.containsAll(words) && !isSteering(part)
            } else {
                cornerOf(part.part) == corner && isOfWheel(part, ofDrive)
            }
            part.quantity in quantities && !part.isTarget && isOfModule
        }
    }

    private fun currentShare(at: Int) = DerivedSignal("module current share", "", wheels[at].label, wheels[at].topics) { samples ->
        once(samples.raw(wheels[0].topics[0]).x, sharesIn(samples)?.get(at))
    }

    /** Returns the current of each wheel's motor as a share of the others'; null if they are not known. */
    fun sharesIn(samples: NamedSamples): List<Double?>? {
        val series = wheels.ifEmpty { return null }.map { samples.raw(it.topics[0]) }
        val times = timesOf(series)
        return currentShares(times, series.map { it.heldAt(times) }, samples.enabledAt(times))
    }

    private fun steering(samples: NamedSamples): Steering {
        val angles = modules.map { samples.raw(it.angle) }
        val targets = modules.map { samples.raw(checkNotNull(it.targetAngle)) }
        val times = timesOf(angles)
        fun radians(series: List<Series>) = series.mapIndexed { k, one -> scaled(one.heldAt(times), modules[k].radians) }
        val speeds = modules.map { samples.raw(it.targetSpeed ?: it.speed).heldAt(times) }
        return Steering(times, radians(angles), radians(targets), speeds, samples.enabledAt(times))
    }

    private fun angleLag(at: Int) = DerivedSignal("module angle lag", "", modules[at].label, modules[at].topics) { samples ->
        steering(samples).run { once(times, lags?.get(at)) }
    }

    /** Nothing for a module that is not behind the others in all. A moment in which it seems to be then comes from late measurements. */
    private fun angleError(at: Int) = DerivedSignal("module angle error", "deg", modules[at].label, modules[at].topics) { samples ->
        val drive = steering(samples)
        val lag = drive.lags?.get(at)
        if (lag != null && lag > BEHIND) {
            drive.run { moduleAngleError(at, times, angles, targets, speeds, isEnabled) }
        } else {
            once(drive.times, null)
        }
    }

    private fun speedShare(at: Int) = DerivedSignal(
        "module speed share",
        "",
        modules[at].label,
        (modules[at].topics.reversed() + driveTopicsOf(modules[at], Quantity.VELOCITY, Quantity.CURRENT).map { it.signal.name }).distinct(),
    ) { samples ->
        // Known drive motors are named instead.
        if (bus.driversOfModules(samples) != null) return@DerivedSignal once(DoubleArray(0), null)
        val speeds = modules.map { samples.raw(it.speed) }
        val times = timesOf(speeds)
        val shares = moduleSpeedShares(
            speeds.map { it.heldAt(times) },
            modules.map { module: ModuleTopics -> scaled(samples.raw(module.angle).heldAt(times), module.radians) },
        )
        once(times, shares?.get(at))
    }

    private companion object {
        /** The lag above which a module does not follow, as a multiple of the others' lag. */
        const val BEHIND = 1.15

        const val CORNERS = 4
        val MORE_STEER_WORDS = setOf("turning", "rot", "pivot")

        /** The words in names of drive motors, apart from their corners. */
        val DRIVE_WORDS = setOf(
            "drive", "driving", "drivetrain", "drivebase", "chassis", "swerve", "module", "modules", "wheel", "wheels", "subsystem",
            "subsystems",
        )

        /** The same where angles come seldom. */
        const val SELDOM_BEHIND = 1.5
    }
}
