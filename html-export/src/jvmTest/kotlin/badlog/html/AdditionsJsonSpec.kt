package badlog.html

import badlog.analysis.Series
import badlog.recording.Severity
import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldNotContain
import io.kotest.property.Arb
import io.kotest.property.arbitrary.bind
import io.kotest.property.arbitrary.boolean
import io.kotest.property.arbitrary.char
import io.kotest.property.arbitrary.choice
import io.kotest.property.arbitrary.constant
import io.kotest.property.arbitrary.double
import io.kotest.property.arbitrary.element
import io.kotest.property.arbitrary.list
import io.kotest.property.arbitrary.map
import io.kotest.property.checkAll
import kotlinx.serialization.json.Json
import kotlinx.serialization.json.JsonElement
import kotlinx.serialization.json.JsonPrimitive
import kotlinx.serialization.json.double
import kotlinx.serialization.json.jsonArray
import kotlinx.serialization.json.jsonObject
import kotlinx.serialization.json.jsonPrimitive
import java.io.ByteArrayOutputStream
import java.nio.ByteBuffer
import java.nio.ByteOrder
import java.util.Base64
import kotlin.io.path.div
import kotlin.io.path.readText
import kotlin.io.path.writeText

class AdditionsJsonSpec : FunSpec({
    fun written(additions: PageAdditions): String {
        val out = ByteArrayOutputStream()
        AdditionsJson(out).write(additions)
        return out.toString(Charsets.UTF_8)
    }

    fun read(additions: PageAdditions) = Json.parseToJsonElement(written(additions)).jsonObject

    fun textOf(element: JsonElement?) = element?.jsonPrimitive?.content

    fun bitsOf(element: JsonElement?): List<Long> {
        val bytes = ByteBuffer.wrap(Base64.getDecoder().decode(textOf(element))).order(ByteOrder.LITTLE_ENDIAN)
        return List(bytes.remaining() / Double.SIZE_BYTES) { bytes.getLong() }
    }

    val hostile = Arb.element(
        "</script>", "<!--", "<!--<script>", "\"", "\\", "\\u003c", "\u2028", "\u0000", "\uD800", "__proto__", "1", "",
    )
    val texts = Arb.list(Arb.choice(hostile, Arb.char('\u0000'..'\uFFFF').map { it.toString() }), 0..5).map { it.joinToString("") }
    val times = Arb.choice(Arb.double(), Arb.constant(Double.NaN))

    test("every text comes back as it was, and none of them can end or open an element") {
        val findings = Arb.bind(texts, texts, Arb.element(Severity.entries), times) { source, text, severity, time ->
            PageFinding(source, severity, text, time, time)
        }
        checkAll(Arb.list(texts, 0..3), Arb.list(findings, 0..3), Arb.list(texts, 0..3), Arb.boolean()) { topics, found, names, fails ->
            val hooks = names.map { HookPart(it, it.takeIf { fails }, names.associateWith { name -> "$name$name" }, found) }
            val additions = PageAdditions(topics, found, hooks)
            written(additions) shouldNotContain "<"
            val json = read(additions)
            json.getValue("virtual").jsonArray.map(::textOf) shouldBe topics
            json.getValue("findings").jsonArray.map { textOf(it.jsonObject["text"]) } shouldBe found.map { it.text }
            json.getValue("findings").jsonArray.map { textOf(it.jsonObject["source"]) } shouldBe found.map { it.source }
            json.getValue("findings").jsonArray.map { it.jsonObject["time"]?.jsonPrimitive?.double } shouldBe
                found.map { finding -> finding.time.takeIf { it.isFinite() } }
            val read = json.getValue("hooks").jsonArray.map { it.jsonObject }
            read.map { textOf(it["name"]) } shouldBe names
            read.map { textOf(it["error"]) } shouldBe hooks.map { it.error }
            read.forEach { hook ->
                hook.getValue("values").jsonArray.map { textOf(it.jsonArray[0]) to textOf(it.jsonArray[1]) } shouldBe
                    hooks[0].values.toList()
            }
        }
    }

    test("every sample comes back to its last bit, also of a series longer than what is written at a time") {
        checkAll(20, Arb.list(times, 0..10_000).map { it.toDoubleArray() }) { samples ->
            val hook = HookPart("h", series = listOf(PageSeries("a", "V", Series(samples, samples))))
            val series = read(PageAdditions(hooks = listOf(hook))).getValue("hooks").jsonArray[0].jsonObject
                .getValue("series").jsonArray[0].jsonObject
            bitsOf(series["x"]) shouldBe samples.map { it.toRawBits() }
            bitsOf(series["y"]) shouldBe samples.map { it.toRawBits() }
        }
    }

    test("a figure comes back byte for byte, and is an SVG or a PNG") {
        val bytes = ByteArray(1000) { it.toByte() }
        val hook = HookPart("h", figures = listOf(PageFigure("A", "image/png", bytes)))
        val figure = read(PageAdditions(hooks = listOf(hook))).getValue("hooks").jsonArray[0].jsonObject
            .getValue("figures").jsonArray[0].jsonObject
        Base64.getDecoder().decode(textOf(figure["data"])) shouldBe bytes
        figure["type"] shouldBe JsonPrimitive("image/png")
        shouldThrow<IllegalArgumentException> { PageFigure("A", "text/html", bytes) }
    }

    test("a page without additions has no byte for them, and one with has what was written") {
        inFolder { folder ->
            val input = (folder / "match.bag").apply { writeText(BAG) }
            val exporter = HtmlExporter(parts = PageParts("", ""))
            exporter.export(input, folder / "plain.html")
            val plain = (folder / "plain.html").readText()
            plain shouldNotContain "additions"
            val additions = PageAdditions(listOf("Double = Speed * 2"))
            exporter.export(input, folder / "more.html", additions)
            val about = "<script type=\"application/json\" id=\"about\">"
            val block = "<script type=\"application/json\" id=\"additions\">${written(additions)}</script>\n"
            (folder / "more.html").readText() shouldBe plain.replace(about, block + about)
        }
    }
})
