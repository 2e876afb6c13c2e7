package badlog.viewer.draw.path

import badlog.viewer.shown.cursor.Cursors

/** The legend's entry for [trace], which [part] draws. */
class XyEntry internal constructor(private val part: XyPart, private val trace: XyTrace) {
    /** The name of the trace. */
    val name: String get() = trace.name

    /** The name of the trace's log; null if no other log is drawn. */
    val log: String? get() = part.log.name.takeIf { part.isCompared }

    /** The names of the trace's lines, by which a board hides it. */
    val lines: List<String> get() = trace.lines

    /** The index of the trace's color in the palette. */
    val color: Int get() = part.colorOf(trace.color)

    /** The name of the trace, with the log's name unless that is the open log. */
    val title: String get() = if (part.index == 0) name else "$name (${part.log.name})"

    /** Returns whether the trace is drawn while the lines in [hidden] are not. */
    fun isShown(hidden: Set<String>): Boolean = lines.none { it in hidden }

    /** Returns the trace's places at [cursors], or its numbers if it is not on a field. Empty if it has none there. */
    fun textAt(cursors: Cursors): String {
        val texts = listOfNotNull(cursors.x, cursors.second).map { trace.textAt(it - part.log.offset, part.plot.isField) }
        return if (texts.all { it.isEmpty() }) "" else texts.joinToString(" → ") { it.ifEmpty { NOWHERE } }
    }

    private companion object {
        const val NOWHERE = "–"
    }
}
