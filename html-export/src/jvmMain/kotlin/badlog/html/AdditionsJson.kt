package badlog.html

import java.io.OutputStream
import java.nio.ByteBuffer
import java.nio.ByteOrder

/**
 * Writes additions as JSON that can stand in a script element: without any `<`. Samples are the base64 of their doubles,
 * little end first, which is exact, a third as long as digits, and needs no copy of a series.
 */
internal class AdditionsJson(private val out: OutputStream) {
    fun write(additions: PageAdditions) {
        text("{\"virtual\":")
        list(additions.virtualTopics) { text(quoteJson(it)) }
        text(",\"findings\":")
        list(additions.findings, ::finding)
        text(",\"hooks\":")
        list(additions.hooks, ::hook)
        text("}")
    }

    private fun hook(hook: HookPart) {
        text("{\"name\":${quoteJson(hook.name)}")
        if (hook.error != null) text(",\"error\":${quoteJson(hook.error)}")
        // Pairs, since an object would sort names that are numbers, and some names are not its own.
        text(",\"values\":")
        list(hook.values.entries) { text("[${quoteJson(it.key)},${quoteJson(it.value)}]") }
        text(",\"findings\":")
        list(hook.findings, ::finding)
        text(",\"series\":")
        list(hook.series, ::series)
        text(",\"figures\":")
        list(hook.figures, ::figure)
        text("}")
    }

    private fun finding(finding: PageFinding) {
        val severity = finding.severity.name.lowercase()
        text("{\"source\":${quoteJson(finding.source)},\"severity\":\"$severity\",\"text\":${quoteJson(finding.text)}")
        if (finding.time.isFinite()) text(",\"time\":${finding.time}")
        if (finding.until.isFinite()) text(",\"until\":${finding.until}")
        text("}")
    }

    private fun series(series: PageSeries) {
        text("{\"name\":${quoteJson(series.name)},\"unit\":${quoteJson(series.unit)},\"x\":")
        doubles(series.data.x)
        text(",\"y\":")
        doubles(series.data.y)
        text("}")
    }

    private fun figure(figure: PageFigure) {
        text("{\"title\":${quoteJson(figure.title)},\"type\":${quoteJson(figure.mediaType)},\"data\":")
        base64 { it.write(figure.bytes) }
        text("}")
    }

    private fun doubles(numbers: DoubleArray) = base64 { stream ->
        val buffer = ByteBuffer.allocate(Double.SIZE_BYTES * AT_A_TIME).order(ByteOrder.LITTLE_ENDIAN)
        var from = 0
        while (from < numbers.size) {
            val count = minOf(AT_A_TIME, numbers.size - from)
            buffer.asDoubleBuffer().put(numbers, from, count)
            stream.write(buffer.array(), 0, count * Double.SIZE_BYTES)
            from += count
        }
    }

    private fun base64(write: (Base64Stream) -> Unit) {
        text("\"")
        Base64Stream(out).apply(write).finish()
        text("\"")
    }

    private fun <T> list(items: Collection<T>, write: (T) -> Unit) {
        text("[")
        items.forEachIndexed { index, item ->
            if (index > 0) text(",")
            write(item)
        }
        text("]")
    }

    private fun text(text: String) = out.write(text.encodeToByteArray())

    private companion object {
        const val AT_A_TIME = 4096
    }
}
