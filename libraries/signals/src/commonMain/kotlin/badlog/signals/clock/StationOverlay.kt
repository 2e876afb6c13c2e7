package badlog.signals.clock

import badlog.core.analysis.LogView
import badlog.core.recording.Topic
import badlog.core.text.UniqueNames
import badlog.signals.signalTopicsOf
import badlog.signals.vocabulary.SignalVocabulary

/**
 * The log of a robot, and the Driver Station's log of the same match, on the robot's clock.
 *
 * @param robot the robot's log, with the signals of [vocabulary].
 * @param station the Driver Station's log.
 * @param fit the relation of the Driver Station's clock to the robot's.
 */
class StationOverlay(
    private val robot: LogView,
    private val station: ClockedLog,
    private val fit: ClockFit,
    private val vocabulary: SignalVocabulary,
) {
    private val names = UniqueNames().also { names -> robot.recording.topics.forEach { names.give(it.name) } }
    private val namesOf = station.recording.topics.map { names.give(it.name) }

    /** The names of the Driver Station's topics in [both], in order. */
    val stationTopics: Set<String> get() = namesOf.toSet()

    /** All topics of both, over the robot's time and the [AROUND] s before and after it. */
    val both: LogView by lazy { with(station.recording.topics.zip(namesOf), AROUND) }

    /**
     * The view on which rules run, over the robot's time: the robot's topics, and the Driver Station's. Topics of the Driver Station are
     * left out if the robot's log has the same signal.
     */
    val forRules: LogView by lazy {
        val own = signalTopicsOf(robot, vocabulary).all.mapTo(HashSet()) { it.signal }
        val served = signalTopicsOf(LogView.of(station.recording), vocabulary).all.groupBy({ it.topic }, { it.signal })
        with(station.recording.topics.zip(namesOf).filter { (topic, _) -> served[topic.name].orEmpty().none { it in own } }, 0.0)
    }

    private fun with(added: List<Pair<Topic, String>>, around: Double): LogView {
        val range = robot.xAxis.range ?: return robot
        val secondsPerX = robot.secondsPerX
        val margin = around / secondsPerX
        // Topics that share their times keep sharing them.
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
        val both = LogView.of(robot.recording.copy(topics = robot.recording.topics + topics))
        val modes = if (robot.modes.enabled != null) robot.modes else signalTopicsOf(both, vocabulary).modes
        // The time of day alone may belong to another match.
        return both.identified(robot.title ?: station.match.title.takeIf { fit.edges >= SURE_EDGES }, modes)
    }

    companion object {
        /** So many matching moments of enabling are not a coincidence. */
        private const val SURE_EDGES = 2

        /** The seconds before and after the robot's log for which the Driver Station's log is also shown. */
        const val AROUND: Double = 10.0
    }
}

private fun DoubleArray.firstAtOrAfter(x: Double): Int = indexOfFirst { it >= x }.let { if (it < 0) size else it }
