package badlog.viewer.layout

import badlog.plot.board.Board
import badlog.plot.board.BoardLayout
import badlog.plot.board.boardOfJson
import badlog.plot.board.toJson
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
 * How a person has arranged a window, by names only: fits every recording of a robot. Its JSON is what a layout file holds.
 *
 * @property version of the format, [VERSION] or newer; its key distinguishes a layout from other JSON.
 * @property graphs the graphs from top to bottom; null for those that the topics' attributes ask for.
 * @property recording the file that was open, as [compared] names files; null for none.
 * @property visible the part of x that was seen in it; null for all.
 * @property selection the part of x that was marked in it, or null.
 * @property compared what lies over the open recording.
 * @property panels which parts of the window are open; null for as they are.
 * @property overTime whether logs that name no x axis are drawn over their column of the time; null where nobody has said.
 * @property formulas the definitions of topics that are calculated from others.
 */
@Serializable
internal data class Layout(
    @SerialName(BoardLayout.VERSION_KEY) val version: Int,
    @Serializable(BoardSerializer::class) val graphs: Board? = null,
    val recording: String? = null,
    val visible: LayoutSpan? = null,
    val selection: LayoutSpan? = null,
    val compared: LayoutComparison = LayoutComparison(),
    val panels: LayoutPanels? = null,
    val overTime: Boolean? = null,
    val formulas: List<String> = emptyList(),
) {
    companion object {
        /** The format that this program writes. */
        const val VERSION = BoardLayout.VERSION

        /** How the names of layout files end. */
        const val ENDING = BoardLayout.ENDING
    }
}

/** A board in the JSON of a layout: the list of its graphs, as [toJson] writes it. */
internal object BoardSerializer : KSerializer<Board> {
    override val descriptor: SerialDescriptor = JsonElement.serializer().descriptor

    override fun serialize(encoder: Encoder, value: Board) =
        encoder.encodeSerializableValue(JsonElement.serializer(), Json.parseToJsonElement(value.toJson()).jsonObject.getValue(GRAPHS))

    override fun deserialize(decoder: Decoder): Board =
        boardOfJson("{\"$GRAPHS\":${decoder.decodeSerializableValue(JsonElement.serializer())}}")

    private const val GRAPHS = "graphs"
}

/** A part of an axis. */
@Serializable
internal data class LayoutSpan(val from: Double, val to: Double)

/**
 * The recordings that a [Layout] lays over the open one.
 *
 * @property files their files, relative to the library's folder where they are in it, with `/` between the parts.
 * @property alignment by what they are aligned, as the comparison calls it; empty for its default.
 * @property offsets by how much each file was moved by hand, in units of x.
 */
@Serializable
internal data class LayoutComparison(
    val files: List<String> = emptyList(),
    val alignment: String = "",
    val offsets: Map<String, Double> = emptyMap(),
)

/** Which parts of the window a [Layout] opens; means what [badlog.viewer.panels.Panels] means, by the names of its values. */
@Serializable
internal data class LayoutPanels(
    val library: Boolean = true,
    val topics: Boolean = true,
    val inspector: String? = null,
    val main: String? = null,
)
