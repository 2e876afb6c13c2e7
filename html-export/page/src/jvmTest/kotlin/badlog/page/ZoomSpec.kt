package badlog.page

import io.kotest.core.annotation.Tags
import io.kotest.inspectors.forAll
import io.kotest.matchers.collections.shouldHaveSize
import io.kotest.matchers.doubles.plusOrMinus
import io.kotest.matchers.doubles.shouldBeGreaterThan
import io.kotest.matchers.doubles.shouldBeLessThan
import io.kotest.matchers.shouldBe
import io.kotest.matchers.shouldNotBe
import org.openqa.selenium.Keys
import org.openqa.selenium.interactions.WheelInput.ScrollOrigin

/** Zooming. Every graph steps at 3 s of 10 s, so the position of the step shows which part of x a canvas shows. */
@Tags("InCheck")
internal class ZoomSpec : PageSpec({
    val page by lazy { TestPages.of(stepBag(graphs = 12)) }
    val exactness = 0.01

    fun OpenPage.stepsOnScreen() = graphNames.map { graph(it) }.filter { it.isOnScreen }.map { it.steepest() }

    /** Shows the whole log again, from its top. */
    fun OpenPage.showAll() {
        script("document.querySelector('#reset').click(); scrollTo(0, 0)")
        settle()
    }

    browserTest("a person zooms by drags, wheel, keys and overview, and undoes each") {
        onPage(page) {
            step("zooms can be undone one by one, or reset") {
                element("#back").isEnabled shouldBe false
                element("#reset").isEnabled shouldBe false
                graph("Step 1").drag(0.2, 0.6)
                val first = visibleRange
                graph("Step 1").drag(0.1, 0.5)
                val second = visibleRange
                click("#back")
                visibleRange shouldBe first
                graph("Step 1").steepest() shouldBe (0.25 plusOrMinus exactness)
                click("#back")
                visibleRange shouldBe 0.0..10.0
                graph("Step 1").drag(0.1, 0.5)
                click("#reset")
                visibleRange shouldBe 0.0..10.0
                element("#reset").isEnabled shouldBe false
                second shouldNotBe first
            }
            showAll()
            step("a drag over a graph zooms all graphs on the screen to its range, up to the graph's edge if it ends beyond it") {
                stepsOnScreen().forAll { it shouldBe (0.3 plusOrMinus exactness) }
                graph("Step 2").drag(0.2, 0.6)
                stepsOnScreen().forAll { it shouldBe (0.25 plusOrMinus exactness) }
                visibleRange.start shouldBe (2.0 plusOrMinus 0.05)
                visibleRange.endInclusive shouldBe (6.0 plusOrMinus 0.05)
                click("#reset")
                graph("Step 1").drag(0.2, 1.02)
                visibleRange.endInclusive shouldBe (10.0 plusOrMinus 0.001)
                graph("Step 1").steepest() shouldBe (0.125 plusOrMinus exactness)
            }
            showAll()
            step("double-clicking shows everything again, in all graphs") {
                val before = graph("Step 1").canvas
                graph("Step 1").drag(0.2, 0.6)
                graph("Step 1").canvas shouldNotBe before
                graph("Step 2").doubleClick()
                graph("Step 1").canvas shouldBe before
                stepsOnScreen().forAll { it shouldBe (0.3 plusOrMinus exactness) }
                visibleRange shouldBe 0.0..10.0
            }
            showAll()
            step("the overview zooms by a drag, moves the visible range, and follows a click") {
                val strip = element(".overview").rect
                val y = strip.y + strip.height / 2
                fun x(seconds: Double) = strip.x + (strip.width * seconds / 10).toInt()
                act { mouseTo(x(2.0), y).mouseDown().mouseTo(x(4.0), y).mouseTo(x(6.0), y).mouseUp() }
                graph("Step 1").steepest() shouldBe (0.25 plusOrMinus exactness)
                act { mouseTo(x(4.0), y).mouseDown().mouseTo(x(3.5), y).mouseTo(x(3.0), y).mouseUp() }
                graph("Step 1").steepest() shouldBe (0.5 plusOrMinus exactness)
                act { mouseTo(x(8.0), y).mouseDown().mouseUp() }
                visibleRange.start shouldBe (6.0 plusOrMinus 0.05)
            }
            showAll()
            step("Ctrl and the wheel zoom around the pointer without scrolling; the wheel alone only scrolls the page") {
                val (x, y) = graph("Step 1").frame.at(0.3)
                act { keyDown(Keys.CONTROL).scrollFromOrigin(ScrollOrigin.fromViewport(x, y), 0, -120).keyUp(Keys.CONTROL) }
                val width = visibleRange.endInclusive - visibleRange.start
                width shouldBeLessThan 9.0
                graph("Step 1").steepest() shouldBe (0.3 plusOrMinus exactness)
                act { keyDown(Keys.CONTROL).scrollFromOrigin(ScrollOrigin.fromViewport(x, y), 0, 60).keyUp(Keys.CONTROL) }
                visibleRange.endInclusive - visibleRange.start shouldBeGreaterThan width
                number("return scrollY") shouldBe 0.0
                val zoomed = visibleRange
                act { scrollFromOrigin(ScrollOrigin.fromViewport(x, y), 0, 300) }
                await("the page to scroll") { number("return scrollY") > 0 }
                visibleRange shouldBe zoomed
            }
            showAll()
            step("Escape cancels a drag, and nothing else") {
                click("#search")
                press("step")
                script("document.activeElement.blur()")
                val (x, y) = graph("Step 1").frame.at(0.2)
                act { mouseTo(x, y).mouseDown().mouseTo(x + 200, y).sendKeys(Keys.ESCAPE).mouseTo(x + 210, y).mouseUp() }
                visibleRange shouldBe 0.0..10.0
                element(".selection").isDisplayed shouldBe false
                element("#search").getDomProperty("value") shouldBe "step"
            }
            click("#search")
            press(Keys.ESCAPE)
            step("a zoom draws the numbers below the graphs once for each of their widths") {
                script("document.querySelectorAll('.folders .pin')[0].click()")
                settle()
                script(
                    """
                    window.drawn = []
                    const original = CanvasRenderingContext2D.prototype.fillText
                    CanvasRenderingContext2D.prototype.fillText = function (text, x, y) {
                        if (!this.canvas.isConnected) drawn.push(this.canvas.width + ': ' + text)
                        original.call(this, text, x, y)
                    }
                    """.trimIndent(),
                )
                graph("Step 2").drag(0.2, 0.6)
                val drawn = script("return drawn") as List<*>
                drawn shouldBe drawn.distinct()
                drawn.map { it.toString().substringBefore(':') }.distinct() shouldHaveSize 2
            }
        }
    }
})
