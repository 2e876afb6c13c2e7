package badlog.window.layout

import badlog.viewer.choices.board.Board
import badlog.viewer.choices.board.BoardLayout
import badlog.viewer.choices.board.boardOfJson
import badlog.viewer.choices.board.toJson
import kotlinx.serialization.KSerializer
import kotlinx.serialization.SerialName
import kotlinx.serialization.Serializable
import kotlinx.serialization.descriptors.SerialDescriptor
import kotlinx.serialization.encoding.Decoder
import kotlinx.serialization.encoding.Encoder
import kotlinx.serialization.json.Json
import kotlinx.serialization.json.JsonElement
import kotlinx.serialization.json.jsonObject

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
