package badlog.expression

import badlog.core.analysis.LogView
import badlog.core.analysis.Span
import badlog.core.bag.BagParser
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe

private const val HEADER = """{"topics":[{"name":"Time","unit":"s","attrs":["xaxis"]},{"name":"V","unit":"V"},""" +
    """{"name":"Rare","unit":"A"},{"name":"Log","attrs":["log"]}],"values":[]}"""

private fun viewOf(rows: List<String>): LogView {
    val text = HEADER + "\nTime,V,Rare,Log\n" + rows.joinToString("") { it + "\n" }
    return LogView.of(BagParser().apply { accept(text.encodeToByteArray()) }.finish())
}

class SetBackSpec : FunSpec({
    // From 10 s back to 5 s; in the 2 s from then on V is 0. At 7 s the second time there is an event, and a rare number.
    val view = viewOf(
        List(200) { i ->
            val time = if (i < 100) i * 0.1 else i * 0.1 - 5
            "${(time * 10).toInt() / 10.0},${if (i in 100 until 120) 0 else 12},${if (i % 40 == 0) i else ""},${if (i == 110) "ready" else ""}"
        },
    )
    val signals = LogViewSignals(view)

    fun answer(text: String) = parsed(text, signals.vocabulary).answer(signals)
    fun number(text: String) = answer(text).quantities.single().value

    test("a formula of time finds where the clock was set back") {
        answer("delta(Time) < 0").toString() shouldBe "yes, delta(Time) = -4.9 s at 5 s, at 5 s"
    }

    test("a condition that holds once has one occurrence, although its time occurs twice") {
        answer("V < 1").run {
            spans shouldBe listOf(Span(5.0, 7.0))
            times shouldBe 1
        }
        number("count(V < 1)") shouldBe 1.0
        readable(number("total(V < 1)")) shouldBe "2"
        number("count(changed(V))") shouldBe 2.0
        readable(number("duration(V)")) shouldBe "19.8"
    }

    test("a condition that always holds has one occurrence in two parts") {
        answer("V >= 0").run {
            spans shouldBe listOf(Span(0.0, 9.9), Span(5.0, 14.9))
            times shouldBe 1
        }
    }

    test("events and rare numbers belong to their rows, not to other rows with the same time") {
        answer("Log contains 'ready' and V < 1").toString() shouldBe "yes, V = 0 V at 6 s, at 6 s"
        answer("Log contains 'ready' and V > 1").matches shouldBe false
        number("max(V when Rare == 80)") shouldBe 12.0
        number("count(V < 1 when Rare == 80)") shouldBe 1.0
    }

    test("a virtual topic has a sample in each row, in their order") {
        val with = view.withVirtualTopics(listOf("Twice = 2 * V", "Later = shift(V, 0.1 s)", "Low = min(V)")).view
        for (name in listOf("Twice", "Later", "Low")) {
            with.recording.topics.single { it.name == name }.times shouldBe null
        }
        val asked = LogViewSignals(with)
        fun count(text: String) = parsed(text, asked.vocabulary).answer(asked).quantities[0].value
        count("count(Later < 1)") shouldBe 1.0
        count("max(Low)") shouldBe 0.0
        with.xAxis.clocks.size shouldBe 1
    }

    test("rows without a time do not hide that the clock was set back") {
        val gaps = LogViewSignals(viewOf(listOf("1,10,,", "2,20,,", ",30,,", "1,40,,", "2,50,,")))
        val asked = parsed("previous(V)", gaps.vocabulary).series(gaps)
        asked.x.toList() shouldBe listOf(1.0, 2.0, 1.0, 2.0)
        asked.y.drop(1) shouldBe listOf(10.0, 20.0, 40.0)
    }

    test("a clock that is set back repeatedly costs no more than others") {
        val restless = LogViewSignals(viewOf(List(100_000) { "${it % 2},${it % 7},," }))
        parsed("V > 5 and during(0, 0.5) for 0.6 s", restless.vocabulary).answer(restless).times shouldBe 0
        parsed("count(V > 5)", restless.vocabulary).answer(restless).quantities.single().value shouldBe 14_285.0
    }
})
