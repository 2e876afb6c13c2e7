package badlog.page

import badlog.core.bag.BagTopic
import io.kotest.core.annotation.Tags
import io.kotest.matchers.doubles.shouldBeGreaterThan
import io.kotest.matchers.doubles.shouldBeLessThanOrEqual
import io.kotest.matchers.shouldBe

/** The panel of values at the cursor. */
@Tags("InCheck")
internal class CursorPanelSpec : PageSpec({
    val page by lazy {
        val topics = listOf(TIME, BagTopic("Still", "V"), BagTopic("Jump", "A"), BagTopic("Mode"))
        TestPages.of(
            bagOf(topics, 1001) { row, column ->
                when (column) {
                    0 -> row / 100.0
                    1 -> 12
                    2 -> if (row < 300) 1 else 7
                    else -> if (row < 600) "auto" else "teleop"
                }
            },
        )
    }

    fun OpenPage.rows() = texts(".cursor-value")
    fun OpenPage.changed() = texts(".cursor-value.is-marked .cut-name")

    browserTest("the values of all graphs at the cursor are listed and pinned, also on a phone") {
        onPage(page) {
            step("V opens the values of all graphs at the cursor, what just changed first, and again closes them") {
                element("#cursor-values").isDisplayed shouldBe false
                press("v")
                graph("Jump").click(0.304)
                rows() shouldBe listOf("Jump7 A", "Still12 V", "Modeauto")
                changed() shouldBe listOf("Jump")
                graph("Jump").click(0.604)
                rows().first() shouldBe "Modeteleop"
                graph("Jump").click(0.45)
                rows() shouldBe listOf("Still12 V", "Jump7 A", "Modeauto")
                press("v")
                element("#cursor-values").isDisplayed shouldBe false
            }
            step("the pin of a value puts its topic on the board, and takes it off") {
                press("v")
                // Another place than before: a second click there could be a double click.
                graph("Jump").click(0.55)
                await("the values") { rows() == listOf("Still12 V", "Jump7 A", "Modeauto") }
                fun pin() = elements(".cursor-value .pin")[1]
                pin().click()
                await("its graph") { texts("#board .graph-title") == listOf("Jump") }
                rows().single().startsWith("Jump") shouldBe true
                click(".cursor-value .pin")
                await("no graph") { texts("#board .graph-title").isEmpty() }
            }
            press("v")
            show(Screen.PHONE)
            step("on a phone the values are a sheet over the foot of the page") {
                click("#values-button")
                val box = "const b = document.querySelector('#cursor-values').getBoundingClientRect(); return "
                number(box + "b.bottom") shouldBe 844.0
                number(box + "b.top") shouldBeGreaterThan 400.0
                number("return document.documentElement.scrollWidth") shouldBeLessThanOrEqual 390.0
                keepScreenshot("phone-values")
            }
        }
    }

    browserTest("a name that begins or ends with a sign is read as it is written") {
        onPage(TestPages.of(bagOf(listOf(TIME, BagTopic("/Arm/Angle (raw)")), 11) { row, _ -> row })) {
            press("v")
            graph("/Arm/Angle (raw)").click(0.4)
            val place = "const text = document.querySelector('.cursor-value bdi').firstChild; " +
                "const at = i => { const r = document.createRange(); r.setStart(text, i); " +
                "r.setEnd(text, i + 1); return r.getBoundingClientRect().left }; return "
            number(place + "at(1) - at(0)") shouldBeGreaterThan 0.0
            number(place + "at(15) - at(14)") shouldBeGreaterThan 0.0
        }
    }
})
