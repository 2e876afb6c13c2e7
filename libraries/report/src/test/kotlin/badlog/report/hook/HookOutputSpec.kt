package badlog.report.hook

import badlog.core.recording.Severity
import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.property.Arb
import io.kotest.property.arbitrary.int
import io.kotest.property.arbitrary.string
import io.kotest.property.checkAll
import java.util.Base64

private fun read(json: String) = HookOutput.read(json)

private const val WHOLE = """{"values": {"a": "b", "n": 1.5}, "findings": [{"severity": "error", "text": "t", "time": 2, "until": 3}],
    "series": [{"name": "s", "unit": "V", "x": [0, 1, 1], "y": [1, null, -2e3]}],
    "figures": [{"title": "f", "svg": "<svg/>"}, {"title": "g", "svg": "<?xml version='1.0'?>\n<svg xmlns=''></svg>"},
    {"title": "p", "png": "iVBORw0KGgoA"}]}"""

class HookOutputSpec : FunSpec({
    test("everything that a hook may return is read") {
        val fixed = WHOLE.replace("<svg/>", "<svg ></svg>")
        val result = read(fixed)
        result.values shouldBe mapOf("a" to "b", "n" to "1.5")
        result.findings.single().run {
            severity shouldBe Severity.ERROR
            text shouldBe "t"
            time shouldBe 2.0
            until shouldBe 3.0
        }
        result.series.single().data.y[1].isNaN() shouldBe true
        result.figures.map { it.mediaType } shouldBe listOf("image/svg+xml", "image/svg+xml", "image/png")
    }

    test("an empty object is enough, and a finding needs only a text") {
        read("{}").values shouldBe emptyMap()
        read("""{"findings": [{"text": "x"}]}""").findings.single().severity shouldBe Severity.WARNING
    }

    val mistakes = mapOf(
        "" to "printed nothing",
        "hello" to "not an object",
        "{" to "did not print JSON",
        "[]" to "the output is a list, not an object",
        """{"value": {}}""" to "“value” is not a key; the keys are values, findings, series, figures",
        """{"values": []}""" to "“values” must be an object of texts and numbers, not a list",
        """{"values": {"a": null}}""" to "The value “a” must be a text or a number, not null",
        """{"findings": {}}""" to "“findings” must be a list",
        """{"findings": [{"text": 3}]}""" to "In number 1 of “findings” “text” must be a text, not 3",
        """{"findings": [{"text": "", "severity": "bad"}]}""" to "error, warning or note, not “bad”",
        """{"findings": [{"text": "", "time": "1"}]}""" to "“time” must be a number or missing, not a text",
        """{"findings": [{"text": "", "time": 2, "until": 1}]}""" to "must not be before",
        """{"series": [{"name": "s", "x": [1], "y": []}]}""" to "“x” has 1 numbers and “y” has 0",
        """{"series": [{"name": "s", "x": [2, 1], "y": [0, 0]}]}""" to "decreases at number 2",
        """{"series": [{"name": "s", "x": [null], "y": [0]}]}""" to "number 1 of “x” is null",
        """{"series": [{"name": "s", "x": [1], "y": [1e999]}]}""" to "not a number",
        """{"series": [{"name": "s", "x": [1], "y": [NaN]}]}""" to "number 1 of “y” is NaN, not a number; a gap is null",
        """{"findings": [{"text": "", "time": NaN}]}""" to "“time” must be a number or missing, not NaN",
        """{"series": [{"x": [], "y": []}]}""" to "“name” is missing",
        """{"figures": [{"title": "f"}]}""" to "either “svg” or “png”",
        """{"figures": [{"title": "f", "svg": "<html>"}]}""" to "starts with <svg",
        """{"figures": [{"title": "f", "svg": "${"<!---->".repeat(200_000)}<html>"}]}""" to "starts with <svg",
        """{"figures": [{"title": "f", "svg": "<!DOCTYPE svg [<!ENTITY a 'b'>]><svg/>"}]}""" to "starts with <svg",
        """{"figures": [{"title": "f", "png": "AAAA"}]}""" to "must be a PNG",
        """{"values": {"a": "${"x".repeat(10_001)}"}}""" to "10001 characters; at most 10000 are allowed",
    )
    for ((json, message) in mistakes) {
        test("refuses ${json.take(60)} with a sentence") {
            shouldThrow<IllegalArgumentException> { read(json) }.message shouldContain message
        }
    }

    fun figure(key: String, content: String) = read("""{"figures": [{"title": "f", "$key": "$content"}]}""").figures.single()

    test("an SVG may have anything before its root that XML allows") {
        for (svg in listOf(
            "<svg/>",
            "\\n<?xml version='1.0'?>\\n<!-- Generator: X 29.1, SVG Export Plug-In . --><svg ></svg>",
            "<!-- a > b --><!DOCTYPE svg PUBLIC 'x' 'y'><!---->\\n<svg\\nxmlns=''></svg>",
            "${"<!---->".repeat(200_000)}<svg/>",
        )) {
            figure("svg", svg).mediaType shouldBe "image/svg+xml"
        }
    }

    test("a PNG may have 4 MiB, however it is encoded") {
        val most = 4 shl 20
        val begin = byteArrayOf(0x89.toByte(), 'P'.code.toByte(), 'N'.code.toByte(), 'G'.code.toByte(), 13, 10, 26, 10)
        fun lines(size: Int) = String(Base64.getMimeEncoder().encode(begin.copyOf(size))).replace("\r\n", "\\n")
        figure("png", lines(most)).bytes.size shouldBe most
        shouldThrow<IllegalArgumentException> { figure("png", lines(most + 1)) }.message shouldContain "at most 4194304 are allowed"
    }

    test("any output of a hook is read, or refused with a sentence") {
        checkAll(Arb.int(0, WHOLE.length), Arb.string(0, 5)) { at, text ->
            try {
                read(WHOLE.take(at) + text + WHOLE.drop(at + text.length))
            } catch (e: IllegalArgumentException) {
                e.message!!.isNotBlank() shouldBe true
            }
        }
        shouldThrow<IllegalArgumentException> { read("[".repeat(100_000)) }
    }
})
