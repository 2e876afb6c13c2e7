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

    browserTest("boards are stored by name, shown by a key or in the dialog, removed, and still there after a reload") {
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
            startOver()
            step("the dialog shows a stored board, removes one, and stores none without a name") {
                click("#layouts")
                press("  ", Keys.ENTER)
                element("#layout-dialog").isDisplayed shouldBe true
                press(Keys.ESCAPE)
                script("return Object.keys(localStorage).filter(key => key.includes('layout:')).length") shouldBe 0L
                keep("Step 1", "Power")
                keep("Step 3", "Drive")
                click("#layouts")
                texts("#layout-dialog li") shouldBe listOf("Drive", "Power")
                keepScreenshot("layout-dialog")
                elements("#layout-dialog li button")[2].click()
                settle()
                titles() shouldBe listOf("Step 1")
                click("#layouts")
                elements("#layout-dialog li .icon-button")[0].click()
                texts("#layout-dialog li") shouldBe listOf("Power")
                press(Keys.ESCAPE)
                press("g")
                titles() shouldBe listOf("Step 1")
            }
        }
    }
})
