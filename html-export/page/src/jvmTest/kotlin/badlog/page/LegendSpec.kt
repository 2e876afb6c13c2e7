package badlog.page

import badlog.core.bag.BagTopic
import io.kotest.core.annotation.Tags
import io.kotest.matchers.doubles.shouldBeGreaterThan
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.shouldBe
import org.openqa.selenium.Keys

@Tags("InCheck")
internal class LegendSpec : PageSpec({
    val long = listOf("one", "two").map { "/Arm ${"of many letters ".repeat(30)}$it" }

    val page by lazy {
        val joined = listOf("hide", "join:Arm/Both")
        val topics = listOf(TIME, BagTopic("Arm/Low", "V", joined), BagTopic("Arm/High", "V", joined), BagTopic("Step")) +
            long.map { BagTopic(it, "V", listOf("hide", "join:Both")) }
        TestPages.of(
            bagOf(topics, 1001) { row, column ->
                when (column) {
                    0 -> row / 100.0
                    1 -> row % 100 / 100.0
                    2 -> 10 + row % 100 / 10.0
                    else -> if (row < 300) 0 else 1
                }
            },
        )
    }

    browserTest("lines are hidden and shown by their names, which screen readers get with the value") {
        onPage(page) {
            step("a click on a line's name removes exactly its pixels, another restores them, and the keyboard does the same") {
                val graph = graph("Arm/Both").scrollTo()
                val shown = graph.canvas
                graph.pixelsOfLine(0) shouldBeGreaterThan 500
                graph.pixelsOfLine(1) shouldBeGreaterThan 500
                graph.legend("Low").click()
                settle()
                graph.pixelsOfLine(0) shouldBe 0
                graph.pixelsOfLine(1) shouldBeGreaterThan 500
                graph.legend("Low").getDomAttribute("aria-pressed") shouldBe "false"
                graph.legend("Low").click()
                settle()
                graph.canvas shouldBe shown
                script("arguments[0].focus()", graph.legend("High"))
                press(Keys.SPACE)
                graph.pixelsOfLine(1) shouldBe 0
                press(Keys.ENTER)
                graph.pixelsOfLine(1) shouldBeGreaterThan 500
            }
            step("screen readers get a line's name and its value at the cursor, even if the title already has the name") {
                graph("Step").scrollTo().hover(0.9)
                graph("Step").legend("Step").accessibleName shouldBe "Step 1"
                graph("Arm/Both").scrollTo().hover(0.5)
                graph("Arm/Both").legend("High").accessibleName shouldBe "High " + graph("Arm/Both").value("High")
            }
            step("a long name loses its beginning, and a slash there stays in front") {
                graph("Both").scrollTo()
                for (end in listOf("one", "two")) {
                    val letters = "const name = [...document.querySelectorAll('.graph[data-name=\"Both\"] .legend-name')].find(e => e.textContent.endsWith('$end')); " +
                        "const box = name.getBoundingClientRect(); const text = name.firstChild.firstChild; const at = i => { const r = document.createRange(); " +
                        "r.setStart(text, i); r.setEnd(text, i + 1); return r.getBoundingClientRect() }; return "
                    number(letters + "box.right + 1 - at(text.length - 1).right") shouldBeGreaterThan 0.0
                    number(letters + "box.left - at(0).left") shouldBeGreaterThan 0.0
                    number(letters + "at(1).left - at(0).left") shouldBeGreaterThan 0.0
                }
            }
        }
    }
})
