package badlog.page

import badlog.core.analysis.LogView
import badlog.core.recording.Severity
import badlog.expression.withVirtualTopics
import badlog.files.readRecording
import badlog.formats.LOG_FORMATS
import badlog.protocol.PageAdditions
import badlog.rules.BUILT_IN
import badlog.rules.RuleSet
import badlog.rules.RulesFile
import badlog.rules.incident.incidentsIn
import badlog.rules.over
import io.kotest.core.annotation.Tags
import io.kotest.matchers.collections.shouldContainExactlyInAnyOrder
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import org.openqa.selenium.Keys
import java.nio.file.Path

@Tags("InCheck")
internal class RulesSpec : PageSpec({
    val match = "qualification-42.bag"
    val formulas = listOf("PDP/Double = 2 * Total Current")
    val own = RulesFile.parse(
        """
        [aliases]
        both = ["*double*"]
        [[rule]]
        name = "Enabled low"
        severity = "warning"
        when = "battery voltage < 11 and enabled"
        text = "{value} at {time} in {file}, {count} times: {match}"
        [[rule]]
        name = "Double"
        severity = "note"
        when = "max(both) > 100 or count(time) > 3"
        text = "{value}"
        """.trimIndent(),
    ).rules

    fun OpenPage.awaitRules() = await("the rules") { script("return document.documentElement.dataset.rules") == "done" }

    fun OpenPage.findings(): List<String> {
        for (button in elements(".findings-more button")) if (button.isDisplayed && "fewer" !in button.text) button.click()
        settle()
        val listed = texts(".finding .severity").zip(texts(".finding-text")) { severity, text -> "$severity $text" }
        return listed + texts(".incident p > span:not(.finding-whole)")
    }

    fun found(sample: Path, rules: RuleSet): List<String> {
        val view = LogView.of(readRecording(sample, LOG_FORMATS)).withVirtualTopics(formulas).view
        val findings = rules.over(view, sample.fileName.toString()).findings
        val sentences = rules.incidentsIn(findings).flatMap { it.sentences }
        val listed = findings - sentences.map { it.finding }.toSet()
        return listed.map { "${it.severity.name.lowercase()} ${it.rule}${it.text}" } + sentences.map { it.text }
    }

    fun bare(texts: List<String>) = texts.map { it.filterNot(Char::isWhitespace) }

    browserTest("a search is typed while rules run, and their findings are marked, searched, stepped through and visited together with embedded ones") {
        val typed = """
            new MutationObserver((changes, observer) => {
                const box = document.querySelector('#search')
                if (!box || document.documentElement.dataset.state != 'ready') return
                observer.disconnect()
                box.value = 'has:finding'
                box.dispatchEvent(new Event('input'))
                window.typedDuring = document.documentElement.dataset.rules ?? 'running'
            }).observe(document, {attributes: true, childList: true, subtree: true})
        """.trimIndent()
        val embedded = finding("Comparison", Severity.NOTE, "as the last match", 20.0)
        onPage(TestPages.ofSample(match, PageAdditions(rules = RuleSet.BUILT_IN, findings = listOf(embedded))), script = typed) {
            step("a search for findings, typed while the rules run, matches once they are done") {
                awaitRules()
                script("return window.typedDuring") shouldBe "running"
                texts(".search-count").single() shouldContain "graph"
            }
            click("#search")
            press(Keys.ESCAPE)
            script("document.activeElement.blur()")
            step("the rules' findings are marked, searched and stepped through together with embedded ones") {
                awaitRules()
                // The two incidents come first.
                press("n", "n", "n")
                element(".finding[aria-current]").text shouldContain "as the last match"
                press("/")
                press("\"browned out\"")
                texts(".search-count").single() shouldContain "1 finding"
                texts(".incident p").count { "browned out" in it } shouldBe 1
                texts(".finding-source") shouldBe emptyList()
            }
        }
    }

    browserTest("the page's worker finds the same as the JVM, by the built-in rules and by a team's") {
        for (rules in listOf(RuleSet.BUILT_IN, own)) {
            onPage(TestPages.ofSample(match, PageAdditions(formulas, rules))) {
                awaitRules()
                bare(findings()) shouldContainExactlyInAnyOrder bare(found(SAMPLES.resolve(match), rules))
                number("return performance.getEntriesByName('badlog-first-graphs').length") shouldBe 1.0
            }
        }
    }

    browserTest("rules run without workers, and failures are reported with the next step") {
        step("the page itself finds the same without workers") {
            val script = "window.Worker = function () { throw new Error('forbidden') }"
            onPage(TestPages.ofSample(match, PageAdditions(formulas, RuleSet.BUILT_IN)), script = script) {
                awaitRules()
                bare(findings()) shouldContainExactlyInAnyOrder bare(found(SAMPLES.resolve(match), RuleSet.BUILT_IN))
            }
        }
        step("rules that cannot run are reported with the next step") {
            val broken = "const Real = Worker; window.Worker = function (address, options) { if (options?.name !== 'rules') " +
                "return new Real(address, options); const fake = { postMessage() { setTimeout(() => " +
                "fake.onmessage({ data: { failure: 'no room.' } }), 0) }, terminate() {} }; return fake }"
            onPage(TestPages.ofSample(match, PageAdditions(rules = RuleSet.BUILT_IN)), script = broken) {
                await("the failure") { script("return document.documentElement.dataset.rules") == "failed" }
                texts("#findings .problem-text").single() shouldBe
                    "The rules could not be run (no room); reload the page, or run badlog report on the file."
            }
        }
    }

    browserTest("findings are drawn into the existing graphs, which are not replaced") {
        val removals = "window.removed = 0; new MutationObserver(changes => { for (const change of changes) " +
            "for (const node of change.removedNodes) if (node.querySelector?.('canvas')) window.removed++ })" +
            ".observe(document, { childList: true, subtree: true })"
        val rules = RulesFile.parse("[[rule]]\nname = \"High\"\nseverity = \"error\"\nwhen = \"Step 1 > 0.5\"\ntext = \"t\"\n").rules
        onPage(TestPages.of(stepBag(graphs = 2), additions = PageAdditions(rules = rules)), script = removals) {
            awaitRules()
            settle()
            graph("Step 1").picture.rowsOf(color("--error")).takeLast(12).max() shouldBeGreaterThan 20
            number("return window.removed") shouldBe 0.0
        }
    }
})
