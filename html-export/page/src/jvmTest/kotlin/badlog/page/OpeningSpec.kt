package badlog.page

import io.kotest.core.annotation.Tags
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain

@Tags("InCheck")
internal class OpeningSpec : PageSpec({
    browserTest("a match has its values in folders, and each graph is drawn once it is scrolled to") {
        onPage(TestPages.ofSample("qualification-42.bag")) {
            step("values are in their folders, sorted regardless of case, the top level first; Info has the header") {
                texts(".folder[data-name=''] .value-row .value-text") shouldContain "2024-03-16T10:41:07"
                texts(".folder[data-name='System'] .value-row .cut-name") shouldContain "Brownout Voltage"
                texts(".folder[data-name='System'] .value-row .value-text") shouldContain "6.75"
                val names = elements(".folder").map { it.getDomAttribute("data-name").orEmpty() }
                names shouldBe names.sortedBy { it.lowercase() }
                names.first() shouldBe ""
                click("#info summary")
                texts("#info pre").single() shouldContain "\"Mill Creek Regional\""
            }
            step("every graph of a match is drawn once it is scrolled to") {
                for (name in graphNames) {
                    val graph = graph(name).scrollTo()
                    if (graph.card.getDomAttribute("data-kind") == "lines") graph.pixelsOfLine(0) shouldBeGreaterThan 0
                }
            }
        }
    }
})
