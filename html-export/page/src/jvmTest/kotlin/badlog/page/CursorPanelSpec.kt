package badlog.page

import badlog.core.bag.BagTopic
import io.kotest.core.annotation.Tags
import io.kotest.matchers.doubles.shouldBeGreaterThan
import io.kotest.matchers.doubles.shouldBeLessThanOrEqual
import io.kotest.matchers.shouldBe
import io.kotest.matchers.shouldNotBe
import org.openqa.selenium.WebElement

/** The panel of values at the cursor. */
@Tags("InCheck")
internal class CursorPanelSpec : PageSpec({
    val page by lazy {
        val topics = listOf(TIME, BagTopic("Still", "V"), BagTopic("Jump", "A"), BagTopic("Mode"), BagTopic("Hidden", "m", listOf("hide")))
        TestPages.of(
            bagOf(topics, 1001) { row, column ->
                when (column) {
                    0 -> row / 100.0
                    1 -> 12
                    2 -> if (row < 300) 1 else 7
                    3 -> if (row < 600) "auto" else "teleop"
                    else -> row
                }
            },
        )
    }

    fun OpenPage.rows() = texts(".cursor-value")
    fun OpenPage.changed() = texts(".cursor-value.is-marked .cut-name")

    browserTest("the values of all graphs at the cursor are listed, pinned and searched, also on a phone") {
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
            step("a search lists the topics that it finds, hidden ones too, and the panel stays open for the next visit") {
                click("#values-button")
                graph("Jump").click(0.5)
                press("/")
                press("hidden")
                rows().single().startsWith("Hidden") shouldBe true
                reload()
                element("#cursor-values").isDisplayed shouldBe true
            }
            click("#values-button")
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

    browserTest("names keep their order of characters, and numbers have six digits, or all under the pointer") {
        step("a name that begins or ends with a sign is read as it is written") {
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
        step("legend, list and statistics show six digits of a number, and all of them where the pointer rests") {
            onPage(TestPages.of(bagOf(listOf(TIME, BagTopic("Seventh")), 11) { row, column -> if (column == 0) row else "${row + 1 / 7.0}" })) {
                press("v")
                graph("Seventh").click(0.4)
                graph("Seventh").value("Seventh") shouldBe "4.14286"
                rows() shouldBe listOf("Seventh4.14286")
                fun titleOver(element: WebElement): String {
                    act { moveToElement(element) }
                    return element.getDomAttribute("title").orEmpty()
                }
                titleOver(graph("Seventh").legend("Seventh")).lines().last() shouldBe "4.142857142857143"
                titleOver(element(".cursor-value .value-text")) shouldBe "4.142857142857143"
                graph("Seventh").click(0.6)
                rows() shouldNotBe listOf("Seventh4.14286")
                element(".cursor-value .value-text").getDomAttribute("title") shouldBe null
                script("arguments[0].querySelector('.statistics-toggle').click()", graph("Seventh").card)
                val maximum = elements(".statistics tbody td")[1]
                maximum.text to maximum.getDomAttribute("title") shouldBe ("10.1429" to "10.142857142857142")
            }
        }
    }
})
