package badlog.page

import io.kotest.core.annotation.Tags
import io.kotest.matchers.shouldBe
import io.kotest.matchers.shouldNotBe

@Tags("InCheck")
internal class ThemeSpec : PageSpec({
    browserTest("the page follows the system’s theme until the button selects another") {
        onPage(TestPages.of(stepBag(graphs = 3))) {
            step("the page follows a change of the system's theme, and redraws its graphs in the new colors") {
                val light = graph("Step 1").canvas
                show(Screen.WIDE.copy(isDark = true))
                element("html").getDomAttribute("data-theme") shouldBe "dark"
                graph("Step 1").canvas shouldNotBe light
                graph("Step 1").steepest()
                show(Screen.WIDE)
                graph("Step 1").canvas shouldBe light
            }
            step("the button selects light and dark, also after a reload") {
                click("#theme")
                element("html").getDomAttribute("data-theme") shouldBe "light"
                click("#theme")
                element("html").getDomAttribute("data-theme") shouldBe "dark"
                reload()
                element("html").getDomAttribute("data-theme") shouldBe "dark"
                click("#theme")
                element("html").getDomAttribute("data-theme") shouldBe "light"
            }
        }
    }
})
