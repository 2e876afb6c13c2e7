package badlog.charts

import badlog.charts.match.ChartedLog
import badlog.rules.number.Measure
import badlog.signals.match.MatchKind
import badlog.signals.match.MatchOfLog
import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.inspectors.forAll
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.doubles.shouldBeGreaterThan
import io.kotest.matchers.ints.shouldBeInRange
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldNotContain
import org.w3c.dom.Document
import java.io.ByteArrayInputStream
import javax.imageio.ImageIO
import javax.xml.parsers.DocumentBuilderFactory

private fun parsed(svg: String): Document = DocumentBuilderFactory.newInstance().newDocumentBuilder().parse(ByteArrayInputStream(svg.encodeToByteArray()))

private fun textsIn(svg: String): List<String> = parsed(svg).getElementsByTagName("text").let { all -> List(all.length) { all.item(it).textContent.trim() } }

@Tags("InCheck")
class ChartsSpec : FunSpec({
    val charts = chartsOf((1..12).map { measuredLog(it) })

    fun chart(name: String, of: Charts = charts) = of.all.single { it.name == name }

    test("complete data makes a chart for each question") {
        charts.all.map { it.name } shouldContainExactly
            listOf("battery", "loop-times", "loops-per-match", "battery-over-current", "resistance", "packet-loss", "motor-temperatures")
        charts.lacking.shouldBeEmpty()
        charts.all.forAll { it.question.last() shouldBe '?' }
    }

    test("a chart is a scalable SVG with a title that needs no script and no network") {
        charts.all.forAll { chart ->
            val svg = chart.svg()
            parsed(svg).documentElement.getAttribute("viewBox") shouldBe "0 0 900 420"
            textsIn(svg).let { texts -> listOf("${chart.title} · Mill Creek", chart.question).forAll { (it in texts) shouldBe true } }
            svg shouldContain "12 logs"
            svg shouldNotContain "<script"
            Regex("[a-z]+://[^\"<]*").findAll(svg).map { it.value }.toSet() shouldBe setOf("http://www.w3.org/2000/svg", "http://www.w3.org/1999/xlink")
            Regex("\\son[a-z]+=|url\\((?!#)|@import|href=").containsMatchIn(svg) shouldBe false
        }
    }

    test("a chart is rendered as a picture of the requested size") {
        charts.all.take(2).forAll { chart ->
            val picture = ImageIO.read(ByteArrayInputStream(chart.png()))
            picture.width to picture.height shouldBe (1800 to 840)
            picture.getRGB(2, 2) and 0xFFFFFF shouldBe 0xFFFFFF
        }
        ImageIO.read(ByteArrayInputStream(chart("battery").png(scale = 1))).width shouldBe 900
    }

    test("a trend has a point for each match, and their names below it") {
        parsed(chart("battery").svg()).getElementsByTagName("circle").length shouldBe 12
        textsIn(chart("battery").svg()).filter { it.matches(Regex("Q\\d+")) } shouldContainExactly (1..12).map { "Q$it" }
        chart("resistance").reading shouldContain "95 % uncertainty"
        chart("battery").reading shouldNotContain "uncertainty"
    }

    test("matches are in the order of play, not of the list") {
        val shuffled = chartsOf(listOf(7, 3, 5, 1).map { measuredLog(it) })
        textsIn(chart("battery", shuffled).svg()).filter { it.matches(Regex("Q\\d+")) } shouldContainExactly listOf("Q1", "Q3", "Q5", "Q7")
    }

    test("an outlier has a label at its point, and a limit near the values is drawn") {
        val low = chartsOf((1..12).map { if (it == 8) measuredLog(it, volts = 6.2) else measuredLog(it) })
        textsIn(chart("battery", low).svg()).count { it == "Q8" } shouldBe 2
        chart("battery", low).reading shouldContain "red: brownout, 6.75 V"
        chart("battery").reading shouldNotContain "brownout"
    }

    test("a limit at any distance is drawn if a match is on its bad side") {
        val empty = chartsOf((1..5).map { measuredLog(it, volts = 3.0 + 0.01 * it) })
        chart("battery", empty).reading shouldContain "red: brownout, 6.75 V"
        // The value is on the axis.
        textsIn(chart("battery", empty).svg()).mapNotNull { it.toDoubleOrNull() }.max() shouldBeGreaterThan 6.0
    }

    test("practice is left out if there are enough matches, with a note in the chart") {
        val practice = (21..22).map { measuredLog(it, match = MatchOfLog(type = "Practice"), kind = MatchKind.PRACTICE) }
        val of4 = chart("battery", chartsOf((1..4).map { measuredLog(it) } + practice)).svg()
        parsed(of4).getElementsByTagName("circle").length shouldBe 4
        of4 shouldContain "4 matches, without 2 other logs"
        textsIn(of4) shouldContain "Battery at its lowest · Mill Creek"
        val of2 = chart("battery", chartsOf((1..2).map { measuredLog(it) } + practice)).svg()
        parsed(of2).getElementsByTagName("circle").length shouldBe 4
        of2 shouldContain "4 logs"
    }

    test("the title contains the event only if all logs are of the same event") {
        fun title(vararg events: String?): String {
            val logs = events.mapIndexed { i, event -> measuredLog(i, match = MatchOfLog(event, "Qualification", "$i")) }
            return textsIn(chart("battery", chartsOf(logs)).svg()).single { it.startsWith("Battery at its lowest") }
        }
        title("Mill Creek", "MILL CREEK", "mill creek ") shouldBe "Battery at its lowest · Mill Creek"
        title("Mill Creek", null, null) shouldBe "Battery at its lowest"
        title("Mill Creek", "Mill Creek", "Lake") shouldBe "Battery at its lowest"
    }

    test("matches without a known time are in the order of their names") {
        val matches = listOf("Final" to "1", "Qualification" to "10", "Elimination" to "3", "Qualification" to "9", "Practice" to "4")
        val unordered = matches.mapIndexed { i, (type, number) -> measuredLog(20 - i, match = MatchOfLog(null, type, number), began = null) }
        val axis = textsIn(chart("battery", chartsOf(unordered)).svg()).filter { it.matches(Regex("[A-Z][a-z]?\\d+")) }
        axis shouldContainExactly listOf("Pr4", "Q9", "Q10", "E3", "F1")
    }

    test("all parts of boxes are explained") {
        chart("loops-per-match").reading shouldContain "dashed: 20 ms"
    }

    test("a hundred matches have only as many labels as fit") {
        val many = chartsOf((1..100).map { measuredLog(it) })
        textsIn(chart("battery", many).svg()).count { it.matches(Regex("Q\\d+")) } shouldBeInRange 10..30
        parsed(chart("battery", many).svg()).getElementsByTagName("circle").length shouldBe 100
    }

    test("a log without a number is left out of that number's chart only") {
        val other = ChartedLog(MatchOfLog(number = "99"), "x.bag", 9_999, InventedNumbers().number("CPU load", Measure.ENABLED, 50.0).numbers())
        val with = chartsOf((1..4).map { measuredLog(it) } + other)
        parsed(chart("battery", with).svg()).getElementsByTagName("circle").length shouldBe 4
        textsIn(chart("battery", with).svg()).contains("M99") shouldBe true
        chart("battery", with).svg() shouldContain "4 logs"
    }

    test("a chart with too little data is replaced by a sentence about the missing data") {
        chartsOf(emptyList()).run { listOf(all.size, lacking.size) } shouldBe listOf(0, 7)
        chartsOf(emptyList()).undrawn shouldContainExactly charts.all.map { it.name }
        chartsOf(listOf(measuredLog(1), measuredLog(2))).lacking.first() shouldBe
            "“Battery at its lowest” needs the battery’s voltage in at least 3 logs; only 2 logs show it."
        chartsOf(listOf(measuredLog(1))).lacking.first() shouldContain "only 1 log shows it."
        chartsOf(emptyList()).lacking.first() shouldContain "no log shows it."
    }

    test("equal values have a chart, too") {
        val same = chartsOf((1..5).map { measuredLog(it, volts = 9.0) { distribution("total current", List(7) { 100.0 }) } })
        parsed(chart("battery", same).svg()).getElementsByTagName("circle").length shouldBe 5
    }

    test("work can be stopped before each chart") {
        var asked = 0
        shouldThrow<IllegalStateException> { chartsOf(emptyList()) { check(++asked < 3) } }
        asked shouldBe 3
    }
})
