package badlog.signals

import badlog.core.analysis.Series
import badlog.signals.derived.airGain
import badlog.signals.derived.airLoss
import badlog.signals.derived.channelChanges
import badlog.signals.derived.headingGap
import badlog.signals.derived.headingJump
import badlog.signals.derived.heldAt
import badlog.signals.derived.largestOf
import badlog.signals.derived.missedPulls
import badlog.signals.derived.scaled
import badlog.signals.derived.sightError
import badlog.signals.derived.timesOf
import badlog.signals.derived.unexplainedDrop
import badlog.signals.pose.Pose
import badlog.signals.pose.SeenPath
import badlog.signals.vocabulary.SignalTopics
import badlog.signals.vocabulary.SignalVocabulary
import badlog.signals.vocabulary.TARGET_WORDS
import badlog.signals.vocabulary.wordsOf
import kotlin.math.PI

/** The names of all [DerivedSignal]s; true for those that a log has at most once. */
val DERIVED_NAMES: Map<String, Boolean> = mapOf(
    "voltage lost" to true, "setpoint error" to false, "speed shortfall" to false, "overshoot" to false, "speed swing" to false,
    "position swing" to false,
    "module angle error" to false, "module angle lag" to false, "module speed share" to false, "coupling error" to false,
    "encoder frozen" to false,
    "heading jump" to false, "sight error" to true, "air loss" to true, "air gain" to true, "stall" to false, "standstill" to false,
    "side friction" to false,
    "switch error" to false, "output without effect" to false, "module current share" to false,
    "channel change" to false, "device silent" to false, "side frozen" to false, "total current" to true,
    "largest current" to true, "friction rise" to false, "missed pulls" to false, "heading gap" to false, "held by limit" to false,
)

/**
 * Returns the signals that can be calculated in logs of the shape [shape], where [found] has the topics that are signals of [vocabulary].
 */
fun derivedSignalsOf(shape: LogShape, vocabulary: SignalVocabulary, found: SignalTopics): List<DerivedSignal> =
    DerivedSearch(shape, vocabulary, found).signals

private class DerivedSearch(shape: LogShape, vocabulary: SignalVocabulary, private val found: SignalTopics) {
    private val names = shape.vocabulary.signals.filter { it.name != shape.timeTopic && it.name !in shape.empty }
    private val robot = RobotParts(names, vocabulary)
    private val modules = robot.modules
    private val bus = BusSignals(robot.devices, modules)
    private val wheels = ModuleSignals(robot, bus)

    val signals: List<DerivedSignal> =
        listOfNotNull(totalCurrent(), largestCurrent(), voltageLost(), airLoss(), airGain(), shape.sight?.let(::sight)) +
            MechanismSignals(robot, named("battery")?.let { battery -> { it.of(battery) } }).signals + wheels.signals +
            channels() +
            rests() +
            headings() +
            shape.sight?.seen?.let(::headingGaps).orEmpty() +
            sideSignals(robot) +
            bus.signals

    private fun named(signal: String): NamedSignal? {
        val topics = found.of(signal).ifEmpty { found.summandsOf(signal) }
        return if (topics.isEmpty()) null else NamedSignal.of(signal, topics)
    }

    /** The total current of the motors, if nothing logs the current of the battery or of the channels. */
    private fun totalCurrent(): DerivedSignal? {
        val battery = named("battery") ?: return null
        return if (named(TOTAL_CURRENT) == null) bus.totalCurrent { it.of(battery) } else null
    }

    /** The current of the channel or the motor that takes most, at each time. */
    private fun largestCurrent(): DerivedSignal? {
        val topics = found.of("channel current").map { it.topic }.ifEmpty { return bus.largestCurrent }
        return DerivedSignal("largest current", "A", "", topics) { samples ->
            val series = topics.map(samples::raw)
            val times = timesOf(series)
            Series(times, largestOf(series.map { it.heldAt(times) }))
        }
    }

    private fun voltageLost(): DerivedSignal? {
        val battery = named("battery") ?: return null
        val current = named(TOTAL_CURRENT) ?: totalCurrent()?.let { NamedSignal.of(TOTAL_CURRENT, it) } ?: return null
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

    private fun channels(): List<DerivedSignal> {
        val topics = found.of("channel current").map { it.topic }
        if (modules.size != 4 || topics.size < 4) return emptyList()
        return topics.mapIndexed { at, topic ->
            DerivedSignal("channel change", "", topic, listOf(topic)) { samples ->
                val changes = samples.channelChanges.getOrPut("") {
                    // A motor that logs its own current is named instead: a channel is only a number.
                    if (wheels.sharesIn(samples).orEmpty().any { it != null && it < WEAK }) return@getOrPut emptyList()
                    val series = topics.map(samples::raw)
                    val times = timesOf(series)
                    channelChanges(times, series.map { it.heldAt(times) }, samples.enabledAt(times)).orEmpty()
                }
                once(samples.raw(topic).x, changes.getOrNull(at))
            }
        }
    }

    /** How often each channel rests alone: their currents show which channels belong together. */
    private fun rests(): List<DerivedSignal> {
        val topics = found.of("channel current").map { it.topic }
        return topics.mapIndexed { at, topic ->
            DerivedSignal("missed pulls", "", topic, listOf(topic)) { samples ->
                val pulls = samples.missedPulls.getOrPut("") {
                    val series = topics.map(samples::raw)
                    val times = timesOf(series)
                    missedPulls(times, series.map { it.heldAt(times) }, samples.enabledAt(times), HARD_PULL).map { own ->
                        Series(times, own ?: DoubleArray(times.size))
                    }
                }
                pulls[at]
            }
        }
    }

    private fun headings(): List<DerivedSignal> = found.of("gyro angle").map { topic ->
        val heading = NamedSignal.of("gyro angle", listOf(topic))
        DerivedSignal("heading jump", "deg", topic.device, heading.topics) { headingJump(it.of(heading), 1.0) }
    }

    /** How fast each gyro turns away from the heading that the camera sees. */
    private fun headingGaps(seen: Pose): List<DerivedSignal> {
        val name = seen.heading.singleOrNull() ?: return emptyList()
        // “Vision/Goal” is where the robot should turn to.
        if (wordsOf(seen.name).any { it in TARGET_WORDS }) return emptyList()
        return found.of("gyro angle").map { topic ->
            val heading = NamedSignal.of("gyro angle", listOf(topic))
            DerivedSignal("heading gap", "deg/s", topic.device, heading.topics + name) { samples ->
                val camera = samples.raw(name)
                headingGap(samples.of(heading), Series(camera.x, scaled(camera.y, seen.radians / DEGREE)))
            }
        }
    }
}

private const val DEGREE = PI / 180
private const val SHOWN = 4

/** The share of the others' current below which a drive motor is weak. */
private const val WEAK = 0.82
private const val TOTAL_CURRENT = "total current"

/** The rating of the largest breakers of a power distribution's channels, in A. */
private const val HARD_PULL = 40.0
