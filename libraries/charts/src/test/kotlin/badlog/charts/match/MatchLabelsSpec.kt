package badlog.charts.match

import badlog.charts.chartsOf
import badlog.charts.measuredLog
import badlog.signals.match.MatchOfLog
import io.kotest.core.spec.style.FunSpec
import io.kotest.inspectors.forAll
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.ints.shouldBeLessThanOrEqual
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldNotContain
import javax.xml.parsers.DocumentBuilderFactory

class MatchLabelsSpec : FunSpec({
    val numbers = measuredLog(1).numbers

    fun log(type: String? = null, number: String? = null, file: String = "log.bag", event: String? = null, began: Long? = null) = ChartedLog(MatchOfLog(event, type, number), file, began, numbers)

    fun label(type: String? = null, number: String? = null, file: String = "log.bag") = labelsOf(listOf(log(type, number, file))).single()

    test("a match is called as teams call it") {
        label("Qualification", "42") shouldBe "Q42"
        label("Quarterfinal", "2-1") shouldBe "QF2-1"
        label("semifinals", "3") shouldBe "SF3"
        label("Final", "1") shouldBe "F1"
        label("Elimination", "5") shouldBe "E5"
        label("Practice", "3") shouldBe "Pr3"
        label(number = "7") shouldBe "M7"
    }

    test("a log without a match is labeled with its time, and with the day if there are several") {
        fun labels(vararg began: Long) = labelsOf(began.map { log(file = "FRC_20240316_104100.wpilog", began = it) })
        val morning = 1_710_585_660L
        labels(morning, morning + 3600, morning + 3601) shouldContainExactly listOf("10:41", "11:41", "11:41 (2)")
        labels(morning, morning + 86_400) shouldContainExactly listOf("16 Mar, 10:41", "17 Mar, 10:41")
        // The day of a match is not needed in its label.
        labelsOf(listOf(log(began = morning), log("Qualification", "1", began = 0))) shouldContainExactly listOf("10:41", "Q1")
    }

    test("a log of no match and no time is called by its file") {
        label(file = "practice.bag.gz") shouldBe "practice"
        label(file = "a-name-that-is-much-too-long-for-an-axis.wpilog") shouldBe "a-na…r-an-axis"
        label(file = ".bag") shouldBe "log"
    }

    test("two logs of one match have two labels") {
        labelsOf(listOf(log("Qualification", "42"), log("Qualification", "42"), log("Qualification", "42"))) shouldContainExactly listOf("Q42", "Q42 (2)", "Q42 (3)")
    }

    test("names from logs are plain, short texts without markup or formulas") {
        val hostile = listOf("<script>alert(1)</script>", "</text><script>x</script>", "\\(x^2\\)", "<a href=\"http://x.example\">x</a>", "é".repeat(300), "a\nb\u0000c", "&amp;&#60;", "\uD83D\uDE00")
        hostile.forAll { name ->
            val logs = (1..4).map { log("Qualification", "$name$it", "$name.bag", event = name) } + (5..8).map { log(file = "$name$it.bag", event = name) }
            labelsOf(logs).forAll { it.length shouldBeLessThanOrEqual 20 }
            labelsOf(logs).distinct().size shouldBe 8
            for (chart in chartsOf(logs).all) {
                chart.svg() shouldNotContain "<script"
                chart.svg() shouldNotContain "href="
                DocumentBuilderFactory.newInstance().newDocumentBuilder().parse(chart.svg().byteInputStream())
            }
        }
    }
})
