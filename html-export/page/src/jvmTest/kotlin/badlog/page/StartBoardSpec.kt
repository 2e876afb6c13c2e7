package badlog.page

import io.kotest.core.annotation.Tags
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import org.openqa.selenium.Keys

/** Tests the board with which a log begins, and when a change to it takes effect. */
@Tags("InCheck")
internal class StartBoardSpec : PageSpec({
    browserTest("a board keeps the changes of two tabs, and the start board can be restored") {
        onPage(TestPages.of(stepBag(graphs = 3))) {
            step("a board keeps the changes of two tabs, also after this tab's undo, and a graph that this tab cannot draw") {
                val key = "const key = 'badlog:board:test.bag:' + JSON.parse(document.getElementById('about').textContent).inflatedBytes; "
                script(
                    key + "localStorage.setItem(key, arguments[0])",
                    """{"graphs":[{"title":"Step 3","lines":["Step 3"]},{"title":"Twice","lines":["Twice"]}]}""",
                )
                graph("Step 2").scrollTo().hover(0.5)
                press("p")
                texts(".board .graph-title") shouldBe listOf("Step 2")
                click("#undo")
                texts(".board .graph-title") shouldBe emptyList()
                reload()
                texts(".board .graph-title") shouldBe listOf("Step 3")
                // Like another tab that has the same graph.
                val (before, after) = listOf("[\"Step 3\"]", "[\"Step 3\",\"Step 1\"]").map { "\"lines\":$it" }
                script(key + "localStorage.setItem(key, localStorage.getItem(key).replace(arguments[0], arguments[1]))", before, after)
                graph("Step 2").scrollTo().hover(0.5)
                press("p")
                texts(".board .graph-title") shouldBe listOf("Step 3", "Step 2")
                act { keyDown(Keys.CONTROL).sendKeys("z").keyUp(Keys.CONTROL) }
                settle()
                texts(".board .graph-title") shouldBe listOf("Step 3")
                reload()
                texts(".board .graph-title") shouldBe listOf("Step 3")
                texts(".board .legend-name") shouldContain "Step 1"
                script(key + "return localStorage.getItem(key)").toString() shouldContain "Twice"
            }
            startOver()
            step("the start board restores the page's first board, and can be undone like any change") {
                val before = texts(".board .graph-title")
                graph("Step 2").scrollTo().hover(0.5)
                press("p")
                val own = texts(".board .graph-title")
                (own != before) shouldBe true
                click("#start-board")
                texts(".board .graph-title") shouldBe before
                click("#undo")
                texts(".board .graph-title") shouldBe own
            }
        }
    }
})
