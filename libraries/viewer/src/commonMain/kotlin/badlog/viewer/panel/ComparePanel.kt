package badlog.viewer.panel

import badlog.viewer.choices.comparison.Alignment
import badlog.viewer.choices.comparison.OFFSET_STEPS
import badlog.viewer.choices.comparison.OffsetStep
import badlog.viewer.choices.comparison.offsetOf
import badlog.viewer.choices.comparison.offsetText
import badlog.viewer.shown.comparison.DrawnLog
import badlog.viewer.state.Action
import badlog.viewer.state.CompareRequest

/**
 * Returns a bar with the logs that graphs draw over each other; empty if there is nothing to compare.
 *
 * @param open the name of the open log beside the others.
 * @param others the compared logs that were read.
 * @param reading the names of the files that are being read.
 */
fun comparePanel(alignment: Alignment, open: String, others: List<DrawnLog>, reading: List<String> = emptyList()): List<Part> {
    if (others.isEmpty() && reading.isEmpty()) return emptyList()
    val tools = listOf(
        Button("Compare with another log", Action.Ask(CompareRequest.Choose), PartIcon.ADD),
        Button("Stop comparing", Action.Ask(CompareRequest.Clear), PartIcon.CLOSE),
    )
    val alignments = Alignment.entries.map {
        Button(it.title, Action.Ask(CompareRequest.Align(it)), hint = it.hint, isOn = it == alignment)
    }
    val rows = listOf(Value("compared-log 0", open, "open", color = 0)) + others.mapIndexed(::row) +
        reading.map { Paragraph("reading $it", "Reading $it…", Tone.MUTED) }
    return listOf(
        Heading("Compared", "", tools),
        Choice("alignment", "Align at", alignments),
        Rows("compared-logs", "Compared logs", rows),
    )
}

private fun row(index: Int, log: DrawnLog): Value {
    fun move(offset: Double) = Action.Ask(CompareRequest.Move(index, offset))
    fun button(step: OffsetStep) = Button(step.label, move(log.offset + step.by), hint = step.hintFor(log.name))
    val remove = Button("Stop comparing with ${log.name}", Action.Ask(CompareRequest.Remove(index)), PartIcon.CLOSE)
    val text = offsetText(log.offset)
    val field = Field("compared-offset", "Offset of ${log.name}", text = text, isValid = { offsetOf(it) != null }) {
        move(offsetOf(it) ?: log.offset)
    }
    return Value("compared-log ${index + 1}", log.name, text, tools = OFFSET_STEPS.map(::button) + remove, color = index + 1, field = field)
}
