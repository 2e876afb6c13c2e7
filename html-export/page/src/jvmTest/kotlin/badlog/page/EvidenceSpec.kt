package badlog.page

import badlog.core.analysis.Span
import badlog.core.bag.BagTopic
import badlog.core.recording.Severity
import badlog.protocol.PageAdditions
import badlog.rules.BUILT_IN
import badlog.rules.RuleSet
import badlog.rules.RulesFile
import io.kotest.assertions.withClue
import io.kotest.core.annotation.Tags
import io.kotest.matchers.doubles.plusOrMinus
import io.kotest.matchers.doubles.shouldBeLessThan
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldStartWith
import org.openqa.selenium.By
import org.openqa.selenium.Keys
import kotlin.math.abs

/** From a finding to its reason: all evidence is on one screen. */
@Tags("InCheck")
internal class EvidenceSpec : PageSpec({
    fun OpenPage.cursor() = texts(".cursor-readout").single().substringBefore(' ').toDouble()

    /** Returns the names of the graphs that are fully on the screen below the bar, with their lines. */
    fun OpenPage.inSight(): String = script(
        """
        const top = document.querySelector('.zoom-bar').getBoundingClientRect().bottom
        return [...document.querySelectorAll('#evidence .graph')].filter(graph => {
            const box = graph.querySelector('canvas')?.getBoundingClientRect()
            return box && box.height > 30 && box.top >= top && box.bottom <= innerHeight
        }).map(graph => [graph.dataset.name, ...[...graph.querySelectorAll('[data-series]')].map(line => line.dataset.series)].join()).join('\n')
        """.trimIndent(),
    ) as String

    /** Returns the number of graphs that are not fully on the screen below the bar. */
    fun OpenPage.outOfSight() = elements("#evidence .graph").size - inSight().lines().count { it.isNotEmpty() }

    val match by lazy { TestPages.ofSample("qualification-42.bag", PageAdditions(rules = RuleSet.BUILT_IN)) }

    browserTest("evidence is one click, key or link away, and on one screen") {
        val focused = "const e = document.activeElement; return (e.closest('.incident, .finding')?.className ?? '') + '|' + " +
            "(e.closest('p, .finding')?.textContent ?? e.id)"
        onPage(match) {
            step("N opens a whole incident, with more graphs one click away; it can be closed, and a link to its time opens it again") {
                press("n")
                val sentences = texts("#evidence .evidence-text").filter { it.isNotEmpty() }
                sentences.first() shouldContain "Likely cause"
                texts(".incident p").first() shouldContain sentences.first()
                texts("#evidence .severity") shouldBe texts(".incident .severity").take(1)
                texts("#spoken").single() shouldContain " s: error: ${sentences.first()}"
                press(Keys.ARROW_RIGHT)
                texts("#spoken").single() shouldContain " V"
                val before = elements("#evidence .graph").size
                val offers = elements(".evidence-offers button")
                withClue(offers.map { it.text }) { offers.isEmpty() shouldBe false }
                offers.first().click()
                settle()
                elements("#evidence .graph").size shouldBe before + 1
                click("#close-evidence")
                element("#evidence").isDisplayed shouldBe false
                elements("#evidence .graph").size shouldBe 0
                val time = 93.709649
                script("location.hash = '#t=' + arguments[0]", time)
                await("the evidence at that moment") { element("#evidence").isDisplayed && abs(cursor() - time) < 0.01 }
            }
            click("#close-evidence")
            press("0")
            step("the reason for the brownout in Qualification 42 is one click away on each screen") {
                for (screen in listOf(Screen(1366, 768), Screen.PHONE)) {
                    show(screen)
                    elements(".incident p").first { "browned out" in it.text }.findElement(By.cssSelector("button")).click()
                    await("four graphs in sight") { elements("#evidence .graph").size == 4 && outOfSight() == 0 }
                    keepScreenshot("evidence-${screen.width}")
                    cursor() shouldBe (93.7 plusOrMinus 0.1)
                    (93.7 in visibleRange) shouldBe true
                    visibleRange.endInclusive - visibleRange.start shouldBeLessThan 20.0
                    for (name in listOf("Battery Voltage", "Total Current", "Left Output", "Right Output")) inSight() shouldContain name
                    element("#evidence .evidence-text").text shouldStartWith "The roboRIO browned out at 93.7"
                    element("#evidence .incident-next").text shouldStartWith "Next: "
                    element(".incident[aria-current]").text shouldContain "browned out"
                }
            }
            show(Screen.WIDE)
            press("0")
            step("a link to a finding focuses its row once the rules have found it, unless the reader has moved the focus") {
                elements(".incident p").first { "browned out" in it.text }.findElement(By.cssSelector("button")).click()
                settle()
                script("Object.defineProperty(navigator, 'clipboard', {value: {writeText: async text => { window.copied = text }}})")
                click("#copy-link")
                val link = "#" + (script("return window.copied") as String).substringAfter('#')
                link shouldContain "&finding="
                script("location.hash = arguments[0]; document.activeElement.blur()", link)
                reload()
                script(focused) as String shouldContain "browned out"
                script(focused) as String shouldStartWith "incident|"
                // The evidence is on the screen, so focusing it scrolls nothing.
                await("the evidence in sight") { outOfSight() == 0 }
                press(Keys.ENTER)
                cursor() shouldBe (93.7 plusOrMinus 0.1)
                // A reader who began a search while the rules ran can continue it.
                val begun = "document.addEventListener('DOMContentLoaded', () => " +
                    "new MutationObserver(() => document.querySelector('#search')?.focus()).observe(document.documentElement, {attributes: true, attributeFilter: ['data-state']}))"
                runFirst(begun)
                reload()
                script(focused) shouldBe "|search"
            }
        }
    }

    val rules = RulesFile.parse(
        """
        [[rule]]
        name = "Low"
        severity = "error"
        when = "Voltage < 7"
        text = "Down to {value} at {time} ({count}×)."
        next = "Look at the battery."
        [[rule]]
        name = "Worse"
        severity = "error"
        when = "Voltage < 2"
        text = "Much too low."
        """.trimIndent(),
    ).rules

    // Low at 5, 15, 25, … s, each time with a different voltage.
    val bag by lazy {
        bagOf(listOf(TIME, BagTopic("Voltage", "V"), BagTopic("Other", "A")), 4001) { row, column ->
            val time = row / 10.0
            when (column) {
                0 -> time
                1 -> if (row % 100 in 50..52) 1.0 + row / 100 % 5 else 12.0
                else -> row % 7
            }
        }
    }

    browserTest("evidence belongs to the visited one of two findings and to its place, and needs no topics") {
        step("a link and N select the right one of two findings that begin together, and its address names it") {
            val both = listOf(
                finding("First", Severity.ERROR, "first of two", 3.0),
                finding("Second", Severity.WARNING, "second of two", 3.0),
            )
            onPage(TestPages.of(stepBag(graphs = 1), additions = PageAdditions(findings = both))) {
                fun sentence() = texts("#evidence .evidence-text").first()
                fun address() = element(".cursor-readout").getDomAttribute("href")
                script("location.hash = '#t=3'")
                settle()
                sentence() shouldBe "first of two"
                script("location.hash = '#t=3&finding=Second'")
                await("the sentence of the other") { sentence() == "second of two" }
                // The bar above is updated a frame later.
                settle()
                address() shouldBe "#t=3&finding=Second"
                texts(".event-readout").single() shouldContain "second of two"
                click("#close-evidence")
                pressShift("n")
                settle()
                sentence() shouldBe "first of two"
                address() shouldBe "#t=3&finding=First"
                script("location.hash = '#t=3&finding=Gone;Topic'")
                settle()
                sentence() shouldBe "first of two"
            }
        }
        step("each place of a finding has its own text and numbers, not those of a worse place nearby") {
            onPage(TestPages.of(bag, additions = PageAdditions(rules = rules))) {
                elements(".finding").first { "Low" in it.text }.findElement(By.cssSelector("button")).click()
                settle()
                texts("#evidence .evidence-text").first() shouldBe "Down to 1 V at 5 s."
                texts("#evidence .evidence-steps .unit").single() shouldBe "1 of 40"
                click("#evidence .evidence-next")
                texts("#evidence .evidence-text").first() shouldBe "Down to 2 V at 15 s."
                texts("#evidence .evidence-steps .unit").single() shouldBe "2 of 40"
                cursor() shouldBe (15.0 plusOrMinus 0.01)
                repeat(4) { click("#evidence .evidence-next") }
                texts("#evidence .evidence-text").first() shouldBe "Down to 1 V at 55 s."
                texts(".event-readout").single() shouldContain "Low: Down to 1 V at 55 s."
                texts("#evidence .incident-next").single() shouldBe "Next: Look at the battery."
            }
        }
        step("a finding without topics in the log has its sentence and no graphs") {
            val findings = listOf(finding("Hook", Severity.ERROR, "as it said", 3.0, further = listOf(Span(8.0, 9.0))))
            onPage(TestPages.of(stepBag(graphs = 1), additions = PageAdditions(findings = findings))) {
                press("n")
                texts("#evidence .evidence-text").first() shouldBe "as it said"
                elements("#evidence .graph").size shouldBe 0
                texts("#evidence .evidence-steps .unit").single() shouldBe "1 of 2"
            }
        }
    }
})
