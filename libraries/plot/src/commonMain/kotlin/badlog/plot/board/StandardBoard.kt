package badlog.plot.board

import badlog.analysis.LogView
import badlog.rules.LogShape
import badlog.rules.signal.SignalTopics
import badlog.rules.signal.SignalVocabulary

/** The graphs that a log begins with: [defaultBoard], where that is one that a person can look through, else [boardOfLarge]. */
public fun standardBoard(view: LogView, vocabulary: SignalVocabulary): Board = boardOfLarge(view, vocabulary) ?: defaultBoard(view)

/**
 * The graphs that a log begins with whose [defaultBoard] nobody can look through, null for another one: first those of the signals of
 * [vocabulary] that change: battery and current, modes, loop time, loads, outputs; then the first ones of the others.
 */
public fun boardOfLarge(view: LogView, vocabulary: SignalVocabulary): Board? {
    val all = defaultBoard(view).graphs
    if (all.size <= MANY) return null
    val topics = LogShape.of(view).topicsOf(vocabulary)
    val changing = view.recording.topics.filter(::everChanges).mapTo(HashSet()) { it.name }
    val first = STANDARD.flatMap { signals ->
        graphsOf(view, signals.flatMap { namesOf(it, topics) }.filter { it in changing }, vocabulary)
    }
    val shown = first.flatMapTo(HashSet()) { it.lines }
    val others = all.filter { graph -> graph.lines.none { it in shown } }.take(maxOf(0, MOST - first.size))
    return Board((first + others).mapIndexed { i, graph -> graph.copy(id = i + 1) })
}

private fun namesOf(signal: String, topics: SignalTopics) = topics.of(signal).map { it.topic }

// As high as all others: there is no need to fit one screen.
private fun graphsOf(view: LogView, names: List<String>, vocabulary: SignalVocabulary) =
    evidenceBoard(view, names, vocabulary).graphs.map { it.copy(height = null) }

/** So many graphs are no more than a person looks through. */
private const val MANY = 60

/** So many graphs a large log begins with at most. */
private const val MOST = 24

private val STANDARD = listOf(
    listOf("battery", "total current"),
    listOf("robot enabled", "robot autonomous", "robot teleop", "brownout", "link"),
    listOf("loop time"),
    listOf("CAN load", "CPU load"),
    listOf("motor output"),
    listOf("motor current"),
    listOf("module speed"),
)
