package badlog.page

import badlog.core.bag.BagTopic
import io.kotest.core.annotation.Tags
import io.kotest.matchers.doubles.shouldBeLessThanOrEqual
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldStartWith
import kotlin.math.PI

/** The panel with the modules of a swerve drive. */
@Tags("InCheck")
internal class ModulesPanelSpec : PageSpec({
    /** Ten seconds of four modules. The second module points 10° aside, and 15° from 3 s to 3.5 s. */
    val page by lazy {
        val names = listOf("Measured", "Setpoints").flatMap { side -> List(4) { "$side[$it]" } }
        val topics = listOf(TIME) + names.flatMap { listOf(BagTopic("$it/speed", "m/s"), BagTopic("$it/angle/value", "rad")) }
        TestPages.of(
            bagOf(topics, 501) { row, column ->
                val time = row / 50.0
                val off = (if (time in 3.0..3.5) 15 else 10).takeIf { column == 4 } ?: 0
                when {
                    column == 0 -> time
                    column % 2 == 1 -> 2
                    else -> time / 5 + off * PI / 180
                }
            },
        )
    }

    fun OpenPage.picture() = script("return document.querySelector('#modules canvas').toDataURL()") as String

    browserTest("the modules are opened by key, button and link, follow cursor and range, and fit a phone") {
        onPage(page) {
            step("W opens the modules with the worst module and a link to its largest error, and the picture follows the cursor") {
                press("w")
                await("the errors") { texts("#modules tbody tr").size == 8 }
                element("#modules .worst").text shouldBe "Module 1 has the largest angle error: 10.3° RMS, the others 0.0°."
                texts("#modules .cut-name") shouldBe List(4) { "Module $it" }
                val before = picture()
                elements("#modules td button")[2].click()
                await("another picture") { picture() != before }
                element(".cursor-readout").text shouldStartWith "3.00"
                keepScreenshot("modules")
                press("w")
                element("#modules").isDisplayed shouldBe false
            }
            step("moving the cursor does not change the list, a resized picture is redrawn, and links open the modules") {
                script("location.hash = '#open=modules'")
                await("the errors") { texts("#modules tbody tr").size == 8 }
                element("#modules").isDisplayed shouldBe true
                element("#modules canvas").getAttribute("role") shouldBe "img"
                element("#modules canvas").getAttribute("aria-label") shouldBe "Modules at the cursor"
                script("document.querySelector('#modules tbody tr').dataset.mark = 'same'")
                val before = picture()
                graph("Measured[0]/speed").click(0.7)
                await("another picture") { picture() != before }
                script("return document.querySelector('#modules tbody tr').dataset.mark") shouldBe "same"
                script("document.querySelector('#modules').style.width = '240px'")
                val isWhole = "return Number(document.querySelector('#modules canvas').clientWidth < 240 && " +
                    "Math.abs(document.querySelector('#modules canvas').width / devicePixelRatio - document.querySelector('#modules canvas').clientWidth) < 1)"
                await("the picture in its new size") { script(isWhole) == 1L }
            }
            script("document.querySelector('#modules').style.width = ''")
            press("w")
            show(Screen.PHONE)
            step("on a phone the modules are a sheet over the foot of the page") {
                click("#modules-button")
                number("return document.querySelector('#modules').getBoundingClientRect().bottom") shouldBe 844.0
                number("return document.documentElement.scrollWidth") shouldBeLessThanOrEqual 390.0
                keepScreenshot("phone-modules")
            }
        }
    }
})
