package badlog.page.embedded

import badlog.analysis.Series
import badlog.analysis.Span
import badlog.page.view.Finding
import badlog.recording.Severity
import badlog.recording.Value
import kotlinx.browser.document
import org.khronos.webgl.Float64Array
import org.khronos.webgl.Int8Array

/**
 * What the page carries besides the recording.
 *
 * @property virtualTopics definitions of topics that are calculated from others.
 * @property findings what rules found.
 * @property hooks what programs returned.
 * @property isUnreadable whether there is something that this browser cannot read.
 */
internal class Additions(
    val virtualTopics: List<String>,
    val findings: List<Finding>,
    val hooks: List<Hook>,
    val isUnreadable: Boolean = false,
) {
    companion object {
        /** Reads it from the page. */
        fun find(): Additions {
            val element = document.getElementById("additions") ?: return Additions(emptyList(), emptyList(), emptyList())
            return try {
                val json = JSON.parse<dynamic>(element.textContent.orEmpty())
                Additions(list(json.virtual) { it as String }, list(json.findings, ::finding), list(json.hooks, ::hook))
            } catch (problem: Throwable) {
                // As when it is longer than a text may be.
                console.error(problem)
                Additions(emptyList(), emptyList(), emptyList(), isUnreadable = true)
            }
        }

        private fun hook(json: dynamic) = Hook(
            name = json.name as String,
            error = json.error as String?,
            values = list(json.values) { Value(it[0] as String, it[1] as String) },
            findings = list(json.findings, ::finding),
            series = list(json.series) {
                HookSeries(it.name as String, it.unit as String, Series(doubles(it.x as String), doubles(it.y as String)))
            },
            figures = list(json.figures) { HookFigure(it.title as String, it.type as String, it.data as String) },
        )

        private fun finding(json: dynamic) = Finding(
            source = json.source as String,
            severity = Severity.valueOf((json.severity as String).uppercase()),
            text = json.text as String,
            time = json.time as Double? ?: Double.NaN,
            until = json.until as Double? ?: Double.NaN,
            further = if (json.further == null) emptyList() else list(json.further) { Span(it[0] as Double, it[1] as Double) },
        )

        // Every machine that runs a browser has the little end first, as they are written.
        private fun doubles(base64: String): DoubleArray {
            val bytes = Base64.decode(base64).unsafeCast<Int8Array>()
            return Float64Array(bytes.buffer, bytes.byteOffset, bytes.length / Double.SIZE_BYTES).unsafeCast<DoubleArray>()
        }

        private fun <T> list(array: dynamic, read: (dynamic) -> T): List<T> = array.unsafeCast<Array<dynamic>>().map { read(it) }
    }
}
