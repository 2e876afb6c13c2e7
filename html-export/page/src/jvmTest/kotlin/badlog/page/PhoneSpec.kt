package badlog.page

import badlog.core.analysis.Series
import badlog.core.bag.BagTopic
import badlog.core.recording.Severity
import badlog.protocol.HookPart
import badlog.protocol.PageAdditions
import badlog.protocol.PageSeries
import io.kotest.core.annotation.Tags
import io.kotest.matchers.doubles.plusOrMinus
import io.kotest.matchers.doubles.shouldBeGreaterThan
import io.kotest.matchers.doubles.shouldBeLessThan
import io.kotest.matchers.doubles.shouldBeLessThanOrEqual
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import org.openqa.selenium.interactions.PointerInput
import org.openqa.selenium.interactions.PointerInput.Kind
import org.openqa.selenium.interactions.PointerInput.MouseButton
import org.openqa.selenium.interactions.PointerInput.Origin
import org.openqa.selenium.interactions.Sequence
import java.time.Duration

@Tags("InCheck")
internal class PhoneSpec : PageSpec({
    val page by lazy { TestPages.of(stepBag(graphs = 12)) }

    /** Puts down one finger for each path, moves it along the path, and lifts it. All paths have the same number of points. */
    fun OpenPage.touch(vararg paths: List<Pair<Int, Int>>) {
        val fingers = paths.mapIndexed { index, path ->
            val finger = PointerInput(Kind.TOUCH, "finger $index")
            Sequence(finger, 0).apply {
                path.forEachIndexed { i, (x, y) ->
                    val duration = Duration.ofMillis(if (i == 0) 0 else 20)
                    addAction(finger.createPointerMove(duration, Origin.viewport(), x, y))
                    if (i == 0) addAction(finger.createPointerDown(MouseButton.LEFT.asArg()))
                }
                addAction(finger.createPointerUp(MouseButton.LEFT.asArg()))
            }
        }
        driver.perform(fingers)
        settle()
    }

    fun between(from: Pair<Int, Int>, to: Pair<Int, Int>, steps: Int = 8) = List(steps + 1) { step ->
        from.first + (to.first - from.first) * step / steps to from.second + (to.second - from.second) * step / steps
    }

    browserTest("a match fits a phone, its words are not cut, and a finger finds its buttons") {
        onPage(TestPages.ofSample("qualification-42.bag"), Screen.PHONE) {
            step("a match is no wider than the phone") {
                number("return document.documentElement.scrollWidth") shouldBeLessThanOrEqual 390.0
                number("return innerWidth") shouldBe 390.0
                graph(graphNames.last()).scrollTo()
                number("return document.documentElement.scrollWidth") shouldBeLessThanOrEqual 390.0
            }
            script("scrollTo(0, 0)")
            step("words in the bar are not cut, buttons are large enough for a finger, and the event log is one tap away") {
                for ((selector, text) in listOf(".search-input" to "placeholder", ".folder-choice" to "value")) {
                    number(
                        """
                        const box = document.querySelector(arguments[0]), style = getComputedStyle(box)
                        const text = arguments[1] == 'value' ? box.options[0].text : box.placeholder
                        const context = document.createElement('canvas').getContext('2d')
                        context.font = style.font
                        const arrow = arguments[1] == 'value' ? 16 : 0
                        return box.clientWidth - parseFloat(style.paddingLeft) - parseFloat(style.paddingRight) - arrow -
                            context.measureText(text).width
                        """.trimIndent(),
                        selector,
                        text,
                    ) shouldBeGreaterThan 0.0
                }
                val height = "return document.querySelector(arguments[0]).getBoundingClientRect().height"
                val pressed = listOf("#download", ".folder-toggle", ".search-input", ".legend-entry")
                for (selector in pressed) number(height, selector) shouldBeGreaterThan 23.9
                click(".events-link")
                number("return document.querySelector('.events').getBoundingClientRect().top") shouldBeLessThan 300.0
                number("return document.documentElement.scrollWidth") shouldBeLessThanOrEqual 390.0
            }
        }
    }

    browserTest("fingers scroll, zoom, and set the second cursor") {
        onPage(page, Screen.PHONE) {
            step("a resting finger sets the second cursor, and removes it when it rests there again") {
                // Not by actions of WebDriver, because a list of actions cannot lift a finger that an earlier list put down.
                fun finger(type: String, vararg places: Pair<Int, Int>) = driver.executeCdpCommand("Input.dispatchTouchEvent", mapOf("type" to type, "touchPoints" to places.map { (x, y) -> mapOf("x" to x, "y" to y) }))

                fun rest(share: Double, beside: Int, isSecondShown: Boolean) {
                    val (x, y) = graph("Step 1").scrollTo().frame.at(share)
                    script("keepsTime = true")
                    finger("touchStart", x + beside to y)
                    await("the second cursor to come or go") { elements(".cursor-line.is-second").any { it.isDisplayed } == isSecondShown }
                    finger("touchEnd")
                    script("keepsTime = false")
                    settle()
                }
                val middle = graph("Step 1").scrollTo().frame.at(0.3)
                touch(listOf(middle, middle))
                rest(0.7, beside = 0, isSecondShown = true)
                texts(".second-readout").single() shouldContain "B 6.97"
                rest(0.7, beside = 12, isSecondShown = false)
            }
            step("a vertical swipe over a graph scrolls the page and zooms nothing") {
                val (x, y) = graph("Step 2").scrollTo().frame.at(0.5)
                val before = number("return scrollY")
                touch(between(x to y, x + 3 to y - 250))
                await("the page to scroll") { number("return scrollY") > before + 50 }
                visibleRange shouldBe 0.0..10.0
            }
            step("a finger zooms, or moves a zoomed range; two fingers that move apart zoom in; a double tap shows everything") {
                val frame = graph("Step 1").scrollTo().frame
                touch(between(frame.at(0.2), frame.at(0.6)))
                graph("Step 1").steepest() shouldBe (0.25 plusOrMinus 0.02)
                visibleRange.start shouldBe (2.0 plusOrMinus 0.1)
                touch(between(frame.at(0.25), frame.at(0.5)))
                graph("Step 1").steepest() shouldBe (0.5 plusOrMinus 0.03)
                // Without a zoom, they are hidden.
                for (button in listOf("#reset", "#back")) number("return document.querySelector('$button').offsetHeight") shouldBeGreaterThan 23.9
                click("#reset")
                visibleRange shouldBe 0.0..10.0
                val whole = graph("Step 1").scrollTo().frame
                touch(between(whole.at(0.25), whole.at(0.1)), between(whole.at(0.35), whole.at(0.9)))
                val range = visibleRange
                range.endInclusive - range.start shouldBeLessThan 3.0
                // The step was halfway between the fingers.
                graph("Step 1").steepest() shouldBe (0.5 plusOrMinus 0.06)
                taps(List(2) { whole.at(0.5) }, pause = 0.1)
                visibleRange shouldBe 0.0..10.0
            }
        }
    }

    browserTest("the full bar, long texts and a path fit a phone") {
        step("the full bar takes two rows above the cursor's place, also on a narrow phone") {
            val modules = listOf("Measured", "Setpoints").flatMap { side -> List(4) { "$side[$it]" } }
                .flatMap { listOf(BagTopic("$it/speed", "m/s"), BagTopic("$it/angle/value", "rad")) }
            val topics = listOf(TIME) + modules + BagTopic("Log", attributes = listOf("log"))
            val bag = bagOf(topics, 1200) { row, column -> if (column == topics.lastIndex) "event $row" else row / 50.0 }
            onPage(TestPages.of(bag), Screen.PHONE.copy(width = 360)) {
                for (button in listOf(".events-link", "#add-note", "#values-button", "#modules-button")) element(button).isDisplayed shouldBe true
                number("return document.querySelector('.zoom-row').getBoundingClientRect().height") shouldBeLessThan 110.0
                number("return document.documentElement.scrollWidth") shouldBeLessThanOrEqual 360.0
            }
        }
        step("a tap sets the cursor, and on a finding's mark shows its text; the page is no wider than the phone") {
            val finding = finding("Brownout", Severity.ERROR, "a long text of what was found ".repeat(9), 5.0, Double.NaN)
            val line = PageSeries("Fit", "V", Series(doubleArrayOf(1.0), doubleArrayOf(1.0)))
            val hook = HookPart("a-long-name-of-a-program.py".repeat(4), series = listOf(line))
            val additions = PageAdditions(listOf("Bad = " + "x".repeat(200)), findings = listOf(finding), hooks = listOf(hook))
            onPage(TestPages.of(stepBag(graphs = 2), additions = additions), Screen.PHONE) {
                number("return document.documentElement.scrollWidth") shouldBeLessThanOrEqual 390.0
                val middle = graph("Step 1").scrollTo().frame.at(0.5)
                touch(listOf(middle, middle))
                graph("Step 1").label shouldContain "Brownout"
                graph("Step 1").value("Step 1") shouldBe "1"
                elements(".finding-label").any { it.isDisplayed } shouldBe true
                number("return document.documentElement.scrollWidth") shouldBeLessThanOrEqual 390.0
            }
        }
    }
})
