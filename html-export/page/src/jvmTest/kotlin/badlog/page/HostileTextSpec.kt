package badlog.page

import badlog.core.analysis.Series
import badlog.core.bag.BagTopic
import badlog.core.recording.Severity
import badlog.core.recording.Value
import badlog.protocol.HookPart
import badlog.protocol.PageAdditions
import badlog.protocol.PageSeries
import io.kotest.core.annotation.Tags
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.collections.shouldContainAll
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain

/** Texts that try to become markup or script, or to end a script. */
private val HOSTILE = listOf(
    "</script><img src=x onerror=alert(1)>",
    "<!--",
    "<!--<script>",
    "\"><svg onload=alert(1)>",
    "' onmouseover='alert(1)",
    "]]>",
    "\${alert(1)}",
    "`\${alert(1)}`",
    "{{constructor.constructor('alert(1)')()}}",
    "&lt;b&gt;&amp;",
    "javascript:alert(1)",
    "</title></textarea></style><iframe src=javascript:alert(1)>",
    "__proto__",
    "constructor",
)

@Tags("InCheck")
internal class HostileTextSpec : PageSpec({
    // Counts the calls, because a dialog would stop the test.
    val alarm = "window.alarms = 0; window.alert = () => { window.alarms++ };"

    fun OpenPage.checkTame() {
        number("return window.alarms") shouldBe 0.0
        script(
            "return [...document.querySelectorAll('img, iframe, object, [onload], [onerror], [onmouseover], b')]" +
                ".map(e => e.outerHTML)",
        ) shouldBe emptyList<String>()
        texts("script:not(#recording):not(#additions):not(#about):not(#packed):not(#unpacking):not(#program)") shouldBe emptyList()
    }

    browserTest("hostile findings, hooks and formulas stay text") {
        val findings = HOSTILE.mapIndexed { i, text -> finding(text, Severity.entries[i % 3], text, i.toDouble(), Double.NaN) }
        val line = Series(doubleArrayOf(0.0, 1.0), doubleArrayOf(0.0, 1.0))
        val hooks = HOSTILE.map { text -> HookPart(text, text, listOf(Value(text, text)), emptyList(), listOf(PageSeries(text, text, line))) }
        val definitions = HOSTILE + HOSTILE.map { "\"formula ${it.replace("\"", "\"\"")}\" = A * 2" }
        val bag = bagOf(listOf(TIME, BagTopic("A")), HOSTILE.size) { row, _ -> row }
        onPage(TestPages.of(bag, additions = PageAdditions(definitions, findings = findings, hooks = hooks)), script = alarm) {
            click(".findings-more button")
            texts(".finding-source") shouldContainAll HOSTILE
            for (row in listOf(0, 3)) {
                graph("A").scrollTo().hover(row * 0.9995 / (HOSTILE.size - 1))
                graph("A").label shouldContain HOSTILE[row]
                texts(".event-readout").single() shouldContain HOSTILE[row]
            }
            texts(".hook .folder-name") shouldBe HOSTILE.map { "From the hook $it" }
            texts(".hook .value-row .value-text") shouldBe HOSTILE
            texts(".hook .origin") shouldBe HOSTILE.map { "from $it" }
            if (elements(".problem-list").isEmpty()) click("#problems summary")
            texts(".problem-text").joinToString("\n").let { listed -> HOSTILE.forEach { listed shouldContain it } }
            for (graph in graphNames) graph(graph).scrollTo()
            press("f")
            press(HOSTILE[0])
            checkTame()
        }
    }

    browserTest("hostile texts of a log stay text") {
        step("names, units and attributes of topics, and values, also as the title of the page") {
            // A slash would make a folder of the text before it, so the graphs are found by their base names.
            val topics = listOf(TIME) + HOSTILE.map { BagTopic(it, it, listOf(it)) }
            val values = HOSTILE.associateWith { it } + mapOf("Event Name" to HOSTILE[0], "Match Number" to HOSTILE[3])
            onPage(TestPages.of(bagOf(topics, 50, values) { row, column -> row * column }), script = alarm) {
                checkTame()
                texts(".value-row .value-text") shouldContainAll HOSTILE
                driver.title shouldContain HOSTILE[0]
                texts("h1").single() shouldContain HOSTILE[3]
                texts(".graph-title") shouldContainAll HOSTILE.map { it.substringAfterLast('/') }
                elements(".graph").map { it.getDomAttribute("data-name") } shouldContainAll HOSTILE
                texts(".graph-unit") shouldContainAll HOSTILE
                for (name in graphNames) graph(name).scrollTo().hover(0.5)
                if (elements(".problem-list").isEmpty()) click("#problems summary")
                texts(".problem-text").joinToString("\n").let { listed -> HOSTILE.forEach { listed shouldContain it } }
                click("#info summary")
                checkTame()
            }
        }
        step("events and states, in the list, on the graphs and in the bar") {
            val topics = listOf(TIME, BagTopic("State"), BagTopic("A"), BagTopic("Log", attributes = listOf("log")))
            val isText = setOf(1, 3)
            val bag = bagOf(topics, HOSTILE.size + 1) { row, column -> if (column in isText) HOSTILE.getOrElse(row) { "End" } else row }
            onPage(TestPages.of(bag), script = alarm) {
                texts(".event .finding-text") shouldContainAll HOSTILE
                for (row in listOf(0, 3)) {
                    // A state and an event are read from the last sample at or before the cursor.
                    graph("State").scrollTo().hover((row + 0.1) / HOSTILE.size)
                    graph("State").value("State") shouldBe HOSTILE[row]
                    texts(".event-readout").single() shouldContain HOSTILE[row]
                }
                checkTame()
                press("/")
                press(HOSTILE[0])
                checkTame()
            }
        }
        step("the name of the file") {
            val name = "<!--<script>\"><svg onload=alert(1)>a&amp;b.bag"
            onPage(TestPages.of(bagOf(listOf(TIME, BagTopic("A")), 5) { row, _ -> row }, name), script = alarm) {
                driver.title shouldBe name
                texts("h1").single() shouldBe name
                checkTame()
            }
        }
    }
})
