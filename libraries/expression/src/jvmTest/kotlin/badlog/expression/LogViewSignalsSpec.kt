package badlog.expression

import badlog.core.analysis.LogView
import badlog.core.analysis.Span
import badlog.formats.wpilog.WpilogParser
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import java.io.ByteArrayOutputStream
import java.nio.ByteBuffer
import java.nio.ByteOrder

class LogViewSignalsSpec : FunSpec({
    val log = TinyWpilog()
    log.start(1, "volts", "double")
    log.start(2, "messages", "string")
    log.start(3, "mode", "string")
    for ((micros, volts) in listOf(1_000_000L to 12.0, 5_000_000L to 6.5, 6_000_000L to 11.0)) log.double(1, micros, volts)
    for ((micros, text) in listOf(2_500_000L to "hello", 7_000_000L to "brownout")) log.record(2, micros, text.encodeToByteArray())
    for ((micros, text) in listOf(500_000L to "auto", 3_000_000L to "teleop")) log.record(3, micros, text.encodeToByteArray())
    val signals = LogViewSignals(LogView.of(WpilogParser().apply { accept(log.bytes) }.finish()))

    fun answer(text: String) = parsed(text, signals.vocabulary).answer(signals).toString()

    test("the range of a WPILOG includes all of its clocks, in s") {
        signals.range shouldBe Span(0.5, 7.0)
        signals.timeUnit shouldBe "s"
    }

    test("events and states of a WPILOG are at their own times") {
        signals.series("messages").x.toList() shouldBe listOf(2.5, 7.0)
        signals.series("messages").y.toList() shouldBe listOf(0.0, 1.0)
        signals.series("mode").x.toList() shouldBe listOf(0.5, 3.0)
    }

    test("expressions join topics of different clocks") {
        answer("min(volts) < 7") shouldBe "yes, min(volts) = 6.5 at 5 s"
        answer("messages == 'brownout'") shouldBe "yes, at 7 s"
        answer("volts < 7 and mode == 'teleop'") shouldBe "yes, volts = 6.5 at 5 s, from 5 s to 6 s"
    }
})

/** The bytes of a WPILOG, record by record, all lengths written in full. */
private class TinyWpilog {
    private val out = ByteArrayOutputStream().apply { write("WPILOG".encodeToByteArray() + byteArrayOf(0, 1, 0, 0, 0, 0)) }

    val bytes: ByteArray get() = out.toByteArray()

    fun start(entry: Int, name: String, type: String) {
        val texts = listOf(name, type, "").map { it.encodeToByteArray() }
        val payload = little(5 + texts.sumOf { 4 + it.size }).put(0).putInt(entry)
        for (text in texts) payload.putInt(text.size).put(text)
        record(0, 0, payload.array())
    }

    fun double(entry: Int, micros: Long, value: Double) = record(entry, micros, little(8).putDouble(value).array())

    fun record(entry: Int, micros: Long, payload: ByteArray) {
        out.write(little(14).put(0x7C).put(entry.toByte()).putInt(payload.size).putLong(micros).array() + payload)
    }

    private fun little(size: Int) = ByteBuffer.allocate(size).order(ByteOrder.LITTLE_ENDIAN)
}
