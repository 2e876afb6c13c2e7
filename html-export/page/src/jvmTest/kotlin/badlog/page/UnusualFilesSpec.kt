package badlog.page

import badlog.core.bag.BagTopic
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.doubles.shouldBeLessThanOrEqual
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldNotContain

private const val HEADER =
    """{"topics":[{"name":"Time","unit":"s","attrs":["xaxis"]},{"name":"A","unit":"V","attrs":[]}],"values":[]}"""

/** Files that no robot should write, and robots do. The page opens, and says what there is to say. */
internal class UnusualFilesSpec : PageSpec({
    /** The kinds of the problems that the page shows. */
    fun OpenPage.problems(): List<String> {
        if (!element("#problems").isDisplayed) return emptyList()
        if (!element(".problem-list").isDisplayed) click(".problems-toggle")
        return elements(".problem").map { it.getDomAttribute("data-kind").orEmpty() }
    }

    browserTest("no bytes at all") {
        onPage(TestPages.of("")) { problems() shouldContain "EMPTY_FILE" }
    }

    browserTest("a header and nothing else") {
        onPage(TestPages.of("$HEADER\n")) { text shouldContain "A" }
    }

    browserTest("a header and titles, but no row") {
        onPage(TestPages.of("$HEADER\nTime,A\n")) {
            problems() shouldContain "NO_ROWS"
            texts(".plot") shouldContain "No data"
        }
    }

    browserTest("one row") {
        onPage(TestPages.of("$HEADER\nTime,A\n5.0,3.0\n")) {
            graph("A").scrollTo().hover(0.5)
            graph("A").value("A") shouldBe "3"
            graph("A").pixelsOfLine(0) shouldBeGreaterThan 0
            graph("A").drag(0.2, 0.6)
            texts(".fact").none { it.endsWith(" s") } shouldBe true
            texts(".range-readout .range").single() shouldNotContain "–"
        }
    }

    browserTest("a topic whose samples are all NaN has no data") {
        onPage(TestPages.of("$HEADER\nTime,A\n0,NaN\n1,NaN\n2,NaN\n")) { texts(".plot") shouldContain "No data" }
    }

    browserTest("a unit that is written from the right leaves the order of what stands beside it alone") {
        onPage(TestPages.of("{\"topics\":[{\"name\":\"A\",\"unit\":\"متر\"}],\"values\":[]}\nA\n1\n2\n", "متر.bag")) {
            (elements(".fact") + elements(".graph-unit")).map { it.tagName }.toSet() shouldBe setOf("bdi")
        }
    }

    browserTest("one sample among gaps can be seen") {
        onPage(TestPages.of("$HEADER\nTime,A\n0,\n1,\n2,7\n3,\n4,\n")) {
            graph("A").scrollTo().hover(0.5)
            graph("A").value("A") shouldBe "7"
            graph("A").pixelsOfLine(0) shouldBeGreaterThan 0
        }
    }

    browserTest("nothing but gaps") {
        onPage(TestPages.of("$HEADER\nTime,A\n0,\n1,\n2,\n")) {
            graphNames shouldContain "A"
            texts(".plot") shouldContain "No data"
        }
    }

    browserTest("infinities and NaN leave gaps, and say what they are") {
        onPage(TestPages.of("$HEADER\nTime,A\n0,1\n1,Infinity\n2,NaN\n3,-Infinity\n4,2\n")) {
            graph("A").scrollTo().hover(0.25)
            graph("A").value("A") shouldBe "∞"
            graph("A").hover(0.75)
            graph("A").value("A") shouldBe "-∞"
        }
    }

    browserTest("a clock that goes backwards is reported, drawn, and can be read") {
        val rows = (0..50).joinToString("") { "${100 + it},1\n" } + (0..50).joinToString("") { "$it,2\n" }
        onPage(TestPages.of("$HEADER\nTime,A\n$rows")) {
            problems() shouldContain "X_BACKWARDS"
            val graph = graph("A").scrollTo()
            graph.pixelsOfLine(0) shouldBeGreaterThan 0
            graph.hover(0.1)
            graph.value("A") shouldBe "2"
            graph.hover(0.9)
            graph.value("A") shouldBe "1"
            graph.drag(0.2, 0.6)
        }
    }

    browserTest("states and truth values are lanes with their texts") {
        val topics = listOf(TIME, BagTopic("Gear"), BagTopic("Enabled"))
        val bag = bagOf(topics, 100) { row, column ->
            if (column == 0) {
                row
            } else if (column == 1) {
                (if (row < 50) "LOW" else "HIGH")
            } else {
                row >= 50
            }
        }
        onPage(TestPages.of(bag)) {
            graph("States").hover(0.2)
            graph("States").value("Gear") shouldBe "LOW"
            graph("States").value("Enabled") shouldBe "false"
            graph("States").hover(0.8)
            graph("States").value("Gear") shouldBe "HIGH"
            graph("States").value("Enabled") shouldBe "true"
        }
    }

    browserTest("a sparse CSV file: each column has its values where it has them") {
        val csv = "Timestamp,A,B,Mode\n" + (0 until 300).joinToString("") { row ->
            val a = if (row % 10 == 0) "$row" else ""
            val b = if (row % 100 == 5) "$row" else ""
            "$row,$a,$b,${if (row == 150) "auto" else ""}\n"
        }
        onPage(TestPages.of(csv, "sparse.csv")) {
            graph("A").scrollTo().pixelsOfLine(0) shouldBeGreaterThan 0
            graph("B").scrollTo().pixelsOfLine(0) shouldBeGreaterThan 0
        }
    }

    browserTest("names of 500 letters do not make the page wider than the window") {
        val long = "Very".repeat(125)
        val joined = BagTopic("A", attributes = listOf("join:$long B"))
        val topics = listOf(TIME, BagTopic(long, long), BagTopic("$long/$long"), joined)
        val values = mapOf(long to long, "Event Name" to long)
        for (screen in listOf(Screen.WIDE, Screen.PHONE)) {
            onPage(TestPages.of(bagOf(topics, 50, values) { row, _ -> row }), screen) {
                graphNames shouldContain long
                number("return document.documentElement.scrollWidth - innerWidth") shouldBeLessThanOrEqual 0.0
            }
        }
    }

    browserTest("300 topics in 20 folders open, the first of them as graphs, and only those near the screen are drawn") {
        val topics = listOf(TIME) + List(300) { BagTopic("Folder ${it % 20}/Topic $it", "V") }
        onPage(TestPages.of(bagOf(topics, 200) { row, column -> row * column })) {
            elements(".folder .graph").size shouldBe 36
            elements(".folder").size shouldBe 20
            val drawn = elements("canvas").size
            drawn shouldBeGreaterThan 2
            (drawn < 20) shouldBe true
            click("#search")
            press("topic 297")
            settle()
            graph("Folder 17/Topic 297").scrollTo().hover(0.999)
            graph("Folder 17/Topic 297").value("Topic 297").toInt() shouldBe 199 * 298
            elements("canvas").size.let { it < 20 } shouldBe true
        }
    }

    browserTest("two topics of one name are two graphs") {
        onPage(TestPages.of("Time,A,A\n0,1,5\n1,2,6\n", "twice.csv")) {
            graphNames shouldContain "A"
            graphNames shouldContain "A (2)"
        }
    }
})
