package badlog.viewer.panel

import badlog.core.analysis.Span
import badlog.core.recording.Severity
import badlog.viewer.catalog.TopicSummary
import badlog.viewer.state.Action

/** A table with [columns], called [name] by screen readers. Without room for its columns, its rows are cards. */
class EntryTable(override val key: String, val name: String, val columns: List<EntryColumn>, val groups: List<EntryGroup>) : Part

/**
 * A column of an [EntryTable].
 *
 * @property isDescending the order of the rows, if they are sorted by it; otherwise null.
 * @property sort the effect of a press on its [title]; null for none.
 * @property hint an explanation of its title; empty for none.
 */
class EntryColumn(
    val key: String,
    val title: String,
    val isNumber: Boolean,
    val isDescending: Boolean? = null,
    val sort: Action? = null,
    val hint: String = "",
)

/** The [rows] of a table under a common [title], with their [count]; an empty title is not shown. */
class EntryGroup(val title: String, val count: String, val rows: List<Entry>)

/**
 * A row of an [EntryTable], called [name] by screen readers.
 *
 * @property checks its check boxes, below each other.
 * @property cells for each column, its entries, below each other.
 * @property open the effect of a press on the row; null for none.
 * @property isMuted whether there is nothing to see in it.
 */
class Entry(
    val key: String,
    val name: String,
    val checks: List<Check>,
    val cells: List<List<EntryCell>>,
    val open: Action?,
    val isMuted: Boolean,
)

/** A check box, called [label] by screen readers. */
class Check(val label: String, val isOn: Boolean, val action: Action)

/**
 * A cell of an [Entry].
 *
 * @property severity its severity, in color, and without a [share] also as a shape and word; null if it does not matter.
 * @property share the length of a bar beside it, 0 to 1; null for none.
 * @property preview the shape of a series; null for none.
 * @property open the effect of a press on it; null for the effect of the row.
 * @property isUnfolded whether the rows below belong to it and are shown; null if there are none.
 */
class EntryCell(
    val text: String,
    val severity: Severity? = null,
    val hint: String = "",
    val share: Double? = null,
    val preview: Preview? = null,
    val open: Action? = null,
    val isUnfolded: Boolean? = null,
)

/** The shape of the series of [topic], drawn with the [range] of y from bottom to top. */
class Preview(val topic: TopicSummary, val range: Span)
