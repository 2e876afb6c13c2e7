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

    fun OpenPage.awaitRules() = await("the rules") { script("return document.documentElement.dataset.rules") == "done" }

    for (isDark in listOf(false, true)) {
        val colors = if (isDark) "dark" else "light"
        for (screen in listOf(Screen(1366, 768, isDark = isDark), Screen.PHONE.copy(isDark = isDark))) {
            browserTest("axe-core reports nothing serious for a match, ${screen.width} wide, $colors") {
                onPage(match, screen) {
                    awaitRules()
                    seriousForReaders().shouldBeEmpty()
                    press("n")
                    seriousForReaders().shouldBeEmpty()
                    press("?")
                    seriousForReaders().shouldBeEmpty()
                    press(Keys.ESCAPE)
                    press("f")
                    seriousForReaders().shouldBeEmpty()
                }
            }
        }

        browserTest("axe-core reports nothing serious for a log of hundreds of topics, searched or not, $colors") {
            onPage(large, Screen(1366, 768, isDark = isDark)) {
                awaitRules()
                seriousForReaders().shouldBeEmpty()
                press("/")
                press("primitive 3 | camera 7 | speed")
                seriousForReaders().shouldBeEmpty()
            }
        }
    }

    for ((name, page) in listOf("a match" to { match }, "a log of hundreds of topics" to { large })) {
        browserTest("the first Tab leads to a link that skips to the first graph of $name") {
            onPage(page(), Screen(1366, 768)) {
                awaitRules()
                press(Keys.TAB)
                script("return document.activeElement.className") shouldBe "skip"
                press(Keys.ENTER)
                script("return document.activeElement.className") shouldBe "plot"
                script("return document.activeElement.getBoundingClientRect().top < innerHeight") shouldBe true
            }
        }
    }

    browserTest("a large log has few enough tab stops before its first graph") {
        onPage(large, Screen(1366, 768)) {
            awaitRules()
            val stops = number(
                """
                const all = [...document.querySelectorAll('a[href], button, input, select, [tabindex="0"]')].filter(e => e.checkVisibility() && !e.disabled);
                return all.findIndex(e => e.classList.contains('plot'));
                """.trimIndent(),
            )
            stops.toInt() shouldBeLessThanOrEqual 60
        }
    }
})
