package badlog.window.layout

import badlog.core.analysis.Span
import badlog.viewer.choices.board.Board
import badlog.viewer.choices.board.BoardLayout
import badlog.viewer.choices.board.boardOfJson
import badlog.viewer.choices.board.mergedWith
import badlog.viewer.choices.board.toJson
import badlog.viewer.choices.comparison.Alignment
import badlog.viewer.choices.formula.keyOf
import badlog.viewer.choices.mergedWith
import badlog.window.compare.Comparison
import badlog.window.sidebar.InspectorTab
import badlog.window.sidebar.MainView
import badlog.window.sidebar.Panels
import kotlinx.serialization.KSerializer
import kotlinx.serialization.SerialName
import kotlinx.serialization.Serializable
import kotlinx.serialization.descriptors.SerialDescriptor
import kotlinx.serialization.encoding.Decoder
import kotlinx.serialization.encoding.Encoder
import kotlinx.serialization.json.Json
import kotlinx.serialization.json.JsonElement
import kotlinx.serialization.json.jsonObject
import java.nio.file.Path

/**
 * A person's arrangement of a window, by names only: it fits every recording of a robot. A layout file contains it as JSON.
 *
 * @property version the version of the format, [VERSION] or newer; its key distinguishes a layout from other JSON.
 * @property graphs the graphs from top to bottom; null for graphs according to the topics' attributes.
 * @property recording the file that was open, written as in [compared]; null for none.
 * @property visible its visible range; null for all.
 * @property selection its selection, or null.
 * @property place its cursors and its selected finding, see [badlog.viewer.session.link.keptText].
 * @property compared the recordings compared with the open one.
 * @property panels the open parts of the window; null for no change.
 * @property overTime whether logs that name no x axis are drawn over their time column; null if a person has not chosen.
 * @property formulas the definitions of topics that are calculated from others.
 */
@Serializable
internal data class Layout(
    @SerialName(BoardLayout.VERSION_KEY) val version: Int,
    @Serializable(BoardSerializer::class) val graphs: Board? = null,
    val recording: String? = null,
    val visible: LayoutSpan? = null,
    val selection: LayoutSpan? = null,
    val place: String = "",
    val compared: LayoutComparison = LayoutComparison(),
    val panels: LayoutPanels? = null,
    val overTime: Boolean? = null,
    val formulas: List<String> = emptyList(),
) {
    companion object {
        /** The format that this program writes. */
        const val VERSION = BoardLayout.VERSION

        /** The ending of layout files' names. */
        const val ENDING = BoardLayout.ENDING
    }
}

/** Serializes a board in the JSON of a layout: the list of its graphs, as in [toJson]. */
internal object BoardSerializer : KSerializer<Board> {
    override val descriptor: SerialDescriptor = JsonElement.serializer().descriptor

    override fun serialize(encoder: Encoder, value: Board) {
        val board = Json.parseToJsonElement(value.toJson(haveIds = true)).jsonObject
        encoder.encodeSerializableValue(JsonElement.serializer(), board.getValue(GRAPHS))
    }

    override fun deserialize(decoder: Decoder): Board =
        boardOfJson("{\"$GRAPHS\":${decoder.decodeSerializableValue(JsonElement.serializer())}}")

    private const val GRAPHS = "graphs"
}

/** A part of an axis. */
@Serializable
internal data class LayoutSpan(val from: Double, val to: Double)

/**
 * The recordings that a [Layout] compares with the open one.
 *
 * @property files their files, relative to the library's folder if they are in it, with `/` between the parts.
 * @property alignment the name of the alignment; empty for the default.
 * @property offsets the manual offset of each file, in units of x.
 */
@Serializable
internal data class LayoutComparison(
    val files: List<String> = emptyList(),
    val alignment: String = "",
    val offsets: Map<String, Double> = emptyMap(),
)

/** The parts of the window that a [Layout] opens; like [badlog.window.sidebar.Panels], with the names of its values. */
@Serializable
internal data class LayoutPanels(
    val library: Boolean = true,
    val topics: Boolean = true,
    val inspector: String? = null,
    val main: String? = null,
)

/** Returns [span] in the form for a layout; null if an end is not finite, which JSON cannot store. */
internal fun layoutSpan(span: Span) = LayoutSpan(span.from, span.to).takeIf { it.from.isFinite() && it.to.isFinite() }

/** Returns [panels] in the form for a layout. The pit view is temporary: the next start shows the graphs. */
internal fun layoutOf(panels: Panels): LayoutPanels {
    val main = panels.main.takeUnless { it == MainView.PIT } ?: MainView.GRAPHS
    return LayoutPanels(panels.library, panels.topics, panels.inspector?.name, main.name)
}

/** Returns [comparison] in the form for a layout, with files relative to [folder]. */
internal fun layoutOf(comparison: Comparison, folder: Path?) = LayoutComparison(
    files = comparison.checked.map { pathText(it, folder) },
    alignment = comparison.offsets.alignment.layoutName,
    offsets = comparison.offsets.byHand.mapKeys { pathText(it.key, folder) },
)

/** Returns the alignment of [layout]. */
internal fun alignmentOf(layout: LayoutComparison): Alignment =
    Alignment.entries.find { it.layoutName == layout.alignment } ?: Alignment.START

/** Returns [panels] in the window's form; if their main view is unknown, it stays as in [now]. */
internal fun panelsOf(panels: LayoutPanels, now: Panels): Panels = now.copy(
    library = panels.library,
    topics = panels.topics,
    keepsTopics = false,
    inspector = panels.inspector?.let { name -> InspectorTab.entries.find { it.name == name } },
    main = MainView.entries.find { it.name == panels.main } ?: now.main,
)

/**
 * Returns the merged layout of two windows on one folder. Each graph and formula that [mine] has not changed since [before] is as in
 * [theirs]; otherwise it is as in [mine]. The open log and its visible range belong together. Graphs do not draw formulas that one of the
 * two has removed.
 *
 * @param initial the graphs that [mine] began with, if [before] has none.
 */
internal fun merged(mine: Layout, before: Layout, theirs: Layout, initial: Board = Board()): Layout {
    val place = if (placeIn(mine) == placeIn(before)) theirs else mine
    val both = Layout(
        version = mine.version,
        graphs = mergedGraphs(mine.graphs, before.graphs, theirs.graphs, initial),
        recording = place.recording,
        visible = place.visible,
        selection = place.selection,
        place = place.place,
        compared = (if (mine.compared == before.compared) theirs else mine).compared,
        panels = (if (mine.panels == before.panels) theirs else mine).panels,
        overTime = (if (mine.overTime == before.overTime) theirs else mine).overTime,
        formulas = mine.formulas.mergedWith(theirs.formulas, before.formulas, key = ::keyOf),
    )
    val removed = listOf(mine, before, theirs).flatMapTo(HashSet()) { it.formulas.map(::keyOf) } - both.formulas.map(::keyOf).toSet()
    return both.copy(graphs = both.graphs?.let { removed.fold(it, Board::withoutSignal) })
}

private fun mergedGraphs(mine: Board?, before: Board?, theirs: Board?, initial: Board): Board? = when {
    mine == before -> theirs
    theirs == before || mine == null || theirs == null -> mine
    else -> mine.mergedWith(theirs, before ?: initial)
}

private fun placeIn(layout: Layout) = listOf(layout.recording, layout.visible, layout.selection, layout.place)
