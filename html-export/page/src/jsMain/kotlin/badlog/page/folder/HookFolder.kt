package badlog.page.folder

import badlog.core.analysis.Attribute
import badlog.core.analysis.AttributeRegistry
import badlog.core.analysis.Folder
import badlog.core.analysis.Graph
import badlog.core.analysis.GraphSeries
import badlog.core.analysis.LogView
import badlog.core.analysis.TopicPlan
import badlog.core.recording.CellCounts
import badlog.core.recording.Recording
import badlog.core.recording.RecordingFormat
import badlog.core.recording.TextColumn
import badlog.core.recording.Topic
import badlog.page.dom.add
import badlog.page.dom.element
import badlog.protocol.HookPart
import badlog.protocol.PageFigure
import badlog.protocol.PageSeries
import org.w3c.dom.HTMLElement

/** Returns the results of [hook] as a separate folder. */
internal fun folderOf(hook: HookPart): Folder = Folder(
    "From the hook ${hook.name}",
    hook.values,
    emptyList(),
    hook.series.map { Graph(it.name, it.unit, isVirtual = true, isFilled = false, includesZero = false, listOf(lineOf(it))) },
)

/** Returns whether [hook] has results to show in a section. */
internal fun hasSection(hook: HookPart): Boolean = hook.values.isNotEmpty() || hook.series.isNotEmpty() || hook.figures.isNotEmpty()

/** Returns a calculated line. Unlike a logged topic with its own times, it is interpolated between samples. */
private fun lineOf(series: PageSeries): GraphSeries {
    val samples = series.data.y
    val values = samples.count { it.isFinite() }
    val counts = CellCounts(values, 0, 0, 0, samples.size - values, 0)
    val topic = Topic(series.name, series.unit, listOf(CALCULATED.name), samples, TextColumn.EMPTY, counts, series.data.x)
    val recording = Recording(RecordingFormat.BAG, null, emptyList(), listOf(topic), 0, emptyList())
    return LogView.of(recording, AttributeRegistry(listOf(CALCULATED))).folders.single().graphs.single().series.single()
}

private val CALCULATED = object : Attribute {
    override val name get() = "calculated"

    override fun apply(topic: TopicPlan, argument: String?) {
        topic.hide()
        topic.derive(name, { unit, _ -> unit }, { it })
    }
}

/** Returns a picture that a hook drew, with its title above it. */
internal fun hookPicture(figure: PageFigure): HTMLElement = element("figure", "picture card") {
    add("figcaption", "picture-title", figure.title)
    // In an image element, scripts and addresses in the picture have no effect.
    val image = add("img")
    image.setAttribute("alt", figure.title)
    image.addEventListener("error", {
        image.remove()
        add("p", "unit", "This picture cannot be drawn.")
    })
    image.setAttribute("src", "data:${figure.mediaType};base64,${figure.base64}")
}
