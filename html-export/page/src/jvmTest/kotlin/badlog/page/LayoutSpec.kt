package badlog.page

import io.kotest.core.annotation.Tags
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import org.openqa.selenium.Keys

/** Boards that a reader stores under names, and between which a key switches. */
@Tags("InCheck")
internal class LayoutSpec : PageSpec({
    fun OpenPage.titles() = texts("#board .graph-title")

    /** Puts the graph [title] alone on the board, and stores the board as [name]. */
    fun OpenPage.keep(title: String, name: String) {
        if (titles().isNotEmpty()) click("#clear-board")
        graph(title).scrollTo().hover(0.5)
        press("p")
        script("scrollTo(0, 0)")
        click("#layouts")
        press(name, Keys.ENTER)
        settle()
    }

    browserTest("boards are stored by name, shown by a key, and still there after a reload") {
        onPage(TestPages.of(stepBag(graphs = 3))) {
            step("boards are stored by name, a key steps through them, and they are still there when the page is opened again") {
                press("g")
                text shouldContain "No layout is kept yet; keep the board as one with the button “Layouts” above it"
                keep("Step 1", "Power")
                element("#layout-dialog").isDisplayed shouldBe false
                keep("Step 2", "<b>Drive</b>")
                titles() shouldBe listOf("Step 2")
                press("g")
                titles() shouldBe listOf("Step 1")
                press("G")
                titles() shouldBe listOf("Step 2")
                reload()
                press("g")
                titles() shouldBe listOf("Step 2")
                press("g")
                titles() shouldBe listOf("Step 1")
                click("#undo")
                titles() shouldBe listOf("Step 2")
                keepScreenshot("layouts")
            }
        }
    }
})
