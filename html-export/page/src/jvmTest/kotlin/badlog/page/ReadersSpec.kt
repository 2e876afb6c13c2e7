package badlog.page

import badlog.formats.wpilog.largeLog
import badlog.protocol.PageAdditions
import badlog.rules.BUILT_IN
import badlog.rules.RuleSet
import io.kotest.core.annotation.Tags
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.ints.shouldBeLessThanOrEqual
import io.kotest.matchers.shouldBe
import org.openqa.selenium.Keys

/** The needs of readers with a screen reader, with weak color vision, or without a mouse. */
@Tags("InCheck")
internal class ReadersSpec : PageSpec({
    val match by lazy { TestPages.ofSample("qualification-42.bag", PageAdditions(listOf("Power = Battery Voltage * Total Current"), RuleSet.BUILT_IN)) }
    val large by lazy { TestPages.of(largeLog(), "large.wpilog", PageAdditions(rules = RuleSet.BUILT_IN)) }

    fun OpenPage.skipToGraph() {
        press(Keys.TAB)
        script("return document.activeElement.className") shouldBe "skip"
        press(Keys.ENTER)
        script("return document.activeElement.className") shouldBe "plot"
        script("return document.activeElement.getBoundingClientRect().top < innerHeight") shouldBe true
    }

    browserTest("axe-core reports nothing serious for a match, wide and light, and on a dark phone; the first Tab leads to a link to its graphs") {
        onPage(match, Screen(1366, 768)) {
            skipToGraph()
            for (screen in listOf(Screen(1366, 768), Screen.PHONE.copy(isDark = true))) {
                step("${screen.width} wide, dark: ${screen.isDark}") {
                    show(screen)
                    press("n")
                    seriousForReaders().shouldBeEmpty()
                    press("?")
                    seriousForReaders().shouldBeEmpty()
                    press(Keys.ESCAPE)
                    press("f")
                    seriousForReaders().shouldBeEmpty()
                    press(Keys.ESCAPE)
                }
            }
        }
    }

    browserTest("a log of hundreds of topics has few tab stops before its graphs, draws what is listed, and axe-core reports nothing serious, searched or not") {
        onPage(large, Screen(1366, 768)) {
            val stops = number(
                """
                const all = [...document.querySelectorAll('a[href], button, input, select, [tabindex="0"]')].filter(e => e.checkVisibility() && !e.disabled);
                return all.findIndex(e => e.classList.contains('plot'));
                """.trimIndent(),
            )
            stops.toInt() shouldBeLessThanOrEqual 60
            skipToGraph()
            seriousForReaders().shouldBeEmpty()
            step("listed and constant topics are drawn by a click, and their pins add them to the board") {
                graphNames.size shouldBeLessThanOrEqual 60
                val before = elements("#board .graph").size
                val name = checkNotNull(elements(".listed-graph[data-name]").first().getDomAttribute("data-name"))
                click(".listed-row .pin")
                elements("#board .graph").last().getDomAttribute("data-name") shouldBe name
                click("#constants .folder-toggle")
                click("#constants tr .pin")
                elements("#board .graph").size shouldBe before + 2
                val drawn = graphNames
                script("document.querySelector('.listed-row').scrollIntoView({block: 'center', behavior: 'instant'})")
                settle()
                click(".listed-graph[data-name]")
                graphNames.size shouldBe drawn.size + 1
            }
            press("/")
            press("primitive 3 | camera 7 | speed")
            show(Screen(1366, 768, isDark = true))
            seriousForReaders().shouldBeEmpty()
        }
    }
})
