package badlog.assistant.tool

import badlog.assistant.call.Answer
import badlog.assistant.call.Arguments
import badlog.assistant.call.AssistantTool
import badlog.assistant.call.Parameter
import badlog.assistant.call.ParameterType
import badlog.assistant.call.ToolException
import badlog.assistant.call.unitOf
import badlog.assistant.log.OpenLogs
import badlog.assistant.picture.GraphPicture
import badlog.core.recording.TopicKind
import kotlinx.serialization.json.addJsonObject
import kotlinx.serialization.json.buildJsonObject
import kotlinx.serialization.json.put
import kotlinx.serialization.json.putJsonArray

/** Draws topics over a range. */
internal class GraphOfTopics(private val logs: OpenLogs) :
    AssistantTool(
        "graph",
        "Graph of topics",
        "Draws topics of one log over a range as a PNG: a panel for each unit, a lane for each state or boolean, shaded where the robot " +
            "was enabled (orange: autonomous, blue: teleop). At most $MAX_TOPICS topics of at most $MAX_UNITS units. Use samples or " +
            "statistics for exact numbers.",
        OpenLogs.TOPICS +
            Parameter(
                "width",
                ParameterType.WHOLE,
                "The width of the picture in pixels, $MIN_WIDTH to $MAX_WIDTH; default $DEFAULT_WIDTH.",
            ),
    ) {
    override fun answer(arguments: Arguments): Answer {
        val width = arguments.whole("width", DEFAULT_WIDTH, MIN_WIDTH..MAX_WIDTH)
        val log = logs.open(arguments)
        val lines = log.lines(arguments, MAX_TOPICS)
        lines.find { it.topic.kind == TopicKind.EVENT }?.let {
            throw ToolException("“${it.topic.name}” has events, which a graph cannot show; ask for its samples instead.")
        }
        val units = lines.filter { it.states == null }.map { unitOf(it.unit) }.distinct().size
        if (units > MAX_UNITS) throw ToolException("The topics have $units units, and a graph shows $MAX_UNITS; ask for two graphs.")
        val range =
            log.range(arguments)?.takeIf { it.width > 0 }
                ?: throw ToolException("There is nothing to draw in this range; select a longer one.")
        val title = listOfNotNull(log.view.title, log.name).joinToString(" · ")
        val picture = GraphPicture(log.view, title, lines, range, width)
        val png = try {
            picture.png()
        } catch (e: LinkageError) {
            throw drawingFailed(e)
        } catch (e: InternalError) {
            throw drawingFailed(e)
        }
        val data = buildJsonObject {
            put("log", log.name)
            log.putX(this, range)
            put("width", width)
            put("height", picture.height)
            putJsonArray("topics") {
                for (line in lines) {
                    addJsonObject {
                        put("name", line.topic.name)
                        put("unit", unitOf(line.unit))
                    }
                }
            }
        }
        return Answer(data, png)
    }

    /** Returns the answer if drawing fails, for example on a system without any font. */
    private fun drawingFailed(e: Error) = ToolException(
        "This computer's Java cannot draw text ($e); install fontconfig and a font, such as Debian's fonts-dejavu-core, or ask for samples.",
    )
}

private const val MAX_TOPICS = 8
private const val MAX_UNITS = 4
private const val MIN_WIDTH = 400
private const val MAX_WIDTH = 1_600
private const val DEFAULT_WIDTH = 1_000
