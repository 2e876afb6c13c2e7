package badlog.page

import badlog.core.bag.BagTopic
import io.kotest.core.annotation.Tags
import io.kotest.inspectors.forAll
import io.kotest.matchers.doubles.plusOrMinus
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldStartWith
import org.openqa.selenium.By
import org.openqa.selenium.Keys

private const val ROWS = 4000

/** Each row has a number of its own, so that a value tells which row it was read from. */
@Tags("InCheck")
internal class CursorSpec : PageSpec({
    val page by lazy {
        val topics = listOf(TIME, BagTopic("Row"), BagTopic("Spike", "V"), BagTopic("Mode")) +
            List(8) { BagTopic("More ${it + 1}") }
        TestPages.of(
            bagOf(topics, ROWS) { row, column ->
                when (column) {
                    0, 1 -> row
                    2 -> row % 7
                    3 -> if (row < 1600) "armed" else "ready"
                    else -> row % 1000
                }
            },
        )
    }

    browserTest("one cursor is read in all graphs, pinned, compared with a second one, and its statistics have histograms") {
        onPage(page) {
            step("one cursor stands at the same place in all graphs, also in one scrolled to later") {
                graph("Spike").hover(0.25)
                val row = graph("Row").value("Row")
                fun OpenPage.cursorAt(name: String): Double {
                    val line = graph(name).card.findElement(By.cssSelector(".cursor-line"))
                    line.isDisplayed shouldBe true
                    return number("return arguments[0].getBoundingClientRect().x", line) - graph(name).frame.x
                }
                val expected = graph("Spike").frame.width * 0.25
                listOf("Row", "Spike", "Mode").forAll { cursorAt(it) shouldBe (expected plusOrMinus 1.5) }
                graph("More 8").scrollTo()
                cursorAt("More 8") shouldBe (expected plusOrMinus 1.5)
                graph("More 8").value("More 8").toInt() shouldBe row.toInt() % 1000
            }
            script("scrollTo(0, 0)")
            settle()
            press("0")
            step("a click pins the cursor, which the mouse does not move, until a click on it or Escape") {
                graph("Row").click(0.25)
                val row = graph("Row").value("Row")
                graph("Spike").hover(0.75)
                graph("Row").value("Row") shouldBe row
                graph("Spike").card.findElement(By.cssSelector(".cursor-line.is-pointer")).isDisplayed shouldBe true
                press(Keys.ESCAPE)
                // Values are read under the pointer again, and then nowhere.
                graph("Row").value("Row").toInt() shouldBeGreaterThan row.toInt() + 400
                press(Keys.ESCAPE)
                graph("Row").value("Row") shouldBe ""
                // Sooner, each would be the second click of a double one.
                clicks(List(2) { graph("Row").frame.at(0.25) }, pause = 0.5)
                graph("Row").hover(0.75)
                graph("Row").value("Row").toInt() shouldBeGreaterThan row.toInt() + 400
            }
            step("the histogram of a line is opened from its statistics, and closed again") {
                script("arguments[0].querySelector('.statistics-toggle').click()", graph("Row").card)
                click(".statistics tbody .icon-button")
                val painted = "const c = document.querySelector('.histogram'); const d = c.getContext('2d')" +
                    ".getImageData(0, 0, c.width, c.height).data; return d.reduce((n, v, i) => n + (i % 4 == 3 && v > 0 ? 1 : 0), 0)"
                await("a histogram") { number(painted) > 1000.0 }
                element(".histogram").getAttribute("role") shouldBe "img"
                element(".histogram").getAttribute("aria-label") shouldBe "Histogram of Row"
                keepScreenshot("histogram")
                // The table stays, and the keyboard on its button, also when the statistics are about another range.
                script("document.querySelector('.statistics table').dataset.mark = 'same'")
                click(".statistics tbody .icon-button")
                elements(".histogram").size shouldBe 0
                script("return document.querySelector('.statistics table').dataset.mark") shouldBe "same"
                val isFocused = "return document.activeElement === document.querySelector('.statistics tbody .icon-button')"
                script(isFocused) shouldBe true
                val before = texts(".statistics p").first()
                press("+")
                await("other statistics") { texts(".statistics p").first() != before }
                script(isFocused) shouldBe true
            }
            press("0", Keys.ESCAPE, Keys.ESCAPE)
            script("arguments[0].querySelector('.statistics-toggle').click()", graph("Row").card)
            script("scrollTo(0, 0)")
            step("Shift and a click set a second cursor: values at both, difference, slope, and statistics between them") {
                graph("Row").click(0.25)
                graph("Row").click(0.5, withShift = true)
                val (a, b, change, slope) = Regex("A (.*) · B (.*) · Δ (.*) · (.*) 1/s").matchEntire(graph("Row").value("Row"))!!.destructured
                b.toInt() - a.toInt() shouldBe change.toInt()
                change.toInt() shouldBeGreaterThan ROWS / 5
                slope shouldBe "1"
                script("arguments[0].querySelector('.statistics-toggle').click()", graph("Row").card)
                texts(".statistics p").first() shouldStartWith "Between A and B: "
                texts(".statistics tbody td")[1].toInt() shouldBe b.toInt()
                press("b")
                element(".second-readout").isDisplayed shouldBe false
                graph("Row").value("Row") shouldBe a
                press(Keys.ARROW_RIGHT)
                val first = graph("Row").value("Row").toInt()
                press("b", Keys.ARROW_RIGHT)
                graph("Row").value("Row") shouldBe "A $first · B ${first + 1} · Δ 1 · 1 1/s"
            }
        }
    }
})
