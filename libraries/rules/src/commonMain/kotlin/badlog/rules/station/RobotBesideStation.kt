package badlog.rules.station

import badlog.analysis.LogView
import badlog.recording.Recording
import badlog.recording.Topic
import badlog.rules.signal.SignalVocabulary
import badlog.rules.signalTopicsOf
import badlog.rules.withSignals
import badlog.text.UniqueNames

/**
 * The log of a robot, and the Driver Station's of the same match on its clock.
 *
 * @param robot the robot's, with the signals of [vocabulary].
 * @param station what the Driver Station logged.
 * @param fit how that stands on the robot's clock.
 */
public class RobotBesideStation(
    private val robot: LogView,
    private val station: Recording,
    private val fit: ClockFit,
    private val vocabulary: SignalVocabulary,
) {
    private val names = UniqueNames().also { names -> robot.recording.topics.forEach { names.give(it.name) } }
    private val namesOf = station.topics.map { names.give(it.name) }

    /** The names that the Driver Station's topics have in [both], in their order. */
    public val stationTopics: Set<String> get() = namesOf.toSet()

    /** All topics of both, over the robot's time and the [AROUND] s before and after it. */
    public val both: LogView by lazy { with(station.topics.zip(namesOf), AROUND) }

    /**
     * What rules are run over: the robot's topics, and of the Driver Station's those that are signals which the robot's log lacks, over the
     * robot's time. What the robot logged itself counts.
     */
    public val forRules: LogView by lazy {
        val own = signalTopicsOf(robot, vocabulary).all.mapTo(HashSet()) { it.signal }
        val served = signalTopicsOf(LogView.of(station), vocabulary).all.groupBy({ it.topic }, { it.signal })
        with(station.topics.zip(namesOf).filter { (topic, _) -> served[topic.name].orEmpty().none { it in own } }, 0.0)
    }

    private fun with(added: List<Pair<Topic, String>>, around: Double): LogView {
        val range = robot.xAxis.range ?: return robot
        val secondsPerX = robot.secondsPerX
        val margin = around / secondsPerX
        // Topics that share their times still do.
        val moved = HashMap<DoubleArray, Pair<Int, DoubleArray>>()
        val topics = added.mapNotNull { (topic, name) ->
            val (from, times) = moved.getOrPut(topic.times ?: return@mapNotNull null) {
                val all = DoubleArray(topic.times!!.size) { (topic.times!![it] + fit.seconds) / secondsPerX }
                val from = all.firstAtOrAfter(range.start - margin)
                val until = maxOf(from, all.indexOfFirst { it > range.endInclusive + margin }.let { if (it < 0) all.size else it })
                from to all.copyOfRange(from, until)
            }
            topic.slice(from, from + times.size, name, times)
        }
        val both = LogView.of(robot.recording.copy(topics = robot.recording.topics + topics)).withSignals(vocabulary)
        val modes = if (robot.modes.enabled != null) robot.modes else both.modes
        return both.identified(robot.title ?: LogView.of(station).withSignals(vocabulary).title, modes)
    }

    public companion object {
        /** For so many s before and after the robot's log the Driver Station's is shown, too. */
        public const val AROUND: Double = 10.0
    }
}

private fun DoubleArray.firstAtOrAfter(x: Double): Int = indexOfFirst { it >= x }.let { if (it < 0) size else it }
