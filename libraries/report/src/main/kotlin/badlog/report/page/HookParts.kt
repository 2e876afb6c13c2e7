package badlog.report.page

import badlog.core.recording.Value
import badlog.protocol.HookPart
import badlog.protocol.PageFigure
import badlog.protocol.PageSeries
import badlog.report.hook.HookOutcome
import java.util.Base64

/** Returns the parts of a log's page with the outcomes of [hooks]. */
fun hookParts(hooks: List<HookOutcome>): List<HookPart> = hooks.map { outcome ->
    val result = outcome.result ?: return@map HookPart(outcome.hook, error = outcome.failure?.message)
    HookPart(
        outcome.hook,
        values = result.values.map { (name, text) -> Value(name, text) },
        findings = outcome.findings(timeUnit = ""),
        series = result.series.map { PageSeries(it.name, it.unit, it.data) },
        figures = result.figures.map { PageFigure(it.title, it.mediaType, Base64.getEncoder().encodeToString(it.bytes)) },
    )
}
