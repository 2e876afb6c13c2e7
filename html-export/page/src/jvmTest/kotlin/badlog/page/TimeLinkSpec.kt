package badlog.page

import io.kotest.core.annotation.Tags
import io.kotest.matchers.ranges.shouldBeIn
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import org.openqa.selenium.Keys
import java.nio.file.Files

@Tags("InCheck")
internal class TimeLinkSpec : PageSpec({
    fun OpenPage.follow(fragment: String) {
        script("location.hash = arguments[0]", fragment)
        settle()
    }

    fun OpenPage.cursor() = texts(".cursor-readout").single()

    browserTest("a link moves the cursor, the view and the focus to a time, and moving the mouse makes no link") {
        val focused = "const e = document.activeElement; return e.className + ' ' + e.closest('.graph')?.dataset.name"
        onPage(TestPages.of(stepBag(graphs = 20))) {
            step("the link stays at the pinned time while the mouse moves over graphs, and the mouse alone makes no link") {
                graph("Step 1").hover(0.2)
                element(".cursor-readout").getDomAttribute("href") shouldBe null
                graph("Step 1").click(0.2)
                val link = element(".cursor-readout").getDomAttribute("href")
                graph("Step 2").hover(0.9)
                element(".cursor-readout").getDomAttribute("href") shouldBe link
                link.orEmpty().removePrefix("#t=").toDouble() shouldBeIn 1.9..2.1
            }
            step("an address with a time moves the cursor there, when the page opens and when it changes; the time links to itself") {
                follow("t=2.5")
                cursor() shouldBe "2.500 s"
                graph("Step 1").value("Step 1") shouldBe "0"
                reload()
                cursor() shouldBe "2.500 s"
                follow("t=7")
                cursor() shouldBe "7.000 s"
                graph("Step 1").value("Step 1") shouldBe "1"
                follow("t=4.5")
                element(".cursor-readout").getDomAttribute("href") shouldBe "#t=4.5"
            }
            step("the view and the page scroll to a time that is out of sight") {
                graph("Step 1").drag(0.0, 0.3)
                script("window.scrollTo(0, 1e6)")
                settle()
                follow("t=9")
                9.0 shouldBeIn visibleRange
                (1..20).any { graph("Step $it").isOnScreen } shouldBe true
            }
            startOver()
            step("a link to a time focuses the first graph on the screen without scrolling") {
                follow("t=2.5")
                script("document.activeElement.blur()")
                reload()
                script(focused) shouldBe "plot Step 1"
                number("return scrollY") shouldBe 0.0
                graph("Step 15").scrollTo()
                val top = number("return scrollY")
                follow("t=7")
                number("return scrollY") shouldBe top
                (graph(script("return document.activeElement.closest('.graph').dataset.name") as String).isOnScreen) shouldBe true
                // The next keys start there, and the place is spoken.
                press(Keys.ARROW_RIGHT)
                texts("#spoken").single() shouldContain "7."
                script("history.replaceState(null, '', location.pathname); scrollTo(0, 0)")
                click("#search")
                script("return document.activeElement.id") shouldBe "search"
                reload()
                script("return document.activeElement.tagName") shouldBe "BODY"
            }
        }
    }

    browserTest("a page in a frame goes to its time without scrolling the page around it") {
        val page = TestPages.of(stepBag(graphs = 20))
        val host = Files.writeString(
            page.resolveSibling("host-of-${page.fileName}"),
            "<!DOCTYPE html><p style='height: 300px'>Above<p><iframe width=900 height=500 src='${page.fileName}#t=9'></iframe>" +
                "<p style='height: 3000px'>Below",
        )
        OpenPage.open(host, Screen.WIDE, null).use {
            it.driver.switchTo().frame(0)
            it.awaitState("ready")
            it.await("the cursor") { it.cursor() == "9.000 s" }
            it.script("scrollTo(0, 1e6)")
            it.settle()
            it.script("location.hash = 't=4'")
            it.await("a graph on the screen") { (1..20).any { step -> it.graph("Step $step").isOnScreen } }
            it.settle()
            it.driver.switchTo().defaultContent()
            it.number("return scrollY") shouldBe 0.0
            it.script("return document.activeElement.tagName") shouldBe "BODY"
        }
    }
})
