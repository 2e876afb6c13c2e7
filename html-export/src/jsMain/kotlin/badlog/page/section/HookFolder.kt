package badlog.page.section

import badlog.analysis.Attribute
import badlog.analysis.AttributeRegistry
import badlog.analysis.Folder
import badlog.analysis.Graph
import badlog.analysis.GraphSeries
import badlog.analysis.LogView
import badlog.analysis.TopicPlan
import badlog.html.protocol.HookPart
import badlog.html.protocol.PageSeries
import badlog.recording.CellCounts
import badlog.recording.Recording
import badlog.recording.RecordingFormat
import badlog.recording.TextColumn
import badlog.recording.Topic

/** Returns what [hook] calculated, as a separate folder. */
internal fun folderOf(hook: HookPart): Folder = Folder(
    "From the hook ${hook.name}",
    hook.values,
    emptyList(),
    hook.series.map { Graph(it.name, it.unit, isVirtual = true, isFilled = false, includesZero = false, listOf(lineOf(it))) },
)

/** Returns whether [hook] returned something that has a section. */
internal fun hasSection(hook: HookPart): Boolean = hook.values.isNotEmpty() || hook.series.isNotEmpty() || hook.figures.isNotEmpty()

/** Returns a calculated line: unlike a logged topic with times of its own, it is interpolated from one sample to the next. */
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
