package badlog.page

import badlog.core.bag.BagTopic
import io.kotest.assertions.withClue
import io.kotest.core.annotation.Tags
import io.kotest.matchers.doubles.plusOrMinus
import io.kotest.matchers.shouldBe

@Tags("InCheck")
internal class FolderSpec : PageSpec({
    val folders = listOf("Arm", "Drivetrain", "Elevator")
    val page by lazy {
        val topics = listOf(TIME) + folders.flatMap { folder -> List(2) { BagTopic("$folder/Step ${it + 1}") } }
        TestPages.of(
            bagOf(topics, 1001) { row, column ->
                if (column == 0) {
                    row / 100.0
                } else if (row < 300) {
                    0
                } else {
                    1
                }
            },
        )
    }

    fun OpenPage.toggle(folder: String) = click(".folder[data-name='$folder'] .folder-toggle")

    /** Checks that every canvas on the page fills the width of its card. */
    fun OpenPage.checkWidths() {
        for (name in graphNames) {
            val card = graph(name).scrollTo().card
            val room = number("return arguments[0].querySelector('.plot').clientWidth", card)
            withClue("$name on a window of ${number("return innerWidth")}") {
                number("return arguments[0].querySelector('canvas').getBoundingClientRect().width", card) shouldBe
                    (room plusOrMinus 1.0)
            }
        }
    }

    browserTest("folders are closed and opened, remembered, and drawn at any width") {
        onPage(page) {
            step("a closed folder stays closed after a reload, and the others stay open") {
                toggle("Drivetrain")
                graphNames.filter { it.startsWith("Drivetrain") } shouldBe emptyList()
                reload()
                graphNames.map { it.substringBefore('/') }.distinct() shouldBe listOf("Arm", "Elevator")
                element(".folder[data-name='Drivetrain'] .folder-toggle").getDomAttribute("aria-expanded") shouldBe "false"
                toggle("Drivetrain")
                reload()
                graphNames.size shouldBe 6
            }
            step("a folder that another tab closed or opened stays so when this tab closes its own") {
                toggle("Arm")
                // Like another tab that opens one folder and closes one.
                val key = "const key = Object.keys(localStorage).find(k => k.startsWith('badlog:closed:')); "
                script(key + "localStorage[key] = 'Elevator'")
                toggle("Drivetrain")
                script(key + "return localStorage[key]").toString().lines().toSet() shouldBe setOf("Elevator", "Drivetrain")
            }
            step("all folders close and open at once, and the list of folders opens one and leads to it") {
                click("#collapse-all")
                graphNames shouldBe emptyList()
                elements(".folder-link").single { "Elevator" in it.text }.click()
                settle()
                graph("Elevator/Step 1").isOnScreen shouldBe true
                script("scrollTo(0, 0)")
                settle()
                click("#expand-all")
                graphNames.size shouldBe 6
                graph("Elevator/Step 2").scrollTo().steepest() shouldBe (0.3 plusOrMinus 0.01)
            }
            script("scrollTo(0, 0)")
            step("a folder opened after a zoom and at another width is drawn at that width, zoomed") {
                toggle("Elevator")
                graph("Arm/Step 1").scrollTo().drag(0.2, 0.6)
                show(Screen.WIDE.copy(width = 900))
                toggle("Elevator")
                checkWidths()
                graph("Elevator/Step 2").scrollTo().steepest() shouldBe (0.25 plusOrMinus 0.01)
            }
            script("document.querySelector('#reset').click()")
            show(Screen.WIDE)
            step("a window made narrower, then wider, also during loading, leaves no graph at the wrong width") {
                for (width in listOf(700, 1600, 420, 1280)) {
                    show(Screen.WIDE.copy(width = width))
                    checkWidths()
                    graph("Arm/Step 1").scrollTo().steepest() shouldBe (0.3 plusOrMinus 0.01)
                }
                driver.navigate().refresh()
                show(Screen.WIDE.copy(width = 640))
                awaitState("ready")
                show(Screen.WIDE.copy(width = 1000))
                checkWidths()
            }
        }
    }
})
