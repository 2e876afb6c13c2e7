package badlog.page

import badlog.core.analysis.Span
import badlog.core.recording.Severity
import badlog.rules.Finding
import java.util.Base64

/** Returns a finding from [time] to [until], if that is later, and over the spans of [further]. */
internal fun finding(
    rule: String,
    severity: Severity,
    text: String,
    time: Double,
    until: Double = Double.NaN,
    further: List<Span> = emptyList(),
): Finding {
    val spans = if (time.isNaN()) emptyList() else listOf(Span(time, if (until > time) until else time)) + further
    return Finding(rule, severity, null, text, time, spans, spans.size, "s")
}

internal fun base64(bytes: ByteArray): String = Base64.getEncoder().encodeToString(bytes)
