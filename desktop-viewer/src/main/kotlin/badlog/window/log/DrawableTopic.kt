package badlog.window.log

import badlog.core.analysis.GraphSeries
import badlog.core.analysis.Series
import badlog.core.recording.PathName
import badlog.core.recording.Topic
import badlog.core.recording.TopicKind
import badlog.viewer.shown.cursor.indexAt
import badlog.viewer.shown.cursor.textOf
import badlog.viewer.shown.outline.traits
import badlog.viewer.shown.search.Query
import badlog.viewer.shown.search.Trait
import badlog.viewer.text.numberText
import badlog.viewer.text.withUnit

/**
 * A line to draw: a topic, or a series that an attribute derives from one. The same name means the same signal in every recording of a
 * robot, and graphs, layouts and comparisons refer to it.
 *
 * @property name the full name, unique in its recording.
 * @property isDerived whether it was calculated rather than logged; its [title] is then in brackets.
 * @property line the signal as a line of a graph.
 * @property definition the formula that calculates it; null if there is none.
 */
internal class DrawableTopic(val name: String, val isDerived: Boolean, val line: GraphSeries, val definition: String? = null) {
    /** The unit, `ul` for none. */
    val unit: String get() = line.unit

    /** The topic it comes from. */
    val topic: Topic get() = line.topic

    /** The names of the states, if the numbers stand for states; otherwise null. */
    val states: List<String>? get() = line.states

    /** Whether it has samples, and they are numbers or truth values, for calculations; otherwise they are states or events. */
    val hasFigures: Boolean get() = topic.samples.isNotEmpty() && topic.kind != TopicKind.STATE && topic.kind != TopicKind.EVENT

    /** Whether it has no logged values. */
    val isEmpty: Boolean get() = topic.samples.isEmpty() && topic.texts.size == 0

    /** Its traits for searches; the first call examines its samples. */
    val traits: Set<Trait> by lazy { line.traits }

    /** The folder it belongs to; empty for the root folder. */
    val folder: String get() = PathName.folderOf(name)

    /** Its name without the folder. */
    val title: String get() = PathName.baseNameOf(name).let { if (isDerived) "[ $it ]" else it }

    /** Its samples. The first call may calculate them: do not call it while drawing. */
    val series: Series get() = line.data
}

/**
 * Returns whether [query] matches the displayed name [text] and the topic's traits. [found] holds the names of the topics that a finding is
 * about.
 */
internal fun DrawableTopic.isFoundBy(query: Query, found: Set<String>, text: String = name): Boolean {
    // Traits cost a look through the samples, so they are determined only if a search needs them.
    val own = if (Trait.entries.any(query::asksFor)) traits else emptySet()
    return query.matches(text, if (name in found) own + Trait.FINDING else own)
}

/**
 * Returns the value of [signal] at [position], or at its end for null; `–` for a gap. It is a number, formatted by [sampleText], with its
 * unit, or the name of a state.
 */
internal fun valueText(signal: DrawableTopic, position: Double?, sampleText: (Double) -> String = ::numberText): String {
    val index = if (position == null) signal.series.size - 1 else signal.line.indexAt(position)
    return signal.line.textOf(index) { withUnit(sampleText(it), signal.unit) }
}
