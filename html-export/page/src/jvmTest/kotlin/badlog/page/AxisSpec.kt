package badlog.page

import io.kotest.core.annotation.Tags
import io.kotest.matchers.shouldBe

@Tags("InCheck")
internal class AxisSpec : PageSpec({
    /** Runs [action] and waits until the page shows its log again. */
    fun OpenPage.showAgain(action: () -> Unit) {
        script("document.querySelector('.log-page').isOld = true")
        action()
        await("the log to be shown again") { script("return document.querySelector('.log-page')?.isOld ?? null") == null }
        awaitState("ready")
    }

    browserTest("a table without an x axis offers its time column once, and remembers the choice") {
        val csv = "A,timestamp\n" + (0..500).joinToString("") { "${it % 7},${100 + it / 10.0}\n" }
        onPage(TestPages.of(csv, "table.csv")) {
            visibleRange shouldBe 0.0..500.0
            showAgain { click("#axis-time") }
            visibleRange shouldBe 100.0..150.0
            reload()
            visibleRange shouldBe 100.0..150.0
            elements("#axis-time").size shouldBe 0
            showAgain { click("#axis-rows") }
            visibleRange shouldBe 0.0..500.0
            reload()
            elements("#axis-choice").size shouldBe 0
        }
    }
})
